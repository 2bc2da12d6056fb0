// SPDX-License-Identifier: MIT
#include "command/values.h"
#include "tool/option_groups.h"

using namespace command;

namespace {

const Name<Show> kShows[] = {{"none", Show::kNone},
                             {"normal", Show::kNormal},
                             {"uv", Show::kUv},
                             {"barycentrics", Show::kBarycentrics},
                             {"depth", Show::kDepth},
                             {"position", Show::kPosition},
                             {"overdraw", Show::kOverdraw},
                             {"level", Show::kLevel},
                             {"level-nearest", Show::kLevelNearest},
                             {"tangents", Show::kTangents},
                             {"footprint", Show::kFootprint},
                             {"uv-layout", Show::kUvLayout},
                             {"terms", Show::kTerms}};

Values zoom_values(ZoomOption& out) {
  const auto read = [&out](const std::string& text) {
    const std::vector<std::string> parts = split(text, ',');
    return parts.size() == 3 && read_number(parts[0], out.x) && read_number(parts[1], out.y) &&
           read_number(parts[2], out.size) && out.size >= 1;
  };
  return {"X,Y,N: a pixel of the picture, and how many pixels in a row", {}, "", read};
}

}  // namespace

bool shows_data(Show show) {
  return show >= Show::kNormal && show <= Show::kLevelNearest;
}

bool is_composed(const Options& options) {
  return options.show >= Show::kDepth || options.zoom.size > 0;
}

bool has_terms(shd_model model) {
  return model <= SHD_MODEL_BLINN_PHONG || model == SHD_MODEL_PHONG || model == SHD_MODEL_BLINN_PHONG_NORMALIZED ||
         model == SHD_MODEL_COMBINED || model == SHD_MODEL_TOON;
}

Group show_options(Options& out) {
  return {
      "Insight",
      {{"--show", "V", named(out.show, kShows),
        "Values instead of light. Depth is bright where it is near; overdraw counts the fragments of a pixel, hidden "
        "or "
        "not; level is the continuous level of detail of the texture, and level-nearest the mip level next to it, both "
        "with a colour for each level; position is red along x, green along y and blue along z. These values and "
        "normal, uv and barycentrics are saved without the display transform. Over the picture, tangents draws the "
        "axes of tangent space, red along u, green against v and blue along the normal, and footprint draws the pixel "
        "in texture space as an ellipse, its u to the right and its v down, from green for a circle to red for "
        "an axis 16 times the other one. Uv-layout is the triangles in texture space. Terms is the ambient, the "
        "diffuse "
        "and the specular light and their sum, side by side."},
       {"--show-step", "PX", initially(number(out.show_step, 4, 4096, " pixels"), "32"),
        "The distance of the axes of tangents and of the ellipses of footprint."},
       {"--zoom", "X,Y,N", zoom_values(out.zoom),
        "Enlarge N x N pixels around this one by a whole factor, as large as --size allows. Dots are the samples: "
        "filled where they show the model, whose edges are drawn."},
       {"--compare", "A:B", text(out.compare),
        "Pictures side by side, each with options of its own: \"filter=nearest:filter=ewa,samples=16\". Two or more; "
        "an option without a value is its name; nothing is the rest of the command line alone."},
       {"--difference", "", flag(out.difference),
        "Also the absolute difference of the two pictures of --compare, amplified by a power of two."}}};
}
