// SPDX-License-Identifier: MIT
#pragma once

#include <shd/render.h>

#include "data/compare.h"

namespace shd::raster {

/// Depth test and depth bias of a draw.
struct DepthState {
  shd_compare compare;
  bool writes;
  float bias, slope_bias;  // slope_bias is a factor of the larger of |dz/dx| and |dz/dy| per pixel
};

constexpr bool is_biased(const DepthState& state) {
  return state.bias != 0.0f || state.slope_bias != 0.0f;
}

using DepthTest = data::Comparison;
using data::passes;

constexpr DepthTest depth_test(shd_compare compare) {
  return data::comparison_of(compare);
}

}  // namespace shd::raster
