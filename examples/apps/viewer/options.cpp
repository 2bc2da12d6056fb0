// SPDX-License-Identifier: MIT
#include "options.h"

#include <algorithm>
#include <cmath>

#include "command/values.h"

namespace viewer {
namespace {

using namespace command;

const Name<bool> kSwitch[] = {{"on", true}, {"off", false}};

/// The sides that options of a side change.
struct Sides {
  State& state;
  bool only_b = false;

  template <class Change>
  void change(Change change) {
    if (!only_b) change(state.side[0]);
    change(state.side[1]);
  }
};

/// A number that `set` stores in each side.
template <class Set>
Values side_number(Sides& sides, float initial, float low, float high, Set set) {
  Values values = number(initial, low, high);
  values.read = [&sides, low, high, set](const std::string& text) {
    float x = 0;
    if (!number(x, low, high).read(text)) return false;
    sides.change([&](Side& side) { set(side, x); });
    return true;
  };
  return values;
}

/// One of the words, whose value `set` stores in each side.
template <size_t N, class Set>
Values side_choice(Sides& sides, const Choices<N>& choices, Set set) {
  std::vector<Name<int>> table;
  for (const Choice& choice : choices) table.push_back({choice.word, choice.value});
  int unused = -1;
  Values values = named(unused, table);
  values.read = [&sides, table, set](const std::string& text) {
    int value = 0;
    if (!named(value, table).read(text)) return false;
    sides.change([&](Side& side) { set(side, value); });
    return true;
  };
  return values;
}

/// A coefficient of the surface, which replaces those of the file.
Values coefficient(Sides& sides, float Surface::*member, float high) {
  return side_number(sides, Surface().*member, 0, high, [member](Side& side, float x) {
    side.surface.*member = x;
    side.surface.from_file = false;
  });
}

Values color_values(Sides& sides) {
  const auto read = [&sides](const std::string& text) {
    const auto rgb = read_numbers(text);
    if (!rgb || rgb->size() != 3) return false;
    sides.change([&](Side& side) {
      std::copy(rgb->begin(), rgb->end(), side.surface.color.begin());
      side.surface.from_file = false;
    });
    return std::all_of(rgb->begin(), rgb->end(), [](float c) { return c >= 0.0f && c <= 1.0f; });
  };
  return {"R,G,B, each 0..1", {}, "", read};
}

/// Numbers between commas, each in low..high; `set` stores them, and returns false for numbers that do not fit.
template <class Set>
Values list_values(const std::string& wanted, float low, float high, Set set) {
  const auto read = [low, high, set](const std::string& text) {
    const auto list = read_numbers(text);
    return list && std::all_of(list->begin(), list->end(), [=](float x) { return x >= low && x <= high; }) &&
           set(*list);
  };
  return {wanted, {}, "", read};
}

template <class Set>
Values pixel_values(Set set) {
  return list_values("X,Y, each 0..16383", 0, 16383, [set](const std::vector<float>& xy) {
    const bool whole = xy.size() == 2 && xy[0] == std::floor(xy[0]) && xy[1] == std::floor(xy[1]);
    if (whole) set(Pixel{static_cast<uint32_t>(xy[0]), static_cast<uint32_t>(xy[1])});
    return whole;
  });
}

Group scene_options(Options& out) {
  Content& content = out.state.content;
  Lighting& light = out.state.lighting;
  const auto direction = [&light](const std::vector<float>& angles) {
    if (angles.size() != 2) return false;
    light.azimuth = angles[0], light.elevation = angles[1];
    return true;
  };
  return {
      "Scene",
      {{"--model", "M", file(content.model),
        "A teapot, sphere, box, torus, plane, or a file (glTF, OBJ, PLY, FBX ...)."},
       {"--texture", "T", file(content.texture), "The texture default, porcelain, tiles or none, or an image file."},
       {"--floor", "S", named(content.floor, kSwitch), "A floor under the model."},
       {"--occlusion", "S", named(content.occlusion, kSwitch), "Ambient occlusion at the vertices."},
       {"--light", "AZ,EL", list_values("two angles -360..360 degrees", -360, 360, direction),
        "Direction to the light."},
       {"--intensity", "X", number(light.intensity, 0, 1000), "Intensity of the light."},
       {"--ambient", "X", number(light.ambient, 0, 1000), "Ambient light."},
       {"--shadows", "S", named(light.shadows, kSwitch), "Shadows."},
       {"--environment", "E", file(light.environment),
        "The environment studio or none, or an image of latitude and longitude."},
       {"--environment-intensity", "X", number(light.environment_intensity, 0, 1000), "Factor of the environment."}}};
}

Group camera_options(Orbit& orbit) {
  const auto place = [&orbit](const std::vector<float>& list) {
    if (list.size() < 2 || list.size() > 3 || std::abs(list[1]) > 89.0f) return false;
    orbit.azimuth = list[0], orbit.elevation = list[1];
    if (list.size() > 2) orbit.distance = list[2];
    return list.size() == 2 || (list[2] >= 0.05f && list[2] <= 60.0f);
  };
  const auto target = [&orbit](const std::vector<float>& list) {
    if (list.size() != 3) return false;
    std::copy(list.begin(), list.end(), orbit.shift.begin());
    return true;
  };
  const char* wanted = "an azimuth, an elevation -89..89 in degrees, and a distance 0.05..60";
  return {"Camera",
          {{"--orbit", "AZ,EL[,D]", list_values(wanted, -360, 360, place),
            "Direction to the eye, and its distance in radii of the model."},
           {"--target", "X,Y,Z", list_values("three numbers -50..50", -50, 50, target),
            "Shift of the point of interest in radii."},
           {"--fov", "DEGREES", number(orbit.fov, 5, 120, " degrees"), "Vertical field of view."}}};
}

Group side_options(State& state, Sides& sides) {
  const auto begin_b = [&sides](const std::string&) { return sides.state.wipe = sides.only_b = true; };
  constexpr Choices<2> kSamples = {{{"1", "", 1}, {"4", "", 4}}};
  const auto surface = [](Side& side, int model) {
    side.surface.model = static_cast<shd_model>(model);
    side.surface.from_file = false;
  };
  return {
      "Sides: options behind --b change side B alone",
      {{"--filter", "F",
        side_choice(sides, kFilters, [](Side& s, int v) { s.sampling.filter = static_cast<shd_filter>(v); }),
        "Filter of textures."},
       {"--anisotropy", "N", side_number(sides, 16, 1, 64, [](Side& s, float x) { s.sampling.max_anisotropy = x; }),
        "Largest ratio of the anisotropic filters."},
       {"--lod-bias", "X", side_number(sides, 0, -15, 15, [](Side& s, float x) { s.sampling.lod_bias = x; }),
        "Added to the level of detail."},
       {"--precision", "P",
        side_choice(sides, kPrecisions, [](Side& s, int v) { s.sampling.precision = static_cast<shd_precision>(v); }),
        "Precision of filters."},
       {"--profile", "P",
        side_choice(sides, kProfiles, [](Side& s, int v) { s.sampling.profile = static_cast<shd_profile>(v); }),
        "Rules of the lookups."},
       {"--surface", "S", side_choice(sides, kModels, surface), "Model of reflectance."},
       {"--color", "R,G,B", color_values(sides), "Colour that multiplies the texture."},
       {"--roughness", "X", coefficient(sides, &Surface::roughness, 1), "Roughness."},
       {"--metallic", "X", coefficient(sides, &Surface::metallic, 1), "Metallic factor."},
       {"--clearcoat", "X", coefficient(sides, &Surface::clearcoat, 1), "Clear coat."},
       {"--specular", "X", coefficient(sides, &Surface::specular, 1), "Strength of the highlight."},
       {"--exponent", "X", coefficient(sides, &Surface::exponent, 1000), "Sharpness of the highlight."},
       {"--show", "V", side_choice(sides, kShows, [](Side& s, int v) { s.show = static_cast<Show>(v); }),
        "Value to show."},
       {"--samples", "N", side_choice(sides, kSamples, [](Side& s, int v) { s.samples = static_cast<uint32_t>(v); }),
        "Samples of a pixel."},
       {"--b", "", {"", {}, "", begin_b}, "Begin the options of side B, and turn the wipe on."},
       {"--wipe", "X", marked(number(state.divider, 0, 1), state.wipe),
        "Place of the divider, as a part of the width."}}};
}

Group window_options(Options& out) {
  const auto view = [&out](const std::string& text) {
    const size_t slash = text.find('/');
    out.state.display = Display();
    if (slash != std::string::npos) out.state.display = {text.substr(0, slash), text.substr(slash + 1)};
    return text == "plain" || slash != std::string::npos;
  };
  const auto window = [&out](const std::string& text) {
    const std::vector<std::string> sides = split(text, 'x');
    return sides.size() == 2 && number(out.width, 64, 8192).read(sides[0]) &&
           number(out.height, 64, 8192).read(sides[1]);
  };
  const Name<bool> kTabs[] = {{"settings", false}, {"pixel", true}};
  const auto click = [&out](Pixel pixel) { out.state.pick = pixel, out.pixel_tab = true; };
  const auto magnify = [&out](Pixel pixel) { out.magnify = pixel; };
  return {
      "Window",
      {{"--view",
        "V",
        {"plain, or a display and a view as in sRGB/Plain", {}, "plain", view},
        "Display of libshd_color, and its view."},
       {"--size", "WxH", {"WIDTHxHEIGHT, each 64..8192", {}, "1280x800", window}, "Size of the window."},
       {"--scale", "X", initially(number(out.scale, 0.5, 4), "that of the screen"), "Size of texts."},
       {"--font", "FILE", file(out.font), "Font of texts."},
       {"--panel", "TAB", named(out.pixel_tab, kTabs), "Tab of the panel."},
       {"--click", "X,Y", pixel_values(click), "Explain the lookup of this pixel."},
       {"--magnify", "X,Y", pixel_values(magnify), "Magnify the pixels around this one."},
       {"--screenshot", "FILE", file(out.screenshot), "Write the window as PNG, and end."},
       {"--frames", "N", number(out.frames, 1, 1000), "Frames of the window before the screenshot."},
       {"--picture", "FILE", file(out.picture), "Write the viewport as PNG without a window, and end."},
       {"--threads", "N", initially(number(out.threads, 0, 1024), "one for each core"), "Workers of the library."}}};
}

}  // namespace

bool read_options(int argc, const char* const* argv, Options& out) {
  Sides sides = {out.state};
  const Program program = {
      "shd-viewer",
      "show a model and explain its texture lookups",
      "[options] [MODEL]",
      "Shows a model and explains its texture lookups. MODEL is a file, as --model.",
      {scene_options(out), camera_options(out.state.orbit), side_options(out.state, sides), window_options(out)},
      {}};
  std::vector<std::string> files;
  if (!parse(program, argc, argv, files)) return false;
  if (!files.empty()) out.state.content.model = files.back();
  return true;
}

}  // namespace viewer
