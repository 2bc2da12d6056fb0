// SPDX-License-Identifier: MIT
/// @file
/// Levels of detail and probes as other texture units find them: a pass over a block of lookups before the kernels,
/// which then take what it found as given. SHD_PROFILE_EXACT never comes here.
#pragma once

#include "texture/block.h"
#include "texture/lod.h"
#include "texture/texture.h"

namespace shd::texture {

/// Whether the profile of a sampler changes its filter.
bool is_profiled(const Sampler& sampler);

/// The mip level of a level of detail >= 0, of any profile.
uint32_t nearest_level(const Sampler& sampler, float lod);

/// Whether the weights of its bilinear lookups have 8 bits.
bool has_rounded_weights(const shd_sampler_desc& desc);

constexpr size_t kProfileBlock = 128;  // 3 KB of stack

/// A block as the kernels take it: levels of detail in the column `lod`, or the probes of anisotropic lookups in the
/// columns of a ProbeLine.
struct ProfiledBlock {
  alignas(64) float columns[5][kProfileBlock];
  alignas(64) uint32_t reach[kProfileBlock];
  Sampler sampler;   // of SHD_PROFILE_EXACT; its bias, clamps, width and blur have been applied
  Lookups lookups;   // refers to the columns
  size_t nonfinite;  // lookups that were not finite
};

/// Of at most kProfileBlock lookups, for a sampler that is_profiled().
void profile_block(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd, const Lookups& in,
                   ProfiledBlock* out);

/// What becomes of a level of detail after bias and clamps: rounded to the profile's fractions, or to a level whose
/// nearest one is the profile's.
enum class ProfileFinish { kNone, kRounded, kNearest };

/// The profile's levels of detail, biased and clamped to a range but not rounded: of the longer axis, or those of an
/// anisotropic lookup. Returns how many lookups were not finite.
enum class ProfileLod { kLongerAxis, kAnisotropic };
size_t profile_lod(const Texture& texture, const Sampler& sampler, const LodRange& range, ProfileLod which,
                   const core::SimdTarget& simd, const Lookups& in, float* out);

}  // namespace shd::texture
