// SPDX-License-Identifier: MIT
/// @file
/// Levels of detail and probes of other texture units (SHD_PROFILE_VULKAN, D3D11 and OIIO).
#pragma once

#include "texture/footprint/block.h"
#include "texture/footprint/lod.h"
#include "texture/texture.h"

namespace shd::texture {

/// Returns whether the profile of a sampler changes its filter.
inline bool is_profiled(const Sampler& sampler) {
  if (sampler.profile == SHD_PROFILE_EXACT) return false;
  return sampler.filter == SHD_FILTER_NEAREST_MIP || sampler.filter == SHD_FILTER_BILINEAR_MIP ||
         sampler.filter == SHD_FILTER_TRILINEAR || sampler.filter == SHD_FILTER_ANISOTROPIC;
}

/// Returns whether levels of detail follow the sampler's profile. Queries (kNone) always follow it; filters follow it
/// if is_profiled().
inline bool uses_profile(const Sampler& sampler, LodRounding rounding) {
  return rounding == LodRounding::kNone ? sampler.profile != SHD_PROFILE_EXACT : is_profiled(sampler);
}

/// Returns the mip level that a level of detail >= 0 selects under the sampler's profile.
uint32_t nearest_level(const Sampler& sampler, float lod);

/// Returns whether the weights of bilinear lookups are rounded to 8 bits.
bool has_rounded_weights(const shd_sampler_desc& desc);

}  // namespace shd::texture
