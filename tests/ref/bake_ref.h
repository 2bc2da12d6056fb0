// SPDX-License-Identifier: MIT
// Conservative coverage and dilation by direct formulas: exact integers, every texel with every triangle.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "ref/raster_ref.h"

namespace shd::ref {

/// Whether a triangle (clockwise, y down) shares area with texel (x, y): no line separates their insides.
inline bool shares_area(const geometry::ScreenTriangle& t, int64_t x, int64_t y) {
  const int64_t left = 256 * x, top = 256 * y, right = left + 256, bottom = top + 256;
  const auto [low_x, high_x] = std::minmax({t.x[0], t.x[1], t.x[2]});
  const auto [low_y, high_y] = std::minmax({t.y[0], t.y[1], t.y[2]});
  if (high_x <= left || low_x >= right || high_y <= top || low_y >= bottom) return false;
  const int64_t corner[4][2] = {{left, top}, {right, top}, {left, bottom}, {right, bottom}};
  for (int k = 0; k < 3; ++k) {
    const int n = (k + 1) % 3;
    bool any_inside = false;
    for (const auto& c : corner) {
      any_inside |= Wide{t.x[n] - t.x[k]} * (c[1] - t.y[k]) - Wide{t.y[n] - t.y[k]} * (c[0] - t.x[k]) > 0;
    }
    if (!any_inside) return false;
  }
  return true;
}

/// The point of a triangle nearest to the centre of a texel, and its distance, in 1/256 texel.
struct NearestPoint {
  double x, y, distance;
};
inline NearestPoint nearest_point(const geometry::ScreenTriangle& t, int64_t px, int64_t py) {
  const int64_t x = 256 * px + 128, y = 256 * py + 128;
  bool inside = true;
  for (int k = 0; k < 3; ++k) {
    const int n = (k + 1) % 3;
    inside &= Wide{t.x[n] - t.x[k]} * (y - t.y[k]) - Wide{t.y[n] - t.y[k]} * (x - t.x[k]) >= 0;
  }
  NearestPoint best = {static_cast<double>(x), static_cast<double>(y), inside ? 0.0 : INFINITY};
  for (int k = 0; k < 3 && !inside; ++k) {
    const int n = (k + 1) % 3;
    const long double ex = t.x[n] - t.x[k], ey = t.y[n] - t.y[k];
    const long double square = ex * ex + ey * ey;
    long double s = square > 0 ? ((x - t.x[k]) * ex + (y - t.y[k]) * ey) / square : 0;
    s = std::min(std::max(s, 0.0L), 1.0L);
    const long double qx = t.x[k] + s * ex, qy = t.y[k] + s * ey;
    const auto distance = static_cast<double>(std::sqrt((qx - x) * (qx - x) + (qy - y) * (qy - y)));
    if (distance < best.distance) best = {static_cast<double>(qx), static_cast<double>(qy), distance};
  }
  return best;
}

/// The nearest filled texel within a radius, by squared distance, then row, then column; -1 = none.
inline int64_t nearest_texel(const std::vector<uint8_t>& filled, int64_t width, int64_t x, int64_t y, int64_t radius) {
  const auto height = static_cast<int64_t>(filled.size()) / width;
  int64_t best = -1, best_square = radius * radius;
  for (int64_t row = 0; row < height; ++row) {
    for (int64_t column = 0; column < width; ++column) {
      const int64_t square = (row - y) * (row - y) + (column - x) * (column - x);
      if (!filled[static_cast<size_t>(row * width + column)] || square > best_square) continue;
      if (square == best_square && best >= 0) continue;
      best = row * width + column;
      best_square = square;
    }
  }
  return best;
}

}  // namespace shd::ref
