// SPDX-License-Identifier: MIT
#include "raster/triangle_setup.h"

#include <cstdlib>

namespace shd::raster {

bool set_up(const geometry::ScreenTriangle& triangle, const CoverArea& area, const DepthState& state,
            const geometry::PixelBox& box, TriangleSetup* out) {
  out->is_narrow = true;
  for (int k = 0; k < 3; ++k) {
    EdgeLine& line = out->line[k];
    line = make_edge_line(triangle, k, area.left, area.top);
    const EdgeSide side = side_of(line, area.pattern.extent);
    if (side == EdgeSide::kOutside) return false;
    if (side == EdgeSide::kInside) line = {0, 0, 0};
    out->is_narrow &= std::abs(line.a) <= kNarrowStep && std::abs(line.b) <= kNarrowStep;
  }
  out->pattern = &area.pattern;
  out->slope = make_depth_slope(triangle, state);
  out->box = box;
  out->left = area.left;
  out->top = area.top;
  return true;
}

}  // namespace shd::raster
