// SPDX-License-Identifier: MIT
#pragma once

#include <shd/edges.h>
#include <shd/view.h>

#include "geometry/mesh.h"

namespace shd::geometry {

/// Selection of the edges of a mesh that are drawn as lines, after Gooch, Gooch, Shirley and Cohen, "A
/// Non-Photorealistic Lighting Model for Automatic Technical Illustration" (1998), 4.1.
struct EdgeQuery {
  uint32_t kinds;  // shd_edge bits
  double crease_cosine;
  double eye[4];  // object space, homogeneous; any length and either sign
};

/// Selected kinds of the three edges of a triangle; 0 for edges owned by another triangle. The mesh must have
/// adjacency.
/// An edge is a silhouette where the eye is in front of one of its triangles and behind the other; an eye in the plane
/// of a triangle counts as both. The side of a triangle is always computed at its own first corner, so that all three
/// edges agree and silhouettes never end.
void find_edge_kinds(const Mesh& mesh, const EdgeQuery& query, size_t triangle, uint32_t kinds[3]);

/// The centre of projection of a view in object space: the eye, or without perspective the direction to it. Computed in
/// double, up to length and sign; 0 if there is no such point or more than one.
void centre_of_projection(const shd_view& view, const float object_to_world[16], double out[4]);

}  // namespace shd::geometry
