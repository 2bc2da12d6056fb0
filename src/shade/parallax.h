// SPDX-License-Identifier: MIT
#pragma once

#include "core/simd_target.h"
#include "shade/columns.h"
#include "shade/parameters.h"

namespace shd::shade {

/// Moves the fragments' uv, in the set of the height slot, to the point where their line of sight meets the height
/// field: height 1 is on the surface, 0 is at parallax_depth below it. The line is marched in parallax_steps equal
/// steps. The result is interpolated linearly between the first step at or below the heights and the step before it
/// (Tatarchuk, "Dynamic Parallax Occlusion Mapping with Approximate Soft Shadows", 2006). n.v is clamped to at least
/// 0.1. Derivatives of uv are left unchanged. Reads normals, wo and columns->tangent_frame of the uv set.
void shift_by_heights(const core::SimdTarget& simd, const SlotContext& context, raster::Fragments* fragments,
                      Columns* columns);

}  // namespace shd::shade
