// SPDX-License-Identifier: MIT
#include "texture/filter/prefetch.h"

#include <cmath>

#include "texture/store/storage.h"

namespace shd::texture {

bool is_scattered(const Texture& texture, const PointBlock& block, const float* lod) {
  constexpr size_t kPairs = 8, kNear = size_t{1} << 20;
  constexpr float kApart = 16.0f;  // texels of the level
  if (texture.texels.size() + texture.borrowed_texels * texel_size(texture) <= kNear || block.count <= kPairs) {
    return false;
  }
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

void prefetch_stream(const Texture& texture, const Stream& stream, size_t lanes) {
  const size_t size = texel_size(texture);
  const auto ask = [&](const int32_t* index) {
    for (size_t k = 0; k < lanes; ++k) {
      const auto i = static_cast<uint32_t>(index[k] < 0 ? ~index[k] : index[k]);
      __builtin_prefetch((i < texture.borrowed_texels ? texture.borrowed : texture.origin) + i * size);
    }
  };
  for (size_t e = 0; e < stream.elements; ++e) {
    if (stream.op[e] & kQuad) {
      ask(stream.index[0] + e * lanes);
      ask(stream.index[2] + e * lanes);
    } else if (stream.op[e] & kNewLine) {
      ask(stream.index[0] + e * lanes);
    }
  }
}

}  // namespace shd::texture
