// SPDX-License-Identifier: MIT
#pragma once

#include "texture/domain/plane_pieces.h"

namespace shd::texture {

/// Returns the part of a polygon on the plane of face `from` of a cube that lies on face `to`, as seen from the centre
/// of the cube: lines stay lines, and the order of the corners stays. Corners are points of the lattices of texel
/// centres of both faces, which have 2 `half` texels along an edge.
inline Polygon part_on_face(const Polygon& polygon, double half, uint32_t from, uint32_t to) {
  // Outwards, right and down on each face: 1 is x, -1 is -x, 2 is y, 3 is z.
  constexpr int kAxes[6][3] = {{1, -3, -2}, {-1, 3, -2}, {2, 1, 3}, {-2, 1, -3}, {3, 1, -2}, {-3, -1, -2}};
  const double middle = half - 0.5;
  const auto along = [&](int axis) {
    const auto part = [&](int k) { return axis == kAxes[from][k] ? 1.0 : axis == -kAxes[from][k] ? -1.0 : 0.0; };
    return Coordinate{part(0) * half - (part(1) + part(2)) * middle, part(1), part(2)};
  };
  const Coordinate out = along(kAxes[to][0]), across = along(kAxes[to][1]), down = along(kAxes[to][2]);
  Polygon part = polygon;
  for (const Coordinate& side : {across, down}) {
    part = cut(part, {out.middle + side.middle, out.a + side.a, out.b + side.b}, 0, 1);
    part = cut(part, {out.middle - side.middle, out.a - side.a, out.b - side.b}, 0, 1);
  }
  for (size_t i = 0; i < part.count; ++i) {
    const Vec2 p = part.corner[i];
    part.corner[i] = {across.at(p) / out.at(p) * half + middle, down.at(p) / out.at(p) * half + middle};
  }
  return part;
}

}  // namespace shd::texture
