// SPDX-License-Identifier: MIT
#include "color/pixels.h"

#include <cfloat>
#include <cstring>

#include "image/pixels.h"

namespace shd::color {
namespace {

constexpr float kLargestInput = 1e12f;

/// Clamps to low..high; NaN becomes 0.
float clean(float value, float low, float high) {
  const float number = value == value ? value : 0.0f;
  return number < low ? low : (number > high ? high : number);
}

/// Clamps colour to what the format can store.
void fit(shd_format format, PixelBlock* block, size_t count) {
  const float largest = format == SHD_FORMAT_RGBA16F ? 65504.0f : FLT_MAX;
  for (float* channel : {block->r, block->g, block->b}) {
    for (size_t i = 0; i < count; ++i) channel[i] = clean(channel[i], -largest, largest);
  }
}

/// Encodes pixels of a block. The transform has already applied the curve of RGBA8_SRGB.
void encode(const core::SimdTarget& simd, shd_format format, const PixelBlock& block, size_t at, size_t count,
            void* out) {
  const float* const planes[4] = {block.r + at, block.g + at, block.b + at, block.a + at};
  image::encode_pixels(simd, format == SHD_FORMAT_RGBA8_SRGB ? SHD_FORMAT_RGBA8 : format, planes, count, out);
}

}  // namespace

void load_planes(const Planes& planes, size_t first, size_t count, PixelBlock* out) {
  float* const channels[4] = {out->r, out->g, out->b, out->a};
  for (int c = 0; c < 4; ++c) {
    const auto* bytes = reinterpret_cast<const unsigned char*>(planes.plane[c]);
    for_each_piece(planes.width, first, count, [&](size_t row, size_t column, size_t at, size_t n) {
      const auto* in = reinterpret_cast<const float*>(bytes + row * planes.row_stride[c]) + column;
      std::copy(in, in + n, channels[c] + at);
    });
  }
}

void load_image(const shd_image& image, size_t first, size_t count, PixelBlock* out) {
  for_each_piece(image.width, first, count, [&](size_t row, size_t column, size_t at, size_t n) {
    float* const planes[4] = {out->r + at, out->g + at, out->b + at, out->a + at};
    image::decode_pixels(image.format, pixel_at(image, row, column), n, planes);
  });
}

void clean_color(PixelBlock* block, size_t count) {
  for (float* channel : {block->r, block->g, block->b}) {
    for (size_t i = 0; i < count; ++i) channel[i] = clean(channel[i], -kLargestInput, kLargestInput);
  }
}

void unpremultiply(PixelBlock* block, size_t count) {
  clean_color(block, count);
  for (size_t i = 0; i < count; ++i) block->a[i] = clean(block->a[i], 0.0f, 1.0f);
  for (float* channel : {block->r, block->g, block->b}) {
    for (size_t i = 0; i < count; ++i) {
      const float divisor = block->a[i] > 0.0f ? block->a[i] : 1.0f;
      const float straight = clean(channel[i] / divisor, -kLargestInput, kLargestInput);
      channel[i] = block->a[i] > 0.0f ? straight : 0.0f;
    }
  }
}

void store_pixels(const core::SimdTarget& simd, PixelBlock* block, const shd_image& image, size_t first, size_t count) {
  fit(image.format, block, count);
  for (float* channel : {block->r, block->g, block->b}) {
    for (size_t i = 0; i < count; ++i) channel[i] = block->a[i] > 0.0f ? channel[i] : 0.0f;
  }
  for_each_piece(image.width, first, count, [&](size_t row, size_t column, size_t at, size_t n) {
    encode(simd, image.format, *block, at, n, pixel_at(image, row, column));
  });
}

void store_color(const core::SimdTarget& simd, PixelBlock* block, const shd_image& image, size_t first, size_t count) {
  fit(image.format, block, count);
  const size_t size = image::format_info(image.format).pixel_size;
  for_each_piece(image.width, first, count, [&](size_t row, size_t column, size_t at, size_t n) {
    unsigned char* const out = pixel_at(image, row, column);
    unsigned char pixels[16 * kBlockPixels];
    encode(simd, image.format, *block, at, n, pixels);
    for (size_t i = 0; i < n; ++i) std::memcpy(out + i * size, pixels + i * size, size / 4 * 3);
  });
}

}  // namespace shd::color
