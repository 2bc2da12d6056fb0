// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "geometry/vertex.h"

namespace shd::geometry {

/// Largest number of vertices of a triangle clipped by every plane. Exact arithmetic leaves at most 3 + 7 vertices.
/// Rounding may make a polygon slightly concave in its last bits; a plane through the dents adds at most half as many
/// vertices as there are: 3, 4, 6, 9, 13, 19, 28, 42.
constexpr int kMaxClipped = 42;

/// Clips a triangle at W >= kMinW, 0 <= Z <= W and the guard band, and snaps the rest to the pixel grid. Vertices
/// inside keep their ScreenVertex. A new vertex depends on its edge alone, not on the triangle, so that neighbours
/// which share a clipped edge still meet. Sutherland and Hodgman, "Reentrant Polygon Clipping" (1974).
/// @param row     the three vertices
/// @param out     [kMaxClipped], in the triangle's winding
/// @return number of vertices, 0 if nothing is left, otherwise 3..kMaxClipped
int clip_triangle(const Vertices& vertices, const uint32_t row[3], ScreenVertex* out);

/// Clips the segment between two vertices in the same way; the rest runs from out[0] to out[1].
/// @return whether anything is left
bool clip_segment(const Vertices& vertices, uint32_t first, uint32_t second, ScreenVertex out[2]);

}  // namespace shd::geometry
