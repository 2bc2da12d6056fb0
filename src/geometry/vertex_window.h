// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "core/allocator.h"
#include "core/simd_target.h"
#include "geometry/mesh.h"
#include "geometry/vertex.h"

namespace shd::geometry {

/// Allocates the rows that triangles [begin, end) of a mesh need: at most three per triangle, rounded up to whole
/// vectors. The rows are all vertices of the mesh if these are few enough, otherwise the range that the indices span,
/// otherwise one row per corner. Throws std::bad_alloc.
void allocate_window(const core::Allocator& allocator, const Mesh& mesh, size_t begin, size_t end,
                     uint32_t varying_count, Vertices* out);

/// Number of rows of a window, a multiple of data::kRowPad.
inline size_t row_count(const Vertices& vertices) {
  return vertices.screen.size();
}

/// Whether each row is one corner, so that its vertex can lie anywhere in the mesh.
inline bool is_scattered(const Vertices& vertices) {
  return vertices.own_indices.size() != 0;
}

/// The vertices of rows [begin, end) of a scattered window, as a mesh without triangles. Rows beyond the last corner
/// are 0. Throws std::bad_alloc.
Mesh gather_corners(const core::Allocator& allocator, const Mesh& mesh, const Vertices& vertices, size_t begin,
                    size_t end);

}  // namespace shd::geometry
