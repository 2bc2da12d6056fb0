// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/allocator.h"
#include "geometry/mesh.h"

namespace shd::geometry {

/// Fills nx, ny, nz of a mesh whose positions and indices are set: the weighted sum of the face normals around a
/// vertex, normalised. Faces without area and faces with a non-finite position contribute nothing. A vertex without
/// contributions gets (0, 0, 1). Returns the number of such vertices. Throws std::bad_alloc.
/// Angle weighting after Thuermer and Wuethrich, "Computing Vertex Normals from Polygonal Facets" (1998).
/// |error| of a component <= 1.2e-7 against the exact sum unless the weighted normals nearly cancel.
uint32_t compute_normals(const core::Allocator& allocator, shd_normal_weight weight, Mesh* mesh);

}  // namespace shd::geometry
