// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "scene/limits.h"
#include "scene/read/positions.h"

namespace shd::scene {

/// Twice the area of a polygon times its normal (Newell's method; Sutherland, Sproull and Schumacker 1974, appendix).
/// corners: at least three, counter-clockwise as seen from the front.
Point newell_normal(const std::vector<Point>& corners);

/// Appends the triangles of a polygon to `out`, as corners of the polygon, with its winding. A triangle stays, and a
/// convex quadrilateral is divided from its first corner. Others lose one ear after another (Meisters, "Polygons have
/// ears", 1975), so that concave polygons and holes that a bridge joins to the border are covered exactly. A polygon
/// that intersects itself has no right triangles; its remaining corners become a fan. Throws Failure after the
/// deadline.
void triangulate(const std::vector<Point>& corners, const Deadline& deadline,
                 std::vector<std::array<uint32_t, 3>>& out);

}  // namespace shd::scene
