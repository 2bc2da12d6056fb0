// SPDX-License-Identifier: MIT
/// @file
/// Levels of detail and probes as other texture units find them (SHD_PROFILE_VULKAN, D3D11 and OIIO).
#pragma once

#include "texture/footprint/block.h"
#include "texture/footprint/lod.h"
#include "texture/texture.h"

namespace shd::texture {

/// Whether the profile of a sampler changes its filter.
inline bool is_profiled(const Sampler& sampler) {
  if (sampler.profile == SHD_PROFILE_EXACT) return false;
  return sampler.filter == SHD_FILTER_NEAREST_MIP || sampler.filter == SHD_FILTER_BILINEAR_MIP ||
         sampler.filter == SHD_FILTER_TRILINEAR || sampler.filter == SHD_FILTER_ANISOTROPIC;
}

/// Whether its levels of detail are the profile's: a filter takes them only if it is profiled, a query always does.
inline bool uses_profile(const Sampler& sampler, LodRounding rounding) {
  return rounding == LodRounding::kNone ? sampler.profile != SHD_PROFILE_EXACT : is_profiled(sampler);
}

/// The mip level of a level of detail >= 0, of any profile.
uint32_t nearest_level(const Sampler& sampler, float lod);

/// Whether the weights of its bilinear lookups have 8 bits.
bool has_rounded_weights(const shd_sampler_desc& desc);

}  // namespace shd::texture
