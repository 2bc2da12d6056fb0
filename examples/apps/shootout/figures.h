// SPDX-License-Identifier: MIT
#pragma once

#include "measure.h"

namespace shootout {

/// A figure of a course on texture mapping.
struct Figure {
  std::string name, title;
  Picture picture;
};

/// Names and titles, in the order of a lecture.
struct FigureName {
  const char *name, *title;
};
const std::vector<FigureName>& figure_names();
/// Makes one figure; fails for an unknown name.
Figure make_figure(const std::string& name, uint32_t edge);

/// A colour for a level of detail: blends from level to level, or the colour of the nearest one.
void level_colour(double level, bool nearest, float rgb[3]);
/// The levels of detail of a workload as colours.
Picture level_picture(const Workload& workload, uint32_t texture_edge, shd_profile profile, bool nearest);

}  // namespace shootout
