// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace shd::texture {

/// A closed interval; empty by default.
struct Range {
  double low = HUGE_VAL, high = -HUGE_VAL;

  void add(double x) {
    if (x < low) low = x;
    if (x > high) high = x;
  }
  void add(const Range& other) {
    if (other.low < low) low = other.low;
    if (other.high > high) high = other.high;
  }
  double length() const { return high - low; }
};

/// The whole line: for values that are not finite, or that nothing bounds.
inline Range unbounded() {
  return {-HUGE_VAL, HUGE_VAL};
}

inline Range widened(const Range& range, double by) {
  return {range.low - by, range.high + by};
}

/// Intervals of the stored channels of a texel or of a result.
struct Color {
  Range channel[4];

  void add(const Color& other) {
    for (int c = 0; c < 4; ++c) channel[c].add(other.channel[c]);
  }
};

/// Returns (1 - s) a + s b. A side of weight 0 has no effect, even if it is infinite.
inline Color mix(const Color& a, const Color& b, double s) {
  if (s == 0.0) return a;
  if (s == 1.0) return b;
  Color out;
  for (int c = 0; c < 4; ++c) {
    out.channel[c] = {(1.0 - s) * a.channel[c].low + s * b.channel[c].low,
                      (1.0 - s) * a.channel[c].high + s * b.channel[c].high};
  }
  return out;
}

}  // namespace shd::texture
