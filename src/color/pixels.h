// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include <shd/image.h>

#include "core/simd_target.h"
#include "image/format.h"

namespace shd::color {

/// Number of pixels in a block: four planes of this many floats stay in the first-level cache.
constexpr size_t kBlockPixels = 1024;

struct PixelBlock {
  alignas(64) float r[kBlockPixels];
  alignas(64) float g[kBlockPixels];
  alignas(64) float b[kBlockPixels];
  alignas(64) float a[kBlockPixels];
};

/// Colour planes of a framebuffer: r, g, b, a, [height][width].
struct Planes {
  const float* plane[4];
  size_t row_stride[4];  // bytes
  uint32_t width;
  uint32_t height;
};

inline unsigned char* pixel_at(const shd_image& image, size_t row, size_t column) {
  return static_cast<unsigned char*>(image.pixels) + row * image.row_stride +
         column * image::format_info(image.format).pixel_size;
}

/// Calls run(row, column, offset in the range, pixels) for each piece of a row in a range of pixels.
template <class Run>
void for_each_piece(uint32_t width, size_t first, size_t count, Run&& run) {
  size_t row = first / width;
  size_t column = first % width;
  for (size_t done = 0; done < count; ++row, column = 0) {
    const size_t piece = std::min(count - done, width - column);
    run(row, column, done, piece);
    done += piece;
  }
}

// Pixels `first` .. `first + count` are numbered row by row from the top; count <= kBlockPixels.

void load_planes(const Planes& planes, size_t first, size_t count, PixelBlock* out);
/// @param image  RGBA16F or RGBA32F
void load_image(const shd_image& image, size_t first, size_t count, PixelBlock* out);

/// Replaces NaN by 0 and clamps colour to +-1e12: large enough for any light, small enough that no transform overflows.
void clean_color(PixelBlock* block, size_t count);
/// Clamps alpha to [0, 1] with NaN as 0. Cleans colour and divides it by alpha; colour is 0 where alpha is 0.
void unpremultiply(PixelBlock* block, size_t count);

// Stores clamp the block to the finite range of the format, NaN to 0.

/// Stores to any four-channel format; colour is 0 where alpha is 0.
void store_pixels(const core::SimdTarget& simd, PixelBlock* block, const shd_image& image, size_t first, size_t count);
/// Stores colour to RGBA16F or RGBA32F. Alpha in memory is kept.
void store_color(const core::SimdTarget& simd, PixelBlock* block, const shd_image& image, size_t first, size_t count);

}  // namespace shd::color
