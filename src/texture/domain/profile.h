// SPDX-License-Identifier: MIT
/// @file
/// Levels of detail and probes of other texture units (SHD_PROFILE_VULKAN, D3D11 and OIIO).
#pragma once

#include "texture/domain/block.h"
#include "texture/domain/lod.h"
#include "texture/texture.h"

namespace shd::texture {

/// Returns whether a profile is that of another texture unit.
inline bool is_foreign(shd_profile profile) {
  return profile != SHD_PROFILE_LEAST_ERROR && profile != SHD_PROFILE_EXACT;
}

/// Returns whether a filter reads mip levels by the level of detail of isotropic lookups.
inline bool reads_isotropic_levels(shd_filter filter) {
  return filter == SHD_FILTER_NEAREST_MIP || filter == SHD_FILTER_BILINEAR_MIP || filter == SHD_FILTER_TRILINEAR ||
         filter == SHD_FILTER_NEAREST_MIP_LINEAR;
}

/// Returns whether the profile of another texture unit changes the filter of a sampler.
inline bool is_profiled(const Sampler& sampler) {
  return is_foreign(sampler.profile) &&
         (reads_isotropic_levels(sampler.filter) || sampler.filter == SHD_FILTER_ANISOTROPIC);
}

/// Returns whether levels of detail follow another texture unit. Queries (kNone) always follow the sampler's profile;
/// filters follow it if is_profiled().
inline bool uses_profile(const Sampler& sampler, LodRounding rounding) {
  return rounding == LodRounding::kNone ? is_foreign(sampler.profile) : is_profiled(sampler);
}

/// Returns the mip level that a level of detail >= 0 selects under the sampler's profile.
uint32_t nearest_level(const Sampler& sampler, float lod);

/// Returns the weights of bilinear lookups.
Weights weights_of(const shd_sampler_desc& desc);

}  // namespace shd::texture
