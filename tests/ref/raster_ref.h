// SPDX-License-Identifier: MIT
// Coverage, depth and perspective-correct interpolation by direct formulas, with exact integers and 113-bit reals.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "geometry/assemble.h"

namespace shd::ref {

__extension__ typedef __int128 Wide;
#ifdef __SIZEOF_FLOAT128__
__extension__ typedef __float128 Real;
#else
typedef long double Real;
#endif

inline Real magnitude(Real x) {
  return x < 0 ? -x : x;
}

/// Sign of (q - p) x (c - p), with c moved right by e and down by e^2 for an infinitesimal e. A centre on a left edge
/// moves inside, a centre on a right edge outside; on horizontal edges the step down decides in the same way.
inline int side(int64_t px, int64_t py, int64_t qx, int64_t qy, int64_t cx, int64_t cy) {
  const Wide cross = Wide{qx - px} * (cy - py) - Wide{qy - py} * (cx - px);
  if (cross != 0) return cross > 0 ? 1 : -1;
  if (qy != py) return qy < py ? 1 : -1;
  return qx > px ? 1 : -1;
}

/// Whether a sample of pixel (x, y), by default its centre, is inside the triangle, or on a left or top edge. Any
/// winding.
inline bool covers(const geometry::ScreenTriangle& t, int64_t x, int64_t y, int64_t sample_x = 128,
                   int64_t sample_y = 128) {
  const int64_t cx = 256 * x + sample_x, cy = 256 * y + sample_y;
  const int s = side(t.x[0], t.y[0], t.x[1], t.y[1], cx, cy);
  return s == side(t.x[1], t.y[1], t.x[2], t.y[2], cx, cy) && s == side(t.x[2], t.y[2], t.x[0], t.y[0], cx, cy);
}

/// Depth at a sample of a pixel on the plane through the three vertices, clamped to their range.
struct Depth {
  double value;
  double scale;  // |base| + |dx (x - x0)| + |dy (y - y0)|, to which rounding errors are proportional
};
inline Depth depth_at(const geometry::ScreenTriangle& t, int64_t x, int64_t y, int64_t sample_x = 128,
                      int64_t sample_y = 128) {
  const Real x1 = t.x[1] - t.x[0], y1 = t.y[1] - t.y[0], x2 = t.x[2] - t.x[0], y2 = t.y[2] - t.y[0];
  const Real z0 = t.z[0], z1 = t.z[1] - z0, z2 = t.z[2] - z0;
  const Real area = x1 * y2 - x2 * y1;
  const Real dx = (z1 * y2 - z2 * y1) / area, dy = (z2 * x1 - z1 * x2) / area;
  const Real along_x = dx * (256 * x + sample_x - t.x[0]), along_y = dy * (256 * y + sample_y - t.y[0]);
  const double value = static_cast<double>(z0 + along_x + along_y);
  const double low = std::min({t.z[0], t.z[1], t.z[2]}), high = std::max({t.z[0], t.z[1], t.z[2]});
  const Real margin = 256 * (magnitude(dx) + magnitude(dy));  // the plane's origin is a sample near vertex 0
  return {std::min(std::max(value, low), high),
          static_cast<double>(magnitude(z0) + magnitude(along_x) + magnitude(along_y) + 2 * margin)};
}

/// Weights of the three vertices at a raster position, and their derivatives per pixel.
struct Weights {
  Real b[3], dx[3], dy[3];
};

/// Screen-space barycentric coordinates of raster position (x, y) (Shirley et al., "Fundamentals of Computer Graphics",
/// 2009, section 2.7) made perspective-correct (section 11.2.4 of the second edition):
/// d = h1 h2 + h2 beta (h0 - h1) + h1 gamma (h0 - h2), beta_w = h0 h2 beta / d, gamma_w = h0 h1 gamma / d.
/// v: [3][4] X, Y, Z, W with W != 0. Derivatives by the quotient rule.
inline Weights perspective_weights(const float (*v)[4], double x, double y) {
  Real sx[3], sy[3], h[3];
  for (int k = 0; k < 3; ++k) {
    h[k] = v[k][3];
    sx[k] = v[k][0] / h[k];
    sy[k] = v[k][1] / h[k];
  }
  const Real area = (sx[1] - sx[0]) * (sy[2] - sy[0]) - (sx[2] - sx[0]) * (sy[1] - sy[0]);
  const Real beta = ((x - sx[0]) * (sy[2] - sy[0]) - (sx[2] - sx[0]) * (y - sy[0])) / area;
  const Real gamma = ((sx[1] - sx[0]) * (y - sy[0]) - (x - sx[0]) * (sy[1] - sy[0])) / area;
  const Real beta_dx = (sy[2] - sy[0]) / area, beta_dy = (sx[0] - sx[2]) / area;
  const Real gamma_dx = (sy[0] - sy[1]) / area, gamma_dy = (sx[1] - sx[0]) / area;
  const Real d = h[1] * h[2] + h[2] * beta * (h[0] - h[1]) + h[1] * gamma * (h[0] - h[2]);
  const auto slope = [&](Real a, Real c) { return h[2] * a * (h[0] - h[1]) + h[1] * c * (h[0] - h[2]); };
  const Real d_dx = slope(beta_dx, gamma_dx), d_dy = slope(beta_dy, gamma_dy);
  const Real h02 = h[0] * h[2], h01 = h[0] * h[1];
  Weights w;
  w.b[1] = h02 * beta / d;
  w.b[2] = h01 * gamma / d;
  w.dx[1] = h02 * (beta_dx * d - beta * d_dx) / (d * d);
  w.dy[1] = h02 * (beta_dy * d - beta * d_dy) / (d * d);
  w.dx[2] = h01 * (gamma_dx * d - gamma * d_dx) / (d * d);
  w.dy[2] = h01 * (gamma_dy * d - gamma * d_dy) / (d * d);
  w.b[0] = 1 - w.b[1] - w.b[2];
  w.dx[0] = 0 - w.dx[1] - w.dx[2];
  w.dy[0] = 0 - w.dy[1] - w.dy[2];
  return w;
}

/// The weights for any W, by Cramer's rule on b0 V0 + b1 V1 + b2 V2 = s (x, y, 1).
inline Weights homogeneous_weights(const float (*v)[4], double x, double y) {
  Real e[3], e_dx[3], e_dy[3], sum = 0, sum_dx = 0, sum_dy = 0;
  for (int k = 0; k < 3; ++k) {
    const float *p = v[(k + 1) % 3], *q = v[(k + 2) % 3];
    e_dx[k] = Real{p[1]} * q[3] - Real{q[1]} * p[3];
    e_dy[k] = Real{q[0]} * p[3] - Real{p[0]} * q[3];
    e[k] = e_dx[k] * x + e_dy[k] * y + (Real{p[0]} * q[1] - Real{q[0]} * p[1]);
    sum += e[k];
    sum_dx += e_dx[k];
    sum_dy += e_dy[k];
  }
  Weights w;
  for (int k = 0; k < 3; ++k) {
    w.b[k] = e[k] / sum;
    w.dx[k] = (e_dx[k] * sum - e[k] * sum_dx) / (sum * sum);
    w.dy[k] = (e_dy[k] * sum - e[k] * sum_dy) / (sum * sum);
  }
  return w;
}

/// W at the point of the weights; a point that is seen has W > 0.
inline Real interpolated_w(const float (*v)[4], const Weights& weights) {
  return weights.b[0] * v[0][3] + weights.b[1] * v[1][3] + weights.b[2] * v[2][3];
}

/// A float calculation in exact arithmetic: its true value, and a bound of the rounding error of the float result.
/// Running error analysis: Higham, "Accuracy and Stability of Numerical Algorithms" (2002), section 3.3.
struct Bounded {
  Real value;
  double error;
};
inline double unit_roundoff(Real exact, double error) {
  return 0x1p-24 * (static_cast<double>(magnitude(exact)) + error) + 0x1p-149;
}
inline Bounded rounded(Real value, double error) {
  return {value, error + unit_roundoff(value, error)};
}
inline Bounded exactly(double value) {
  return {value, 0.0};
}
inline Bounded operator+(Bounded a, Bounded b) {
  return rounded(a.value + b.value, a.error + b.error);
}
inline Bounded operator-(Bounded a, Bounded b) {
  return rounded(a.value - b.value, a.error + b.error);
}
inline Bounded operator*(Bounded a, Bounded b) {
  const auto size_a = static_cast<double>(magnitude(a.value)), size_b = static_cast<double>(magnitude(b.value));
  return rounded(a.value * b.value, size_a * b.error + size_b * a.error + a.error * b.error);
}
inline Bounded inverse(Bounded a) {
  const auto size = static_cast<double>(magnitude(a.value));
  if (!(size > 2.0 * a.error)) return {0, HUGE_VAL};
  return rounded(1 / a.value, a.error / (size * (size - a.error)));
}

}  // namespace shd::ref
