// SPDX-License-Identifier: MIT
// Wide lines by direct formulas: a segment in homogeneous raster coordinates, clipped by all planes together, and the
// rectangle around it.
#pragma once

#include <algorithm>
#include <cmath>

namespace shd::ref {

/// The rest of a clipped segment, in pixels, with its depths.
struct Segment {
  bool any;
  double x[2], y[2], z[2];
};

/// The part of a + t (b - a) with W >= 2^-100, 0 <= Z <= W and |X|, |Y| <= 2^20 W. Liang and Barsky, "A New Concept and
/// Method for Line Clipping" (1984).
inline Segment clip_segment(const float a[4], const float b[4]) {
  long double low = 0, high = 1, from[4], step[4];
  for (int c = 0; c < 4; ++c) {
    from[c] = a[c];
    step[c] = static_cast<long double>(b[c]) - a[c];
  }
  // Rows of factors of X, Y, Z, W: a point is inside if sum + constant >= 0.
  constexpr long double kGuard = 1048576.0L;
  const long double planes[7][4] = {{0, 0, 0, 1},       {0, 0, 1, 0},      {0, 0, -1, 1},     {1, 0, 0, kGuard},
                                    {-1, 0, 0, kGuard}, {0, 1, 0, kGuard}, {0, -1, 0, kGuard}};
  for (int p = 0; p < 7; ++p) {
    long double at = p == 0 ? -0x1p-100L : 0.0L, slope = 0;
    for (int c = 0; c < 4; ++c) {
      at += planes[p][c] * from[c];
      slope += planes[p][c] * step[c];
    }
    if (slope > 0) {
      low = std::max(low, -at / slope);
    } else if (slope < 0) {
      high = std::min(high, -at / slope);
    } else if (at < 0) {
      return {};
    }
  }
  if (!(low <= high)) return {};
  Segment s = {true, {}, {}, {}};
  for (int k = 0; k < 2; ++k) {
    const long double t = k ? high : low;
    const long double w = from[3] + t * step[3];
    if (!(w > 0)) return {};
    s.x[k] = static_cast<double>((from[0] + t * step[0]) / w);
    s.y[k] = static_cast<double>((from[1] + t * step[1]) / w);
    s.z[k] = static_cast<double>((from[2] + t * step[2]) / w);
  }
  return s;
}

/// Position of a point relative to the rectangle of a line: distance inside (negative: outside) [pixels], and position
/// along it.
struct LinePlace {
  double inside, along;
};
inline LinePlace place_at(const Segment& s, double width, double x, double y) {
  const double dx = s.x[1] - s.x[0], dy = s.y[1] - s.y[0], length = std::hypot(dx, dy);
  const double along = ((x - s.x[0]) * dx + (y - s.y[0]) * dy) / length;
  const double across = std::fabs((x - s.x[0]) * dy - (y - s.y[0]) * dx) / length;
  return {std::min({width / 2 - across, along, length - along}), along / length};
}

}  // namespace shd::ref
