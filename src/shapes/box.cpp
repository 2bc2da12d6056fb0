// SPDX-License-Identifier: MIT
#include "data/box_sides.h"
#include "shapes/grid.h"
#include "shapes/shapes.h"

namespace shd::shapes {
namespace {

using data::BoxSide;
using data::Direction;

double& component(Vec3d& v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

double place(const shd_shape_desc& desc, const Direction& direction, uint32_t i) {
  const uint32_t n = desc.segments[direction.axis];
  return along(static_cast<double>(desc.size[direction.axis]), direction.backwards ? n - i : i, n);
}

void add_side(const shd_shape_desc& desc, const BoxSide& side, Sink& out) {
  const uint32_t columns = desc.segments[side.right.axis], rows = desc.segments[side.down.axis], first = out.vertex;
  Vec3d normal = {0.0, 0.0, 0.0}, position = {};
  component(normal, side.normal.axis) = side.normal.backwards ? -1.0 : 1.0;
  component(position, side.normal.axis) = place(desc, side.normal, desc.segments[side.normal.axis]);
  for (uint32_t j = 0; j <= rows; ++j) {
    component(position, side.down.axis) = place(desc, side.down, j);
    for (uint32_t i = 0; i <= columns; ++i) {
      component(position, side.right.axis) = place(desc, side.right, i);
      add_vertex(out, position, normal, static_cast<double>(i) / columns, static_cast<double>(j) / rows);
    }
  }
  add_grid(out, first, rows, columns);
}

}  // namespace

Counts count_box(const shd_shape_desc& desc) {
  const uint64_t x = desc.segments[0], y = desc.segments[1], z = desc.segments[2];
  return {2 * ((x + 1) * (y + 1) + (y + 1) * (z + 1) + (z + 1) * (x + 1)), 4 * (x * y + y * z + z * x)};
}

void fill_box(const shd_shape_desc& desc, Sink& out) {
  for (const BoxSide& side : data::kBoxSides) add_side(desc, side, out);
}

}  // namespace shd::shapes
