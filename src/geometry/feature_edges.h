// SPDX-License-Identifier: MIT
#pragma once

#include <shd/edges.h>
#include <shd/view.h>

#include "geometry/mesh.h"

namespace shd::geometry {

/// Which edges of a mesh are lines of its drawing, after Gooch, Gooch, Shirley and Cohen, "A Non-Photorealistic
/// Lighting Model for Automatic Technical Illustration" (1998), 4.1.
struct EdgeQuery {
  uint32_t kinds;  // shd_edge bits
  double crease_cosine;
  double eye[4];  // object space, homogeneous: of any length and either sign
};

/// Kinds of the three edges of a triangle that are asked for; 0 for edges told to another triangle. The mesh knows what
/// lies across its edges. An edge is a silhouette where the eye is before one of its triangles and not before the
/// other; each is asked for the side on which the eye is at its own corner, so that silhouettes never end.
void find_edge_kinds(const Mesh& mesh, const EdgeQuery& query, size_t triangle, uint32_t kinds[3]);

/// The centre of projection of a view in object space: the eye, or without perspective the direction to it. In double,
/// up to length and sign; 0 if there is no such point or more than one.
void centre_of_projection(const shd_view& view, const float object_to_world[16], double out[4]);

}  // namespace shd::geometry
