// SPDX-License-Identifier: MIT
#pragma once

#include "core/simd_target.h"
#include "shade/columns.h"
#include "shade/parameters.h"

namespace shd::shade {

/// Moves the fragments' uv, of the set of the height slot, to where their lines of sight meet the heights, 1 on the
/// surface and 0 parallax_depth below it: the first of parallax_steps equal steps that is not above them, and the line
/// between it and the one before (Tatarchuk, "Dynamic Parallax Occlusion Mapping with Approximate Soft Shadows", 2006).
/// Lines flatter than a tenth (n.v) go as if they were that steep. Their derivatives stay. Needs normals, wo and
/// columns->frame of that uv set.
void shift_by_heights(const core::SimdTarget& simd, const SlotRows& where, raster::Fragments* fragments,
                      Columns* columns);

}  // namespace shd::shade
