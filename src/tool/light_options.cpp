// SPDX-License-Identifier: MIT
#include "command/names.h"
#include "tool/option_groups.h"

using namespace command;

namespace {

const Name<LightPreset> kPresets[] = {{"studio", LightPreset::kStudio},
                                      {"headlight", LightPreset::kHeadlight},
                                      {"course", LightPreset::kCourse},
                                      {"file", LightPreset::kFile},
                                      {"none", LightPreset::kNone}};

/// Reads X,Y,Z or X,Y,Z:R,G,B.
bool read_light(const std::string& text, shd_light_kind kind, LightOption& out) {
  const size_t colon = std::min(text.find(':'), text.size());
  const auto place = read_numbers(text.substr(0, colon));
  const auto color = colon < text.size() ? read_numbers(text.substr(colon + 1)) : std::vector<float>{1, 1, 1};
  if (!place || place->size() != 3 || !color || color->size() != 3) return false;
  out.kind = kind;
  std::copy(place->begin(), place->end(), out.place.begin());
  std::copy(color->begin(), color->end(), out.color.begin());
  const bool is_color = std::all_of(color->begin(), color->end(), [](float c) { return c >= 0.0f && c <= 1e9f; });
  return is_color && (kind == SHD_LIGHT_KIND_POINT || out.place != std::array<float, 3>{0, 0, 0});
}

Option light_option(const char* name, Options& out, shd_light_kind kind, const char* text) {
  const auto read = [&out, kind](const std::string& value) {
    return read_light(value, kind, out.lights.emplace_back());
  };
  const char* wanted = "X,Y,Z or X,Y,Z:R,G,B (colour not negative; a direction is not 0,0,0)";
  return {name, "X,Y,Z[:R,G,B]", {wanted, {}, "", read}, text};
}

Values cone_values(Options& out) {
  const auto read = [&out](const std::string& text) {
    const auto angles = read_numbers(text);
    if (!angles || angles->size() != 2) return false;
    out.inner_cone = (*angles)[0];
    out.cone = (*angles)[1];
    return out.inner_cone >= 0 && out.inner_cone <= out.cone && out.cone >= 1 && out.cone <= 85;
  };
  return {"INNER,OUTER in degrees, 0..85, the outer one not smaller and at least 1", {}, "15,25", read};
}

Values exposure_values(float& out) {
  const auto read = [&out](const std::string& text) {
    const bool fits = number(out, -20, 20).read(text);
    out = std::exp2(out);
    return fits;
  };
  return {"a number -20..20", {}, "0", read};
}

}  // namespace

Group light_options(Options& out) {
  return {
      "Light",
      {{"--lights", "PRESET", initially(named(out.preset, kPresets), "studio, or none when lights are given"),
        "Lights around the model. Course is two points, file the lights of the model."},
       light_option(
           "--light", out, SHD_LIGHT_KIND_POINT,
           "A point light in radii of the model around its centre, with its colour at one radius. Repeatable."),
       light_option("--sun", out, SHD_LIGHT_KIND_DIRECTIONAL, "Light from this direction. Repeatable."),
       light_option("--spot", out, SHD_LIGHT_KIND_SPOT,
                    "A spot light at this place, as of --light, that shines at the centre. Repeatable."),
       {"--cone", "INNER,OUTER", cone_values(out), "Half angles of spots."},
       {"--cookie", "FILE", file(out.cookie), "A texture that spots project, or window, which is built in."},
       {"--shadows", "FILTER", initially(named(out.shadows, names_of(shd_shadow_filter_name)), "no shadows"),
        "Shadows of all lights except lamps and ambient light."},
       {"--softness", "S", number(out.softness, 0, 10),
        "How wide summed-area filters are, and how large lights are to pcss, in radii."},
       {"--shadow-size", "N", number(out.shadow_size, 16, 8192), "Texels per side of each shadow map."},
       {"--occlusion", "RAYS", number(out.occlusion, 1, 65536),
        "Ambient occlusion at the vertices, with so many rays each: the model hides a part of the ambient light and of "
        "the environment from itself and from the floor. Replaces the model's occlusion textures."},
       {"--occlusion-radius", "R", initially(number(out.occlusion_radius, 1e-6, 1e6), "unlimited"),
        "Length of these rays in radii."},
       {"--lamps", "N", number(out.lamps, 0, 65536), "Small coloured lights around the model."},
       {"--exposure", "EV", exposure_values(out.exposure), "All lights but the ambient one times 2^EV."},
       {"--ambient", "R,G,B", initially(color_values(out.ambient), "0.15, with an environment 0"), "Ambient light."}}};
}

Group environment_options(Options& out) {
  return {
      "Environment",
      {{"--environment", "FILE", file(out.environment),
        "Light from all directions, and the background: an image in scene-linear radiance, or a cube map. Replaces the "
        "preset of --lights."},
       {"--environment-projection", "P",
        initially(named(out.environment_projection, names_of(shd_projection_name, {SHD_PROJECTION_NONE})),
                  "that of its shape"),
        "Projection of that image. Lat-long is latitude and longitude; cube is a strip or a cross of six faces."},
       {"--environment-turn", "DEGREES", number(out.environment_turn, -360, 360, " degrees"),
        "The environment turned about the vertical."},
       {"--environment-blur", "R", number(out.environment_blur, 0, 1),
        "Roughness of the reflection of the environment that is the background. 0 is sharp."}}};
}
