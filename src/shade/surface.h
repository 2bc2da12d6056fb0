// SPDX-License-Identifier: MIT
#pragma once

#include "core/simd_target.h"
#include "shade/columns.h"
#include "shade/parameters.h"

namespace shd::shade {

/// Tangents of triangles where they are read and the mesh has none, and in columns->frame what bumps and parallax go
/// by.
void make_bases(const SlotRows& where, raster::Fragments* rows, Columns* columns);

/// Makes of rows what their material says of their surface: mapped and bumped normals, sides of triangles, and the
/// shape of lobes. Overwrites the rows' normals. `parameters` gets the slots that shape. Throws Failure if a procedure
/// threw.
Shape shape_surface(const core::SimdTarget& simd, const SlotRows& where, raster::Fragments* rows, Columns* columns,
                    Parameters* parameters);

}  // namespace shd::shade
