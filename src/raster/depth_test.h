// SPDX-License-Identifier: MIT
#pragma once

#include <shd/render.h>

namespace shd::raster {

/// Depth test and depth bias of a draw.
struct DepthState {
  shd_compare compare;
  bool writes;
  float bias, slope_bias;  // slope_bias is a factor of the larger of |dz/dx| and |dz/dy| per pixel
};

/// Outcome of the comparison for new depths less than, equal to and greater than the stored depth.
struct DepthTest {
  bool less, equal, greater;
};

constexpr DepthTest depth_test(shd_compare compare) {
  switch (compare) {
    case SHD_COMPARE_LESS: return {true, false, false};
    case SHD_COMPARE_LESS_EQUAL: return {true, true, false};
    case SHD_COMPARE_EQUAL: return {false, true, false};
    case SHD_COMPARE_GREATER_EQUAL: return {false, true, true};
    case SHD_COMPARE_GREATER: return {false, false, true};
    case SHD_COMPARE_NOT_EQUAL: return {true, false, true};
    case SHD_COMPARE_ALWAYS: return {true, true, true};
    default: return {false, false, false};
  }
}

/// Whether depth z passes against the stored depth; neither is NaN.
constexpr bool passes(const DepthTest& test, float z, float stored) {
  return z < stored ? test.less : z > stored ? test.greater : test.equal;
}

}  // namespace shd::raster
