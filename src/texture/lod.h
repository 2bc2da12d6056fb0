// SPDX-License-Identifier: MIT
#pragma once

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

}  // namespace shd::texture
