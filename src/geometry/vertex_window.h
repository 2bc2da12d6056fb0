// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "core/allocator.h"
#include "core/simd_target.h"
#include "geometry/mesh.h"
#include "geometry/vertex.h"

namespace shd::geometry {

/// Rows that triangles [begin, end) of a mesh need, at most three a triangle and what fills the last vector up: all of
/// the mesh's vertices if those are few enough, else the range that the triangles' indices span, else a row for each
/// corner. Throws std::bad_alloc.
void allocate_window(const core::Allocator& allocator, const Mesh& mesh, size_t begin, size_t end,
                     uint32_t varying_count, Vertices* out);

/// Rows of a window, a multiple of data::kRowPad.
inline size_t row_count(const Vertices& vertices) {
  return vertices.screen.size();
}

/// Whether rows are corners, whose vertices lie anywhere in the mesh.
inline bool is_scattered(const Vertices& vertices) {
  return vertices.own_indices.size() != 0;
}

/// The vertices behind rows [begin, end) of a window of scattered ones, as a mesh without triangles; what lies beyond
/// the last corner is 0. Throws std::bad_alloc.
Mesh gather_corners(const core::Allocator& allocator, const Mesh& mesh, const Vertices& vertices, size_t begin,
                    size_t end);

}  // namespace shd::geometry
