// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/allocator.h"
#include "data/vec3.h"
#include "geometry/mesh.h"

namespace shd::geometry {

/// Fills tx, ty, tz, tw of a mesh whose other columns and indices are set, after Mikkelsen, "Simulation of Wrinkled
/// Surfaces Revisited" (2008), and the rules of his published generator, for (u, 1 - v):
/// - vertices of equal position, normal and uv are one;
/// - corners around such a vertex form a group while their triangles share edges, run in opposite directions along
///   them, and have uv areas of the same sign;
/// - a group's tangent is the sum of its triangles' directions of growing u, each laid into the plane of the normal and
///   made unit, times the corner's angle in that plane; its handedness is the sign;
/// - triangles without uv area add nothing; they take the sign of the first group that reaches them;
/// - corners without a group (of triangles with two corners in one place or a position that is not finite, or that no
///   group could take) get the first group at their vertex, or the fallback.
/// Not kept of the generator: quadrilaterals, the threshold of angles (180 degrees, all of a group), and (1, 0, 0)
/// where this has the fallback. A vertex whose corners get tangents that differ gives the first of them to itself, and
/// one to each copy of its that is added at the end, in order of vertices. Counts go to info.tangentless_count and
/// info.split_count. Throws std::bad_alloc. |error| of a component <= 2e-7 against the exact sum unless the directions
/// nearly cancel.
void compute_tangents(const core::Allocator& allocator, Mesh* mesh);

/// A unit vector perpendicular to n: the x axis laid into its plane, or the y axis where n is within 26 degrees of x.
data::Vec3d fallback_tangent(data::Vec3d n);

}  // namespace shd::geometry
