// SPDX-License-Identifier: MIT
#pragma once

#include "core/simd_target.h"
#include "material/material.h"
#include "raster/fragments.h"

namespace shd::material {

/// Number of scratch columns for lookups of a slot.
constexpr uint32_t kLookupScratch = 9;

/// Returns the lookups of a slot's texture at points, with the slot's uv set and uv transform, or of a 3D texture with
/// its places.
/// @param has_footprint  if false, the lookups have no derivatives and use level 0
/// @param scratch        columns for the lookups of a transformed slot or of places
texture::Lookups lookups_of(const Slot& slot, const raster::Fragments& points, const float object_to_world[16],
                            bool has_footprint, float* const scratch[kLookupScratch]);

/// Returns the lookups of a 2D texture at u and v with their derivatives by x and y.
texture::Lookups lookups_of(const Slot& slot, const float* const (&uv)[6], size_t count,
                            float* const scratch[kLookupScratch]);

/// Replaces each null column by a column of ones, so that kernels need no branches.
Parameters complete(const Parameters& parameters);

/// Returns parameters whose columns are all ones.
const Parameters& unset_parameters();

/// Finds the levels of detail of the diffuse slot's texture after bias and clamps; 0 without a texture. `scratch` holds
/// the lookups.
void find_levels(const core::SimdTarget& simd, const Material& material, const raster::Fragments& fragments,
                 const float object_to_world[16], float* const scratch[kLookupScratch], float* lod);

}  // namespace shd::material
