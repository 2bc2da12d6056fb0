// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/allocator.h"
#include "geometry/mesh.h"
#include "geometry/vertex.h"

namespace shd::geometry {

/// Columns of vertices that only some materials read, as bits.
enum Extra : uint32_t { kExtraTangent = 1, kExtraTexture1 = 2, kExtraAttributes = 4 };

/// Room for the wanted columns (Extra bits) that the mesh has, for as many rows as the vertices have. Throws
/// std::bad_alloc.
void allocate_attributes(const core::Allocator& allocator, const Mesh& mesh, uint32_t wanted, Vertices* out);

/// Columns of vertices [begin, end) of a mesh to rows from `row` on, as far as there is room for them; tangents through
/// the matrix of world space, handedness times its orientation.
void transform_attributes(const Mesh& mesh, const Transform& transform, size_t begin, size_t end, size_t row,
                          Vertices* out);

}  // namespace shd::geometry
