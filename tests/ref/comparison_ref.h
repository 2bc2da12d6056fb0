// SPDX-License-Identifier: MIT
// Comparison lookups by their definition: each texel becomes 0 or 1, and then the filter follows.
#pragma once

#include "ref/texture_ref.h"

namespace ref {

/// Vulkan 1.3 specification, "Depth Compare Operation". `reference` and `texel` are floats; NaN makes all comparisons
/// but ALWAYS false.
inline float compare(shd_compare compare, shd_format format, float reference, float texel) {
  const auto component = layout(format).component;
  const bool fixed_point =
      component != Layout::kFloat16 && component != Layout::kFloat32 && component != Layout::kRgb9e5;
  if (fixed_point && reference < 0) reference = 0;
  if (fixed_point && reference > 1) reference = 1;
  bool result = false;
  if (compare == SHD_COMPARE_LESS) result = reference < texel;
  if (compare == SHD_COMPARE_LESS_EQUAL) result = reference <= texel;
  if (compare == SHD_COMPARE_EQUAL) result = reference == texel;
  if (compare == SHD_COMPARE_GREATER_EQUAL) result = reference >= texel;
  if (compare == SHD_COMPARE_GREATER) result = reference > texel;
  if (compare == SHD_COMPARE_NOT_EQUAL) result = reference < texel || reference > texel;
  return result || compare == SHD_COMPARE_ALWAYS ? 1.0f : 0.0f;
}

}  // namespace ref
