// SPDX-License-Identifier: MIT
#pragma once

#include "core/simd_target.h"
#include "shade/columns.h"
#include "shade/parameters.h"

namespace shd::shade {

/// Computes the tangents of points if they are read and the mesh has none, and columns->tangent_frame for bumps and
/// parallax.
void make_tangent_bases(const SlotContext& context, raster::Fragments* points, Columns* columns);

/// Applies the material's normal maps, bumps and double-sidedness to the points' normals, and derives the shape of the
/// lobes. Writes the values of the shaping slots to `parameters`. Throws Failure if a procedure threw.
LobeShape evaluate_surface(const core::SimdTarget& simd, const SlotContext& context, raster::Fragments* points,
                           Columns* columns, material::Parameters* parameters);

}  // namespace shd::shade
