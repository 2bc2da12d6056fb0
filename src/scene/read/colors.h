// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

namespace shd::scene {

/// An sRGB code of 0..1 as linear light (IEC 61966-2-1). Codes out of range are clamped, NaN is 0. By custom, colours
/// of vertices and faces are sRGB codes in OBJ, PLY, STL and all formats but glTF.
inline float linear_of_srgb(float code) {
  const float c = code > 0.0f ? std::min(code, 1.0f) : 0.0f;
  return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
}

}  // namespace shd::scene
