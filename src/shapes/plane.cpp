// SPDX-License-Identifier: MIT
#include "shapes/grid.h"
#include "shapes/shapes.h"

namespace shd::shapes {

Counts count_plane(const shd_shape_desc& desc) {
  const uint64_t columns = desc.segments[0], rows = desc.segments[2];
  return {(columns + 1) * (rows + 1), 2 * columns * rows};
}

void fill_plane(const shd_shape_desc& desc, Sink& out) {
  const uint32_t columns = desc.segments[0], rows = desc.segments[2];
  const auto width = static_cast<double>(desc.size[0]), depth = static_cast<double>(desc.size[2]);
  for (uint32_t j = 0; j <= rows; ++j) {
    for (uint32_t i = 0; i <= columns; ++i) {
      add_vertex(out, {along(width, i, columns), 0.0, along(depth, j, rows)}, {0.0, 1.0, 0.0},
                 static_cast<double>(i) / columns, static_cast<double>(j) / rows);
    }
  }
  add_grid(out, 0, rows, columns);
}

}  // namespace shd::shapes
