// SPDX-License-Identifier: MIT
// The average of the bilinear reconstruction over a footprint, in two ways: closed form for rectangles along the axes,
// and many samples for any parallelogram.
#pragma once

#include "ref/footprint_ref.h"
#include "ref/slices_ref.h"

namespace ref {

/// Integral of the hat max(0, 1 - |x|) from minus infinity to t.
inline double hat_integral(double t) {
  if (t <= -1) return 0;
  if (t < 0) return (1 + t) * (1 + t) / 2;
  return t < 1 ? 1 - (1 - t) * (1 - t) / 2 : 1;
}

/// Average over a rectangle of width x height texels of a level around (u, v): texels times integrals of their hats.
inline double box_average(const Image& image, int level, double u, double v, double width, double height, int c) {
  const Level& l = image.levels[level];
  const double x = reduce(image.sampler->wrap_u, u) * static_cast<double>(l.width) - 0.5;
  const double y = reduce(image.sampler->wrap_v, v) * static_cast<double>(l.height) - 0.5;
  const double left = x - width / 2, right = x + width / 2, top = y - height / 2, bottom = y + height / 2;
  double sum = 0;
  for (auto j = static_cast<int64_t>(floor(top)); static_cast<double>(j) < bottom + 1; ++j) {
    const double weight_y = hat_integral(bottom - static_cast<double>(j)) - hat_integral(top - static_cast<double>(j));
    for (auto i = static_cast<int64_t>(floor(left)); static_cast<double>(i) < right + 1; ++i) {
      const double weight_x =
          hat_integral(right - static_cast<double>(i)) - hat_integral(left - static_cast<double>(i));
      if (weight_x * weight_y > 0) sum += weight_x * weight_y * texel(image, level, i, j, c);
    }
  }
  return sum / (width * height);
}

/// Average of n x n samples of level 0 over the parallelogram of the derivatives j of (u, v).
inline double parallelogram_average(const Image& image, double u, double v, const Jacobian& j, int n, int c) {
  double sum = 0;
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column < n; ++column) {
      const double s = (column + 0.5) / n - 0.5, t = (row + 0.5) / n - 0.5;
      sum += bilinear(image, 0, u + s * j.ux + t * j.uy, v + s * j.vx + t * j.vy, c);
    }
  }
  return sum / (static_cast<double>(n) * n);
}

/// Average of n x n samples of level 0 of a 3D texture over the parallelogram of the derivatives x and y.
inline double parallelogram_average(const Solid& solid, const Place& p, const Place& x, const Place& y, int n, int c) {
  double sum = 0;
  for (int k = 0; k < n * n; ++k) {
    const double s = (k % n + 0.5) / n - 0.5, t = (k / n + 0.5) / n - 0.5;
    sum += linear(solid, 0, {p.u + s * x.u + t * y.u, p.v + s * x.v + t * y.v, p.w + s * x.w + t * y.w}, c);
  }
  return sum / (n * n);
}

}  // namespace ref
