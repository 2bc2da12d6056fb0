// SPDX-License-Identifier: MIT
#pragma once

#include <shd/mesh.h>

#include "core/allocator.h"
#include "geometry/mesh.h"

namespace shd::geometry {

/// Converts the indices of a checked desc, of any topology and size, into triples. Throws Failure for an index that is
/// not below vertex_count, and std::bad_alloc.
void copy_indices(const core::Allocator& allocator, const shd_mesh_desc& desc, Mesh* out);

}  // namespace shd::geometry
