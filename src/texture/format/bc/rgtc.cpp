// SPDX-License-Identifier: MIT
// BC4 and BC5 (RGTC): one or two blocks of codes.
#include <cstring>

#include "texture/format/bc/codes.h"
#include "texture/format/bc/decode.h"

namespace shd::texture {
namespace {

/// Writes entries of a palette to one channel of texels of kChannels channels.
template <size_t kChannels, class Entry>
void write_channel(uint64_t indices, const Entry (&palette)[8], uint8_t* texels, size_t pitch) {
  for (size_t i = 0; i < 16; ++i) {
    std::memcpy(texels + i / 4 * pitch + i % 4 * kChannels * sizeof(Entry), &palette[indices >> (3 * i) & 7],
                sizeof(Entry));
  }
}

/// A code of 8 bits is 257 times as large in 16 bits.
template <size_t kChannels>
void write_unorm(const uint8_t* block, uint8_t* texels, size_t pitch) {
  const CodeBlock codes(block);
  const auto nearest = [](uint32_t sum, uint32_t divisor) {
    return static_cast<uint16_t>((257 * sum + divisor / 2) / divisor);
  };
  uint16_t palette[8];
  fill_palette<uint32_t, uint16_t>(codes.first > codes.second, codes.first, codes.second, 0, 65535, nearest, palette);
  write_channel<kChannels>(codes.indices, palette, texels, pitch);
}

/// The bytes of the endpoints are compared before -128 becomes -127, as DirectXTex does.
template <size_t kChannels>
void write_snorm(const uint8_t* block, uint8_t* texels, size_t pitch) {
  const CodeBlock codes(block);
  const auto value = [](uint32_t byte) { return static_cast<int32_t>(byte) - (byte > 127 ? 256 : 0); };
  const auto clamped = [](int32_t code) { return code < -127 ? -127 : code; };
  const auto quotient = [](int32_t sum, int32_t divisor) {
    return static_cast<float>(sum) / static_cast<float>(127 * divisor);
  };
  const int32_t a = value(codes.first), b = value(codes.second);
  float palette[8];
  fill_palette<int32_t, float>(a > b, clamped(a), clamped(b), -1.0f, 1.0f, quotient, palette);
  write_channel<kChannels>(codes.indices, palette, texels, pitch);
}

}  // namespace

void decode_bc4(const uint8_t* block, uint8_t* texels, size_t pitch) {
  write_unorm<1>(block, texels, pitch);
}

void decode_bc4_snorm(const uint8_t* block, uint8_t* texels, size_t pitch) {
  write_snorm<1>(block, texels, pitch);
}

void decode_bc5(const uint8_t* block, uint8_t* texels, size_t pitch) {
  write_unorm<2>(block, texels, pitch);
  write_unorm<2>(block + 8, texels + 2, pitch);
}

void decode_bc5_snorm(const uint8_t* block, uint8_t* texels, size_t pitch) {
  write_snorm<2>(block, texels, pitch);
  write_snorm<2>(block + 8, texels + 4, pitch);
}

}  // namespace shd::texture
