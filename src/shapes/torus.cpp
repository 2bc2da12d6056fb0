// SPDX-License-Identifier: MIT
#include "data/trig.h"
#include "shapes/grid.h"
#include "shapes/shapes.h"

namespace shd::shapes {

Counts count_torus(const shd_shape_desc& desc) {
  const uint64_t around = desc.segments[0], tube = desc.segments[1];
  return {(around + 1) * (tube + 1), 2 * around * tube};
}

void fill_torus(const shd_shape_desc& desc, Sink& out) {
  const uint32_t around = desc.segments[0], tube = desc.segments[1];
  const auto radius = static_cast<double>(desc.radius), tube_radius = static_cast<double>(desc.tube_radius);
  for (uint32_t j = 0; j <= tube; ++j) {
    // From the inside over the top: where the tube's angle is 0, its normal points to the axis.
    const data::CirclePoint section = data::circle_point(j, tube);
    const double outwards = 0.0 - section.cosine, away = radius + tube_radius * outwards;
    for (uint32_t i = 0; i <= around; ++i) {
      const data::CirclePoint turn = data::circle_point(i, around);
      const double x = 0.0 - turn.sine, z = 0.0 - turn.cosine;
      add_vertex(out, {away * x, tube_radius * section.sine, away * z}, {outwards * x, section.sine, outwards * z},
                 static_cast<double>(i) / around, static_cast<double>(j) / tube);
    }
  }
  add_grid(out, 0, tube, around);
}

}  // namespace shd::shapes
