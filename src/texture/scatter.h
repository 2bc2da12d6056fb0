// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "texture/storage.h"

namespace shd::texture {

/// Whether most neighbouring lookups of a block read lines of memory far from each other, as eight pairs of them tell,
/// in a texture that is larger than a cache close to a core. `lod` is null for lookups on level 0. Decides how fast
/// the lookups are, not what they give.
inline bool is_scattered(const Texture& texture, const Lookups& block, const float* lod) {
  constexpr size_t kPairs = 8, kNear = size_t{1} << 20;
  constexpr float kApart = 16.0f;  // texels of the level
  if (texture.texels.size() + texture.borrowed_texels * texel_size(texture) <= kNear || block.count <= kPairs)
    return false;
  const auto width = static_cast<float>(texture.width), height = static_cast<float>(texture.height);
  size_t apart = 0;
  for (size_t k = 0; k < kPairs; ++k) {
    const size_t i = k * (block.count - 1) / kPairs;
    const float limit = lod ? kApart * static_cast<float>(uint64_t{1} << static_cast<uint32_t>(lod[i])) : kApart;
    apart += std::fabs(block.u[i + 1] - block.u[i]) * width > limit ||
             std::fabs(block.v[i + 1] - block.v[i]) * height > limit;
  }
  return apart > kPairs / 2;
}

}  // namespace shd::texture
