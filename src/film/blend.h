// SPDX-License-Identifier: MIT
#pragma once

#include <shd/material.h>

#include "raster/tile.h"

namespace shd::film {

/// Colours of one sample of the pixels of a tile: those of the frame where a pixel has one sample, else of a worker,
/// where the samples of a pixel lie together, r, g, b, a for each.
struct SampleColor {
  float* channel[4];
  size_t row, step;  // elements between rows and between pixels

  size_t at(uint32_t pixel) const { return pixel / raster::kTile * row + pixel % raster::kTile * step; }
};

/// The colour and opacity of a fragment, as the material's model and blend have them.
struct FragmentColor {
  float channel[4];
};

/// Puts one colour over another, both channels r, g, b, a, by a blend that has an order.
inline void blend(shd_blend_mode mode, const FragmentColor& c, float* const below[4]) {
  const float rest = 1.0f - c.channel[3];
  for (int i = 0; i < 3; ++i) {
    float& d = *below[i];
    switch (mode) {
      case SHD_BLEND_PREMULTIPLIED: d = c.channel[i] + rest * d; break;
      case SHD_BLEND_STRAIGHT: d = c.channel[3] * c.channel[i] + rest * d; break;
      case SHD_BLEND_ADD: d = c.channel[i] + d; break;
      case SHD_BLEND_MULTIPLY: d = c.channel[i] * d + rest * d; break;
      default: d = c.channel[i]; break;
    }
  }
  float& a = *below[3];
  switch (mode) {
    case SHD_BLEND_PREMULTIPLIED:
    case SHD_BLEND_STRAIGHT: a = c.channel[3] + rest * a; break;
    case SHD_BLEND_ADD:
    case SHD_BLEND_MULTIPLY: break;
    default: a = c.channel[3]; break;
  }
}

}  // namespace shd::film
