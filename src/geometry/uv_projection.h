// SPDX-License-Identifier: MIT
#pragma once

#include <shd/uv_projection.h>

#include "core/allocator.h"
#include "geometry/mesh.h"

namespace shd::geometry {

/// Computes u and v of a mesh from its positions, after the rules of shd/uv_projection.h. Vertices whose triangles need
/// different coordinates are split: copies are appended, and the indices of the triangles change.
/// @param to_projection  [16], column-major, affine: from object space to the space of the projection
/// Throws std::bad_alloc. |error| of u and v <= 1.2e-7 of their value, except where a place nearly cancels.
void project_uv(const core::Allocator& allocator, shd_uv_projection projection, const float* to_projection, Mesh* mesh);

}  // namespace shd::geometry
