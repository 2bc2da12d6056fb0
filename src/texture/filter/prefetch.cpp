// SPDX-License-Identifier: MIT
#include "texture/filter/prefetch.h"

#include <cmath>

#include "texture/rows.h"
#include "texture/store/storage.h"

namespace shd::texture {

namespace {

/// is_scattered() with a third coordinate, or null.
bool is_far_apart(const Texture& texture, const PointBlock& block, const float* w, const float* lod) {
  constexpr size_t kPairs = 8, kNear = size_t{1} << 20;
  constexpr float kApart = 16.0f;  // [texels of the level]
  if (texture.texels.size() + texture.borrowed_units * texel_size(texture) <= kNear || block.count <= kPairs) {
    return false;
  }
  const auto width = static_cast<float>(texture.width), height = static_cast<float>(texture.height);
  const auto depth = static_cast<float>(texture.depth);
  size_t apart = 0;
  for (size_t k = 0; k < kPairs; ++k) {
    const size_t i = k * (block.count - 1) / kPairs;
    const float limit = lod ? kApart * static_cast<float>(uint64_t{1} << static_cast<uint32_t>(lod[i])) : kApart;
    apart += std::fabs(block.u[i + 1] - block.u[i]) * width > limit ||
             std::fabs(block.v[i + 1] - block.v[i]) * height > limit ||
             (w && std::fabs(w[i + 1] - w[i]) * depth > limit);
  }
  return apart > kPairs / 2;
}

}  // namespace

bool is_scattered(const Texture& texture, const PointBlock& block, const float* lod) {
  return is_far_apart(texture, block, nullptr, lod);
}

bool is_scattered_in_slices(const Texture& texture, const PointBlock& block, const float* w, const float* lod) {
  return is_far_apart(texture, block, w, lod);
}

void prefetch_element(const TexelSource& source, uint32_t op, const int32_t* index0, const int32_t* index2,
                      size_t lanes) {
  const auto ask = [&](const int32_t* index) {
    // gcc 12 treats a function that only prefetches as free of effects and removes its calls. This prevents it.
    __asm__ volatile("");
    for (size_t k = 0; k < lanes; ++k) {
      __builtin_prefetch(source.texel(static_cast<uint32_t>(index[k] < 0 ? ~index[k] : index[k])));
    }
  };
  if (op & (kQuad | kNewLine)) ask(index0);
  if (op & (kQuad | kRow)) ask(index2);
}

void prefetch_rows(const TexelSource& source, const RowStream& rows, size_t lanes) {
  for (size_t k = 0; k < (rows.blended ? 2 : 1); ++k) {
    const RowQuads& quads = rows.quads[k];
    __asm__ volatile("");  // as above
    for (size_t i = 0; i < rows.count; ++i) {
      const int32_t lower = quads.split[i / lanes] ? quads.other[1][i] : quads.upper[i] + quads.down;
      __builtin_prefetch(source.texel(static_cast<uint32_t>(quads.upper[i])));
      __builtin_prefetch(source.texel(static_cast<uint32_t>(lower)));
    }
  }
}

void InputColumns::find(const Lookups& in) {
  for (size_t c = 0; c < kFloatColumns; ++c) {
    if (in.real(c)) column_[columns_++] = reinterpret_cast<const uint32_t*>(in.real(c));
  }
  for (size_t c = 0; c < kIntegerColumns; ++c) {
    if (in.integer(c)) column_[columns_++] = in.integer(c);
  }
}

TexelSource::TexelSource(const FilterCall& call) : TexelSource(call.texture) {
  if (call.placement.place) origin = call.placement.origin;
}

TexelSource::TexelSource(const Texture& texture)
    : origin(texture.origin),
      borrowed(is_in_memory(texture) ? texture.borrowed : nullptr),
      borrowed_texels(is_in_memory(texture) ? texture.borrowed_units : 0),
      channels(texture.channels),
      texel_size(static_cast<uint32_t>(shd::texture::texel_size(texture))) {}

}  // namespace shd::texture
