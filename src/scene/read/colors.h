// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "image/srgb.h"

namespace shd::scene {

/// An sRGB code of 0..1 as linear light. Codes out of range are clamped, NaN is 0. By custom, colours of vertices and
/// faces are sRGB codes in OBJ, PLY, STL and all formats but glTF.
inline float linear_of_srgb(float code) {
  return static_cast<float>(image::srgb_to_linear(code > 0.0f ? std::min(code, 1.0f) : 0.0f));
}

}  // namespace shd::scene
