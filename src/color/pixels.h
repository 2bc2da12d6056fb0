// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <shd/image.h>

namespace shd::color {

/// Pixels handled together: four planes of this many floats stay in the first-level cache.
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

// Pixels `first` .. `first + count` are counted row by row from the top; count <= kBlockPixels.

void load_planes(const Planes& planes, size_t first, size_t count, PixelBlock* out);
/// RGBA16F or RGBA32F.
void load_image(const shd_image& image, size_t first, size_t count, PixelBlock* out);

/// NaN to 0, clamped to +-1e12: large enough for any light, and small enough for no transform to overflow on the way.
void clean_color(PixelBlock* block, size_t count);
/// Alpha to [0, 1], NaN to 0; colour cleaned and divided by alpha, 0 where alpha is 0.
void unpremultiply(PixelBlock* block, size_t count);

/// Any four-channel format; finite, clamped to its range, 0 where alpha is 0.
void store_pixels(const PixelBlock& block, const shd_image& image, size_t first, size_t count);
/// RGBA16F or RGBA32F; finite, clamped to its range; alpha in memory stays.
void store_color(const PixelBlock& block, const shd_image& image, size_t first, size_t count);

}  // namespace shd::color
