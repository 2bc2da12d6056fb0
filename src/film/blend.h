// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <shd/material.h>

namespace shd::film {

/// Colour and opacity of a fragment: the source of a blend, in the convention of the material's blend mode.
struct FragmentColor {
  float channel[4];
};

inline bool is_finite(const FragmentColor& color) {
  bool finite = true;
  for (const float c : color.channel) finite &= std::isfinite(c);
  return finite;
}

/// The stored colour of a sample: the destination of a blend.
struct Destination {
  float* channel[4];
};

/// Blends a source over its destination. The mode must be one that depends on the order of draws.
inline void blend(shd_blend mode, const FragmentColor& c, const Destination& destination) {
  const float rest = 1.0f - c.channel[3];
  for (int i = 0; i < 3; ++i) {
    float& d = *destination.channel[i];
    switch (mode) {
      case SHD_BLEND_PREMULTIPLIED: d = c.channel[i] + rest * d; break;
      case SHD_BLEND_STRAIGHT: d = c.channel[3] * c.channel[i] + rest * d; break;
      case SHD_BLEND_ADD: d = c.channel[i] + d; break;
      case SHD_BLEND_MULTIPLY: d = c.channel[i] * d + rest * d; break;
      default: d = c.channel[i]; break;
    }
  }
  float& a = *destination.channel[3];
  switch (mode) {
    case SHD_BLEND_PREMULTIPLIED:
    case SHD_BLEND_STRAIGHT: a = c.channel[3] + rest * a; break;
    case SHD_BLEND_ADD:
    case SHD_BLEND_MULTIPLY: break;
    default: a = c.channel[3]; break;
  }
}

}  // namespace shd::film
