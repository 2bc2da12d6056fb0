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
/// - the tangent of a group is a sum over its triangles. A term is the direction of growing u, projected into the plane
///   of the normal, normalised and multiplied by the corner's angle in that plane. The handedness is the sign;
/// - triangles without uv area add nothing; they take the sign of the first group that reaches them;
/// - corners without a group get the first group at their vertex, or the fallback. Their triangles have two corners at
///   one position, a non-finite position, or a sign that no group accepts.
/// Differences from the generator: there are no quadrilaterals; there is no angular threshold, so that no group is
/// split (the generator's default of 180 degrees takes a triangle out of a corner's sum if the cosine between their
/// directions rounds to -1); fallback_tangent() replaces (1, 0, 0). If the corners of a vertex get different tangents,
/// the vertex keeps the first one, and one copy per further tangent is appended, in order of vertices. The counts go to
/// info.tangentless_count and info.split_count. Throws std::bad_alloc. |error| of a component <= 2e-7 against the exact
/// sum unless the directions nearly cancel.
void compute_tangents(const core::Allocator& allocator, Mesh* mesh);

/// A unit vector perpendicular to n: the x axis projected into its plane, or the y axis if n is within 26 degrees of x.
data::Vec3d fallback_tangent(data::Vec3d n);

}  // namespace shd::geometry
