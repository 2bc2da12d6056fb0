// SPDX-License-Identifier: MIT
#pragma once

#include "core/simd_target.h"
#include "material/material.h"
#include "raster/fragments.h"

namespace shd::material {

/// Returns the lookups of a slot's texture at points, with the slot's uv set and uv transform.
/// @param has_footprint  if false, the lookups have no derivatives and use level 0
/// @param scratch        [6] columns for the lookups of a transformed slot
texture::Lookups lookups_of(const Slot& slot, const raster::Fragments& points, bool has_footprint,
                            float* const scratch[6]);

/// Returns the lookups at u and v with their derivatives by x and y.
texture::Lookups lookups_of(const Slot& slot, const float* const (&uv)[6], size_t count, float* const scratch[6]);

/// Replaces each null column by a column of ones, so that kernels need no branches.
Parameters complete(const Parameters& parameters);

/// Returns parameters whose columns are all ones.
const Parameters& unset_parameters();

/// Finds the levels of detail of the diffuse slot's texture after bias and clamps; 0 without a texture. `scratch` holds
/// the lookups.
void find_levels(const core::SimdTarget& simd, const Material& material, const raster::Fragments& fragments,
                 float* const scratch[6], float* lod);

}  // namespace shd::material
