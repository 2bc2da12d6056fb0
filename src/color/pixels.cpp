// SPDX-License-Identifier: MIT
#include "color/pixels.h"

#include <cfloat>

#include "image/half.h"

namespace shd::color {
namespace {

constexpr float kLargestInput = 1e12f;

template <class Channel>
Channel* pixel_at(const shd_image& image, size_t row, size_t column) {
  return reinterpret_cast<Channel*>(static_cast<unsigned char*>(image.pixels) + row * image.row_stride) + column * 4;
}

/// Clamps to low..high; NaN becomes 0.
float clean(float value, float low, float high) {
  const float number = value == value ? value : 0.0f;
  return number < low ? low : (number > high ? high : number);
}

float decode(float value) {
  return value;
}
float decode(uint16_t value) {
  return image::half_to_float(value);
}

void encode(float value, float* out) {
  *out = clean(value, -FLT_MAX, FLT_MAX);
}

/// Channel type that distinguishes binary16 from 16-bit unorm.
struct Half {
  uint16_t bits;
};
void encode(float value, Half* out) {
  out->bits = image::float_to_half(clean(value, -65504.0f, 65504.0f));
}
void encode(float value, uint8_t* out) {
  *out = static_cast<uint8_t>(static_cast<int32_t>(clean(value, 0.0f, 1.0f) * 255.0f + 0.5f));
}
void encode(float value, uint16_t* out) {
  *out = static_cast<uint16_t>(static_cast<int32_t>(clean(value, 0.0f, 1.0f) * 65535.0f + 0.5f));
}

template <class Channel>
void load_channels(const shd_image& image, size_t first, size_t count, PixelBlock* out) {
  for_each_piece(image.width, first, count, [&](size_t row, size_t column, size_t at, size_t n) {
    const Channel* in = pixel_at<const Channel>(image, row, column);
    for (size_t i = 0; i < n; ++i) {
      out->r[at + i] = decode(in[4 * i]);
      out->g[at + i] = decode(in[4 * i + 1]);
      out->b[at + i] = decode(in[4 * i + 2]);
      out->a[at + i] = decode(in[4 * i + 3]);
    }
  });
}

template <class Channel>
void store_channels(const PixelBlock& block, const shd_image& image, size_t first, size_t count) {
  for_each_piece(image.width, first, count, [&](size_t row, size_t column, size_t at, size_t n) {
    Channel* out = pixel_at<Channel>(image, row, column);
    for (size_t i = 0; i < n; ++i) {
      const float alpha = block.a[at + i];
      const bool visible = alpha > 0.0f;
      encode(visible ? block.r[at + i] : 0.0f, out + 4 * i);
      encode(visible ? block.g[at + i] : 0.0f, out + 4 * i + 1);
      encode(visible ? block.b[at + i] : 0.0f, out + 4 * i + 2);
      encode(alpha, out + 4 * i + 3);
    }
  });
}

template <class Channel>
void store_three(const PixelBlock& block, const shd_image& image, size_t first, size_t count) {
  for_each_piece(image.width, first, count, [&](size_t row, size_t column, size_t at, size_t n) {
    Channel* out = pixel_at<Channel>(image, row, column);
    for (size_t i = 0; i < n; ++i) {
      encode(block.r[at + i], out + 4 * i);
      encode(block.g[at + i], out + 4 * i + 1);
      encode(block.b[at + i], out + 4 * i + 2);
    }
  });
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
  if (image.format == SHD_FORMAT_RGBA16F) {
    load_channels<uint16_t>(image, first, count, out);
  } else {
    load_channels<float>(image, first, count, out);
  }
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

void store_pixels(const PixelBlock& block, const shd_image& image, size_t first, size_t count) {
  switch (image.format) {
    case SHD_FORMAT_RGBA16F: return store_channels<Half>(block, image, first, count);
    case SHD_FORMAT_RGBA32F: return store_channels<float>(block, image, first, count);
    case SHD_FORMAT_RGBA16: return store_channels<uint16_t>(block, image, first, count);
    default: return store_channels<uint8_t>(block, image, first, count);
  }
}

void store_color(const PixelBlock& block, const shd_image& image, size_t first, size_t count) {
  if (image.format == SHD_FORMAT_RGBA16F) {
    store_three<Half>(block, image, first, count);
  } else {
    store_three<float>(block, image, first, count);
  }
}

}  // namespace shd::color
