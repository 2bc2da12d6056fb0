// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "core/simd_target.h"
#include "material/material.h"
#include "material/triplanar.h"
#include "raster/fragments.h"

namespace shd::material {

/// Number of scratch columns for lookups of a slot.
constexpr uint32_t kLookupScratch = 13;

/// Returns the lookups of a slot's texture at points, with the slot's uv set and uv transform, or with its places. The
/// slot is not triplanar.
/// @param has_footprint  if false, the lookups have no derivatives and use level 0
/// @param scratch        columns for the lookups of a transformed slot or of places
texture::Lookups lookups_of(const Slot& slot, const raster::Fragments& points, const float object_to_world[16],
                            bool has_footprint, float* const scratch[kLookupScratch]);

/// Looks up the axes of a triplanar slot: look_up(lookups, values) fills the columns of `values`, and `out` gets their
/// weighted mean. Null columns stay null. `scratch` holds lookups, weights and values.
template <class LookUp>
void blend_axes(const Slot& slot, const raster::Fragments& points, const float object_to_world[16], bool has_footprint,
                float* const scratch[kLookupScratch], float* const (&out)[4], const LookUp& look_up) {
  float *const *const weights = scratch + 6, *const *const values = scratch + 9;
  const TriplanarMap map = triplanar_map(slot, object_to_world);
  find_weights(map, slot.triplanar_sharpness, points, weights);
  float* part[4];
  for (int c = 0; c < 4; ++c) {
    part[c] = out[c] ? values[c] : nullptr;
    if (out[c]) std::fill_n(out[c], points.count, 0.0f);
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (std::all_of(weights[axis], weights[axis] + points.count, [](float w) { return w == 0.0f; })) continue;
    look_up(lookups_along(map, axis, has_footprint ? slot.place_width : 0.0f, points, scratch), part);
    for (int c = 0; c < 4; ++c) {
      if (out[c]) add_weighted(points.count, weights[axis], part[c], out[c]);
    }
  }
}

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
