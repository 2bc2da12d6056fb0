// SPDX-License-Identifier: MIT
// BC1, BC2 and BC3 (S3TC). Codes of sRGB formats are interpolated before they are decoded.
#include <cstring>

#include "texture/block/codes.h"
#include "texture/block/decode.h"

namespace shd::texture {
namespace {

constexpr uint32_t kOpaque = 0xff000000u;

/// Expands a colour of 5, 6 and 5 bits to r, g and b in the lowest bytes.
struct Rgb {
  uint32_t channel[3];

  explicit Rgb(uint32_t bits) {
    const uint32_t r = bits >> 11 & 31, g = bits >> 5 & 63, b = bits & 31;
    channel[0] = r << 3 | r >> 2;
    channel[1] = g << 2 | g >> 4;
    channel[2] = b << 3 | b >> 2;
  }
  uint32_t packed() const { return channel[0] | channel[1] << 8 | channel[2] << 16; }
};

/// Returns the colour near (2 a + b) / 3.
uint32_t third(const Rgb& a, const Rgb& b) {
  uint32_t packed = 0;
  for (int c = 0; c < 3; ++c) packed |= (2 * a.channel[c] + b.channel[c] + 1) / 3 << (8 * c);
  return packed;
}

/// Returns the colour near (a + b) / 2; halves are rounded up.
uint32_t middle(const Rgb& a, const Rgb& b) {
  uint32_t packed = 0;
  for (int c = 0; c < 3; ++c) packed |= (a.channel[c] + b.channel[c] + 1) / 2 << (8 * c);
  return packed;
}

/// Writes a block of colours: two endpoints of 16 bits, then 16 indices of two bits. `alpha`: of every colour.
/// `three`: endpoints in rising order have three colours, and `fourth` is the last entry.
void write_colors(const uint8_t* block, uint32_t alpha, bool three, uint32_t fourth, uint8_t* texels, size_t pitch) {
  const auto bits = static_cast<uint32_t>(bits_at<4>(block));
  auto indices = static_cast<uint32_t>(bits_at<4>(block + 4));
  const uint32_t first = bits & 0xffff, second = bits >> 16;
  const Rgb a(first), b(second);
  uint32_t palette[4] = {a.packed() | alpha, b.packed() | alpha};
  if (!three || first > second) {
    palette[2] = third(a, b) | alpha;
    palette[3] = third(b, a) | alpha;
  } else {
    palette[2] = middle(a, b) | alpha;
    palette[3] = fourth;
  }
  for (size_t y = 0; y < 4; ++y, indices >>= 8) {
    const uint32_t row[4] = {palette[indices & 3], palette[indices >> 2 & 3], palette[indices >> 4 & 3],
                             palette[indices >> 6 & 3]};
    std::memcpy(texels + y * pitch, row, sizeof row);
  }
}

/// Writes the colours of a block of 16 bytes, whose alphas are [16].
void write_with_alphas(const uint8_t* block, const uint8_t (&alpha)[16], uint8_t* texels, size_t pitch) {
  write_colors(block + 8, 0, false, 0, texels, pitch);
  for (size_t i = 0; i < 16; ++i) texels[i / 4 * pitch + i % 4 * 4 + 3] = alpha[i];
}

}  // namespace

void decode_bc1_rgb(const uint8_t* block, uint8_t* texels, size_t pitch) {
  write_colors(block, kOpaque, true, kOpaque, texels, pitch);
}

void decode_bc1_rgba(const uint8_t* block, uint8_t* texels, size_t pitch) {
  write_colors(block, kOpaque, true, 0, texels, pitch);
}

void decode_bc2(const uint8_t* block, uint8_t* texels, size_t pitch) {
  uint8_t alpha[16];
  for (size_t i = 0; i < 16; ++i) alpha[i] = static_cast<uint8_t>((block[i / 2] >> (i % 2 * 4) & 15) * 17);
  write_with_alphas(block, alpha, texels, pitch);
}

void decode_bc3(const uint8_t* block, uint8_t* texels, size_t pitch) {
  const CodeBlock codes(block);
  const auto nearest = [](uint32_t sum, uint32_t divisor) {
    return static_cast<uint8_t>((sum + divisor / 2) / divisor);
  };
  uint8_t palette[8], alpha[16];
  fill_palette<uint32_t, uint8_t>(codes.first > codes.second, codes.first, codes.second, 0, 255, nearest, palette);
  for (size_t i = 0; i < 16; ++i) alpha[i] = palette[codes.indices >> (3 * i) & 7];
  write_with_alphas(block, alpha, texels, pitch);
}

}  // namespace shd::texture
