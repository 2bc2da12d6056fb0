// SPDX-License-Identifier: MIT
#pragma once

#include <shd/sampler.h>

namespace shd::data {

/// Results of a comparison z OP d where z is less than, equal to and greater than d.
struct Comparison {
  bool less, equal, greater;

  /// Result where z or d is NaN.
  constexpr bool unordered() const { return less && equal && greater; }
};

constexpr Comparison comparison_of(shd_compare compare) {
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

/// Returns the result of one comparison.
constexpr bool passes(const Comparison& comparison, float z, float d) {
  if (z < d) return comparison.less;
  if (z > d) return comparison.greater;
  return z == d ? comparison.equal : comparison.unordered();
}

}  // namespace shd::data
