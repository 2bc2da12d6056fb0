// SPDX-License-Identifier: MIT
/// @file
/// Cuts a polygon on the plane of a face of the cube into the parts that the faces show. A plane is seen from the centre
/// of the cube, so that lines stay lines. Points are (2 u - 1, 2 v - 1).
#pragma once

#include "texture/domain/plane_pieces.h"

namespace shd::texture {

/// Returns the part of a polygon on the plane of face `from` whose directions lie on face `to`, as a polygon on face
/// `to`. It has at most four corners more, and is counter-clockwise if the polygon is.
inline Polygon part_on_face(const Polygon& polygon, uint32_t from, uint32_t to) {
  // Outwards, right and down on each face: 1 is x, -1 is -x, 2 is y, 3 is z.
  constexpr int kAxes[6][3] = {{1, -3, -2}, {-1, 3, -2}, {2, 1, 3}, {-2, 1, -3}, {3, 1, -2}, {-3, -1, -2}};
  const auto product = [](int a, int b) { return a == b ? 1.0 : a == -b ? -1.0 : 0.0; };
  const auto along = [&](int axis) {
    const auto& plane = kAxes[from];
    return Coordinate{product(axis, plane[0]), product(axis, plane[1]), product(axis, plane[2])};
  };
  const Coordinate out = along(kAxes[to][0]), across = along(kAxes[to][1]), down = along(kAxes[to][2]);
  Polygon part = polygon;
  for (const Coordinate& side : {across, down}) {
    part = cut(part, {out.middle + side.middle, out.a + side.a, out.b + side.b}, 0, 1);
    part = cut(part, {out.middle - side.middle, out.a - side.a, out.b - side.b}, 0, 1);
  }
  for (size_t i = 0; i < part.count; ++i) {
    const Vec2 p = part.corner[i];
    part.corner[i] = {across.at(p) / out.at(p), down.at(p) / out.at(p)};
  }
  return part;
}

}  // namespace shd::texture
