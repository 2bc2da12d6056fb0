// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

namespace shd::data {

constexpr double kPi = 3.14159265358979323846;

/// Angle of the vector (x, y) for y >= 0, in [0, pi] [rad]; 0 for the zero vector. Arguments must be finite. Uses only
/// exactly rounded operations and sqrt, so that the bits are the same on every machine. tan(a / 2) = sin a / (1 + cos
/// a) reduces the angle below pi / 32, where eight terms of the Taylor series of the arctangent are sufficient. |error|
/// <= 1e-15 * angle + 1e-300.
inline double angle_of(double y, double x) {
  const double largest = std::fmax(y, std::fabs(x));
  if (!(largest > 0.0)) return 0.0;
  const double sine = y / largest;
  const double cosine = std::fabs(x) / largest;
  double t = sine / (cosine + std::sqrt(sine * sine + cosine * cosine));
  for (int i = 0; i < 3; ++i) t = t / (1.0 + std::sqrt(1.0 + t * t));
  const double square = t * t;
  double sum = 0.0;
  for (int k = 15; k >= 1; k -= 2) sum = ((k % 4 == 1) ? 1.0 : -1.0) / k + square * sum;
  const double angle = 16.0 * (t * sum);
  return x < 0.0 ? kPi - angle : angle;
}

namespace detail {

/// tan on [0, pi / 4] by the Taylor series of sine and cosine.
inline double tan_octant(double x) {
  const double square = x * x;
  double sine = 1.0;
  double cosine = 1.0;
  for (int k = 20; k >= 2; k -= 2) {
    sine = 1.0 - square * sine / (k * (k + 1.0));
    cosine = 1.0 - square * cosine / (k * (k - 1.0));
  }
  return x * sine / cosine;
}

}  // namespace detail

/// tan x for x in [0, pi / 2), bit-equal on all machines. |error| <= 1e-15 * tan x.
inline double tan(double x) {
  if (x <= 0.25 * kPi) return detail::tan_octant(x);
  constexpr double kHalfPiLow = 6.123233995736766e-17;  // pi / 2 minus its double
  return 1.0 / detail::tan_octant((0.5 * kPi - x) + kHalfPiLow);
}

/// cos x for x in [0, pi / 2], bit-equal on all machines. |error| <= 1e-15.
inline double cos(double x) {
  const double t = tan(0.5 * x), square = t * t;
  return (1.0 - square) / (1.0 + square);
}

/// sin x for x in [0, pi / 2]; the same bits on every machine. |error| <= 1e-15.
inline double sin(double x) {
  const double t = tan(0.5 * x);
  return (t + t) / (1.0 + t * t);
}

/// A point of the unit circle.
struct CirclePoint {
  double cosine, sine;
};

/// The point of the unit circle at angle 2 pi i / n, i <= n. Quarters are exact, and points that mirror each other in
/// an axis or a diagonal have the same bits except for signs; no zero is negative. |error| <= 1e-15.
inline CirclePoint circle_point(uint32_t i, uint32_t n) {
  const uint64_t eighths = uint64_t{8} * i;
  const auto octant = static_cast<uint32_t>(eighths / n);
  const uint64_t rest = eighths % n, from_axis = octant % 2 ? n - rest : rest;
  const double angle = 0.25 * kPi * (static_cast<double>(from_axis) / n);
  const double near_axis = cos(angle), far_axis = from_axis == n ? near_axis : sin(angle);
  const bool steep = octant % 4 == 1 || octant % 4 == 2;
  const double c = steep ? far_axis : near_axis, s = steep ? near_axis : far_axis;
  return {octant >= 2 && octant < 6 ? 0.0 - c : c, octant >= 4 && octant < 8 ? 0.0 - s : s};
}

}  // namespace shd::data
