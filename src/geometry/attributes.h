// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/allocator.h"
#include "geometry/mesh.h"
#include "geometry/vertex.h"

namespace shd::geometry {

/// Columns of vertices that only some materials read.
enum Extra : uint32_t { kExtraTangent = 1, kExtraTexture1 = 2, kExtraAttributes = 4 };

/// Room for the wanted columns (Extra bits) that the mesh has, for as many rows as the vertices have. Throws
/// std::bad_alloc.
void allocate_attributes(const core::Allocator& allocator, const Mesh& mesh, uint32_t wanted, Vertices* out);

/// Fills the columns that `out` has room for. Tangents pass through the matrix of world space; handedness is multiplied
/// by its orientation.
void transform_attributes(const Mesh& mesh, const Transform& transform, const VertexRange& range, Vertices* out);

}  // namespace shd::geometry
