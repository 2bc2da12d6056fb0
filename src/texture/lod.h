// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "texture/texture.h"

namespace shd::texture {

/// Bounds of the level of detail.
struct LodRange {
  float low, high;  // low <= high
};

/// Those of a sampler, within the levels of a texture.
inline LodRange lod_range(uint32_t level_count, const Sampler& sampler) {
  const auto last = static_cast<float>(level_count - 1);
  return {sampler.lod_min < last ? sampler.lod_min : last, sampler.lod_max < last ? sampler.lod_max : last};
}

inline LodRange lod_range(const Texture& texture, const Sampler& sampler) {
  return lod_range(texture.level_count, sampler);
}

/// The mip level that a level of detail >= 0 stands for.
inline uint32_t nearest_level(const Sampler& sampler, float lod) {
  return static_cast<uint32_t>(sampler.profile == SHD_PROFILE_OIIO ? std::ceil(lod) : std::ceil(lod + 0.5f) - 1.0f);
}

}  // namespace shd::texture
