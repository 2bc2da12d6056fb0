// SPDX-License-Identifier: MIT
#pragma once

#include "texture/texture.h"

namespace shd::texture {

/// Bounds of the level of detail.
struct LodRange {
  float low, high;  // low <= high
};

/// Returns the range of a sampler, limited to the levels of a texture.
inline LodRange lod_range(uint32_t level_count, const Sampler& sampler) {
  const auto last = static_cast<float>(level_count - 1);
  return {sampler.lod_min < last ? sampler.lod_min : last, sampler.lod_max < last ? sampler.lod_max : last};
}

inline LodRange lod_range(const Texture& texture, const Sampler& sampler) {
  return lod_range(texture.level_count, sampler);
}

/// Levels by which SHD_PROFILE_LEAST_ERROR reads finer than the footprint's size. `shd-bench` measures it in the rows
/// default/.
constexpr float kFiner = 0.375f;

/// Part of kFiner that probes along a line lose as their number grows: finer levels leave gaps between them.
constexpr float kCoarser = 0.25f;

/// Returns what is added to the log2 of a footprint's size: the bias, and the finer level of SHD_PROFILE_LEAST_ERROR.
/// A level of detail that the caller gives is only biased.
inline float level_shift(const Sampler& sampler, bool lod_given) {
  const bool finer = sampler.profile == SHD_PROFILE_LEAST_ERROR && !lod_given;
  return finer ? sampler.lod_bias - kFiner : sampler.lod_bias;
}

/// Source of a level of detail: the longer axis of the footprint, or the probes of anisotropic filtering.
enum class LodAxis { kLonger, kProbes };

/// Finds the levels of detail of packed lookups according to the sampler's profile: with bias, clamped to a range, not
/// rounded. Returns the number of lookups that were not finite.
size_t find_lods(const Texture& texture, const Sampler& sampler, const LodRange& range, LodAxis axis,
                 const core::SimdTarget& simd, const Lookups& lookups, float* out);

/// Finds the half axes of the footprint of one lookup in base texels, with width and blur: u and v of the longer axis,
/// then u and v of the shorter axis.
void find_axes(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd, const Lookups& lookup,
               float (&axes)[4]);

}  // namespace shd::texture
