// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstring>

#include "image/half.h"
#include "image/srgb.h"
#include "io/io.h"

namespace shd::extension {

struct Rgba {
  double value[4];  // linear
};

/// Reads and writes texels of the formats of linear bitmaps: RGBA8, RGBA8_SRGB, RGBA16F and RGBA32F.
class LinearTexels {
 public:
  explicit LinearTexels(shd_format format) : format_(format) {
    for (size_t code = 0; code < 256; ++code) {
      const double value = static_cast<double>(code) / 255;
      light_[code] = format == SHD_FORMAT_RGBA8_SRGB ? image::srgb_to_linear(value) : value;
    }
  }

  Rgba load(const unsigned char* texel) const {
    Rgba out = {};
    for (size_t c = 0; c < 4; ++c) {
      if (format_ == SHD_FORMAT_RGBA32F) {
        float number;
        std::memcpy(&number, texel + 4 * c, sizeof number);
        out.value[c] = static_cast<double>(number);
      } else if (format_ == SHD_FORMAT_RGBA16F) {
        uint16_t half;
        std::memcpy(&half, texel + 2 * c, sizeof half);
        out.value[c] = static_cast<double>(image::half_to_float(half));
      } else {
        out.value[c] = c < 3 ? light_[texel[c]] : texel[c] / 255.0;
      }
    }
    return out;
  }

  /// Stores r, g and b.
  void store_color(const Rgba& color, unsigned char* texel) const {
    for (size_t c = 0; c < 3; ++c) {
      const auto number = static_cast<float>(color.value[c]);
      if (format_ == SHD_FORMAT_RGBA32F) {
        std::memcpy(texel + 4 * c, &number, sizeof number);
      } else if (format_ == SHD_FORMAT_RGBA16F) {
        const uint16_t half = image::float_to_half(number);
        std::memcpy(texel + 2 * c, &half, sizeof half);
      } else {
        const auto* const end = light_ + 256;
        const auto* const above = std::lower_bound(light_, end, color.value[c]);
        const bool lower = above == end || (above > light_ && color.value[c] - above[-1] < *above - color.value[c]);
        texel[c] = static_cast<unsigned char>(above - light_ - (lower ? 1 : 0));
      }
    }
  }

  /// Stores r, g, b and a; float formats only.
  void store(const Rgba& color, unsigned char* texel) const {
    store_color(color, texel);
    const auto alpha = static_cast<float>(color.value[3]);
    const uint16_t half = image::float_to_half(alpha);
    if (format_ == SHD_FORMAT_RGBA32F) std::memcpy(texel + 12, &alpha, sizeof alpha);
    if (format_ == SHD_FORMAT_RGBA16F) std::memcpy(texel + 6, &half, sizeof half);
  }

  /// Whether alpha is 1 in the base level of a bitmap of the format.
  bool is_opaque(const io::Bitmap& bitmap) const {
    const size_t pixel = io::bitmap_pixel_size(format_);
    const unsigned char* const end = bitmap.pixels.data() + size_t{bitmap.width} * bitmap.height * pixel;
    for (const unsigned char* texel = bitmap.pixels.data(); texel != end; texel += pixel) {
      if (load(texel).value[3] < 1) return false;
    }
    return true;
  }

 private:
  shd_format format_;
  double light_[256];  // value of each code
};

}  // namespace shd::extension
