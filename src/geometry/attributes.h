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

/// Allocates the wanted columns (Extra bits) that the mesh has, with as many rows as the vertices have. Throws
/// std::bad_alloc.
void allocate_attributes(const core::Allocator& allocator, const Mesh& mesh, uint32_t wanted, Vertices* out);

/// Fills the columns that are allocated in `out`. Tangents are transformed to world space; handedness is multiplied by
/// the orientation of the matrix.
void transform_attributes(const Mesh& mesh, const Transform& transform, const VertexRange& range, Vertices* out);

}  // namespace shd::geometry
