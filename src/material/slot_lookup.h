// SPDX-License-Identifier: MIT
#pragma once

#include "core/simd_target.h"
#include "material/material.h"
#include "raster/fragments.h"

namespace shd::material {

/// Lookups of a slot's texture at points, in the slot's uv set through its transform.
/// @param has_footprint  else without derivatives: level 0
/// @param scratch        [6] columns that hold the lookups of a transformed slot
texture::Lookups lookups_of(const Slot& slot, const raster::Fragments& points, bool has_footprint,
                            float* const scratch[6]);

/// The same values with a column of ones in place of each null: kernels then need no branches.
Parameters complete(const Parameters& parameters);

/// All ones.
const Parameters& unset_parameters();

/// Levels of detail of the diffuse slot's texture after bias and clamps; 0 without a texture. `scratch` holds lookups.
void find_levels(const core::SimdTarget& simd, const Material& material, const raster::Fragments& fragments,
                 float* const scratch[6], float* lod);

}  // namespace shd::material
