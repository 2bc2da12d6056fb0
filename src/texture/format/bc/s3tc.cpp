// SPDX-License-Identifier: MIT
// BC1, BC2 and BC3 (S3TC). Codes of sRGB formats are interpolated before they are decoded.
#include <cstring>

#include "texture/format/bc/codes.h"
#include "texture/format/bc/kernels.h"

namespace shd::texture {
namespace {

constexpr uint32_t kOpaque = 0xff000000u;

/// A colour of three codes in lanes of 21 bits.
constexpr uint64_t kLanes = uint64_t{1} | uint64_t{1} << 21 | uint64_t{1} << 42;

/// Expands a colour of 5, 6 and 5 bits.
uint64_t expanded(uint32_t bits) {
  const uint64_t r = bits >> 11 & 31, g = bits >> 5 & 63, b = bits & 31;
  return (r << 3 | r >> 2) | (g << 2 | g >> 4) << 21 | (b << 3 | b >> 2) << 42;
}

/// Returns the colour near (2 a + b) / 3. For n = 2 a + b + 1 <= 766, 683 n / 2^11 exceeds n / 3 by less than 1/8.
uint64_t third(uint64_t a, uint64_t b) {
  return (2 * a + b + kLanes) * 683 >> 11 & kLanes * 255;
}

/// Returns the colour near (a + b) / 2; halves are rounded up.
uint64_t middle(uint64_t a, uint64_t b) {
  return (a + b + kLanes) >> 1 & kLanes * 255;
}

uint32_t packed(uint64_t lanes) {
  return static_cast<uint32_t>((lanes & 0xff) | (lanes >> 13 & 0xff00) | (lanes >> 26 & 0xff0000));
}

/// Returns the palette of a block of colours: two endpoints of 16 bits, then 16 indices of two bits. `alpha`: of every
/// colour. `three`: endpoints in rising order have three colours, and `fourth` is the last entry.
Palette palette_of(const uint8_t* block, uint32_t alpha, bool three, uint32_t fourth) {
  const auto bits = static_cast<uint32_t>(bits_at<4>(block));
  const uint32_t first = bits & 0xffff, second = bits >> 16;
  const uint64_t a = expanded(first), b = expanded(second);
  const bool four = !three || first > second;
  const uint32_t two_thirds = packed(third(a, b)), half = packed(middle(a, b)), one_third = packed(third(b, a));
  const uint32_t last = four ? one_third | alpha : fourth;
  return {(packed(a) | alpha) | uint64_t{packed(b) | alpha} << 32,
          ((four ? two_thirds : half) | alpha) | uint64_t{last} << 32};
}

void write_colors(const uint8_t* block, Palette colors, uint8_t* texels, size_t pitch) {
  const uint32_t palette[4] = {static_cast<uint32_t>(colors.low), static_cast<uint32_t>(colors.low >> 32),
                               static_cast<uint32_t>(colors.high), static_cast<uint32_t>(colors.high >> 32)};
  auto indices = static_cast<uint32_t>(bits_at<4>(block + 4));
  for (size_t y = 0; y < 4; ++y, indices >>= 8) {
    for (size_t x = 0; x < 4; ++x) std::memcpy(texels + y * pitch + 4 * x, &palette[indices >> (2 * x) & 3], 4);
  }
}

/// Writes the colours of a block of 16 bytes, whose alphas are [16].
void write_with_alphas(const uint8_t* block, const uint8_t (&alpha)[16], uint8_t* texels, size_t pitch) {
  write_colors(block + 8, palette_of(block + 8, 0, false, 0), texels, pitch);
  for (size_t i = 0; i < 16; ++i) texels[i / 4 * pitch + i % 4 * 4 + 3] = alpha[i];
}

}  // namespace

Palette bc1_palette(const uint8_t* block, bool opaque) {
  return palette_of(block, kOpaque, true, opaque ? kOpaque : 0);
}

void decode_bc1_rgb(const uint8_t* block, uint8_t* texels, size_t pitch) {
  write_colors(block, bc1_palette(block, true), texels, pitch);
}

void decode_bc1_rgba(const uint8_t* block, uint8_t* texels, size_t pitch) {
  write_colors(block, bc1_palette(block, false), texels, pitch);
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
