// SPDX-License-Identifier: MIT
#pragma once

#include "image/channel.h"
#include "io/bitmap/bitmap.h"

namespace shd::extension {

struct Rgba {
  double value[4];  // linear
};

// Texels of the formats of linear bitmaps: RGBA8, RGBA8_SRGB, RGBA16F and RGBA32F.

inline Rgba load_texel(shd_format format, const unsigned char* texel) {
  const image::FormatInfo info = image::format_info(format);
  Rgba color;
  for (size_t c = 0; c < 4; ++c) {
    color.value[c] = image::load_channel(image::channel_component(info, c), texel + c * info.channel_size);
  }
  return color;
}

/// Stores the first `channels` of r, g, b and a.
inline void store_texel(shd_format format, const Rgba& color, size_t channels, unsigned char* texel) {
  const image::FormatInfo info = image::format_info(format);
  for (size_t c = 0; c < channels; ++c) {
    image::store_channel(image::channel_component(info, c), color.value[c], texel + c * info.channel_size);
  }
}

/// Whether alpha is 1 in the base level of a bitmap.
inline bool is_opaque(const io::Bitmap& bitmap) {
  const size_t pixel = io::bitmap_pixel_size(bitmap.format);
  const unsigned char* const end = bitmap.pixels.data() + size_t{bitmap.width} * bitmap.height * pixel;
  for (const unsigned char* texel = bitmap.pixels.data(); texel != end; texel += pixel) {
    if (load_texel(bitmap.format, texel).value[3] < 1) return false;
  }
  return true;
}

}  // namespace shd::extension
