// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "light/shadow.h"

namespace shd::light {

/// Scale of summed depths: relative to the middle of the range, in units of the range, -1/2..1/2. Depths are multiples
/// of 2^-25, squares are multiples of 2^-28. Sums of 2^26 depths or squares are exact in double. Lauritzen,
/// "Summed-Area Variance Shadow Maps", GPU Gems 3, 2007, 8.5, sums integers for the same reason.
struct SumScale {
  double middle, range;
};

inline SumScale sum_scale(const ShadowPlacement& placement) {
  const double near = static_cast<double>(placement.near), far = static_cast<double>(placement.far);
  return {0.5 * (near + far), far - near};
}

/// Depths beyond the range are clamped to it, so that empty texels have the far depth.
inline double quantized_depth(const SumScale& scale, float depth) {
  const double s = (static_cast<double>(depth) - scale.middle) / scale.range;
  return std::floor(std::fmin(std::fmax(s, -0.5), 0.5) * 0x1p25 + 0.5) * 0x1p-25;
}

inline double quantized_square(double s) {
  return std::floor(s * s * 0x1p28 + 0.5) * 0x1p-28;
}

}  // namespace shd::light
