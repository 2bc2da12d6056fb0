// SPDX-License-Identifier: MIT
#include "data/trig.h"
#include "shapes/grid.h"
#include "shapes/shapes.h"

namespace shd::shapes {
namespace {

/// A vertex in the direction n.
void add_vertex_at(Sink& out, double radius, const Vec3d& n, double u, double v) {
  add_vertex(out, radius * n, n, u, v);
}

/// One vertex for each triangle at a pole, with u in the middle of the triangle.
void add_pole(Sink& out, double radius, uint32_t around, double y, double v) {
  for (uint32_t i = 0; i < around; ++i) add_vertex_at(out, radius, {0.0, y, 0.0}, (i + 0.5) / around, v);
}

}  // namespace

Counts count_sphere(const shd_shape_desc& desc) {
  const uint64_t around = desc.segments[0], down = desc.segments[1];
  return {2 * around + (down - 1) * (around + 1), 2 * around * (down - 1)};
}

void fill_sphere(const shd_shape_desc& desc, Sink& out) {
  const uint32_t around = desc.segments[0], down = desc.segments[1];
  const auto radius = static_cast<double>(desc.radius);
  add_pole(out, radius, around, 1.0, 0.0);
  for (uint32_t j = 1; j < down; ++j) {
    const data::CirclePoint latitude = data::circle_point(j, 2 * down);
    for (uint32_t i = 0; i <= around; ++i) {
      const data::CirclePoint turn = data::circle_point(i, around);  // from -Z, where u = 0
      const Vec3d n = {0.0 - latitude.sine * turn.sine, latitude.cosine, 0.0 - latitude.sine * turn.cosine};
      add_vertex_at(out, radius, n, static_cast<double>(i) / around, static_cast<double>(j) / down);
    }
  }
  add_pole(out, radius, around, -1.0, 1.0);

  const uint32_t first = around, last = first + (down - 2) * (around + 1), south = last + around + 1;
  for (uint32_t i = 0; i < around; ++i) add_triangle(out, i, first + i, first + i + 1);
  add_grid(out, first, down - 2, around);
  for (uint32_t i = 0; i < around; ++i) add_triangle(out, last + i, south + i, last + i + 1);
}

}  // namespace shd::shapes
