// SPDX-License-Identifier: MIT
#pragma once

#include "polygon/coordinates.h"

namespace shd::polygon {

/// Triangles of a polygon, counter-clockwise, without further vertices.
struct Triangulation {
  uint32_t count;
  uint32_t corner[kMaxPolygon][3];
};

/// Triangulates a polygon without flaws: ears first, then flips of diagonals until the triangulation is a constrained
/// Delaunay triangulation. Returns false if rounding leaves no ear.
bool triangulate(const Polygon& polygon, Triangulation* out);

}  // namespace shd::polygon
