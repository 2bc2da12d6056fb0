// SPDX-License-Identifier: MIT
// Reflection of uniform light of radiance 1 by the lobes of the models, as integrals over half vectors or directions
// around an axis. Sums over the azimuth are exact for the lobes with an exponent.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace shd::ref {

constexpr double kReflectionPi = 3.14159265358979323846;

/// Integral of f over a..b, by the substitution tanh(pi / 2 sinh t) (Takahasi and Mori, "Double Exponential Formulas
/// for Numerical Integration", 1974), which takes roots and poles at both ends.
template <class F>
double integral(double a, double b, const F& f) {
  constexpr int kHalf = 16;
  struct Node {
    double place, weight;
  };
  static const auto nodes = [] {
    std::array<Node, 2 * kHalf + 1> all;
    for (int i = -kHalf; i <= kHalf; ++i) {
      const double t = 0.18 * i, s = 0.5 * kReflectionPi * std::sinh(t);
      all[static_cast<size_t>(i + kHalf)] = {
          0.5 + 0.5 * std::tanh(s), 0.18 * 0.25 * kReflectionPi * std::cosh(t) / (std::cosh(s) * std::cosh(s))};
    }
    return all;
  }();
  double sum = 0.0;
  for (const Node& node : nodes) sum += node.weight * f(a + (b - a) * node.place);
  return (b - a) * sum;
}

/// The azimuth up to which directions at the angle of (c, s) from an axis in the plane of x and z, at the angle of
/// (axis_c, axis_s) from +Z, have z > 0.
inline double azimuth_above(double c, double s, double axis_c, double axis_s) {
  const double up = c * axis_c, across = s * axis_s;
  return up >= across ? kReflectionPi : up <= -across ? 0.0 : std::acos(-up / across);
}

/// Integral of max(0, l.r)^p over l with n.l > 0, where r.n = v.n = n_dot_v.
inline double phong_reflection(double p, double n_dot_v) {
  const double sine = std::sqrt(1.0 - n_dot_v * n_dot_v), edge = std::asin(n_dot_v), width = 2.0 / std::sqrt(p + 4.0);
  const auto ring = [&](double x) {
    const double angle = std::atan(width * std::tan(x)), t = std::tan(x);
    const double slope = width * (1.0 + t * t) / (1.0 + width * width * t * t);
    return slope * std::pow(std::cos(angle), p) * std::sin(angle) * 2.0 *
           azimuth_above(std::cos(angle), std::sin(angle), n_dot_v, sine);
  };
  const double near = std::atan(std::tan(edge) / width);
  return integral(0.0, near, ring) + integral(near, 0.5 * kReflectionPi, ring);
}

/// Integral of body(angle of h, azimuth up to which n.l > 0) over the angle between n and half vectors h, of which
/// light comes. `width` is the angle in which the integrand changes most.
template <class Body>
double over_half_vectors(double n_dot_v, double width, const Body& body) {
  const double tilt = std::acos(n_dot_v), sine = std::sqrt(1.0 - n_dot_v * n_dot_v);
  const auto to = [&](double angle) { return std::atan(std::tan(angle) / width); };
  const auto ring = [&](double x) {
    const double angle = std::atan(width * std::tan(x)), t = std::tan(x);
    const double slope = width * (1.0 + t * t) / (1.0 + width * width * t * t);
    return slope * body(angle, azimuth_above(std::cos(2.0 * angle), std::sin(2.0 * angle), n_dot_v, sine));
  };
  const double near = to(0.25 * kReflectionPi - 0.5 * tilt), far = to(0.25 * kReflectionPi + 0.5 * tilt);
  return integral(0.0, near, ring) + integral(near, far, ring);
}

/// Integral of max(0, n.h)^p, times n.l if `cosine`, over l with n.l > 0. The solid angle of l is 4 v.h times that of
/// h.
inline double blinn_phong_reflection(double p, double n_dot_v, bool cosine) {
  const double sine = std::sqrt(1.0 - n_dot_v * n_dot_v);
  return over_half_vectors(n_dot_v, 2.0 / std::sqrt(p + 4.0), [&](double angle, double end) {
    const double c = std::cos(angle), s = std::sin(angle), a = c * n_dot_v, b = s * sine;
    const double sum = a * end + b * std::sin(end);  // sum of v.h over half of the azimuths
    const double squares = a * a * end + 2.0 * a * b * std::sin(end) + b * b * (0.5 * end + 0.25 * std::sin(2.0 * end));
    return 8.0 * std::pow(c, p) * s * (cosine ? 2.0 * c * squares - n_dot_v * sum : sum);
  });
}

/// Integral of D V n.l with the Fresnel factor 1 (F0 = 1), and of its part with (1 - v.h)^5 (F0 = 0).
struct GgxReflection {
  double white, black;
};
inline GgxReflection ggx_reflection(double alpha, double n_dot_v) {
  const double sine = std::sqrt(1.0 - n_dot_v * n_dot_v), a2 = alpha * alpha;
  const auto shadowed = [&](double c) { return std::sqrt(a2 + (1.0 - a2) * c * c); };
  const auto part = [&](bool black) {
    return over_half_vectors(n_dot_v, alpha, [&](double angle, double end) {
      const double c = std::cos(angle), s = std::sin(angle), spread = c * c * a2 + s * s;
      const double d = a2 / (kReflectionPi * spread * spread);
      return s * d * integral(0.0, end, [&](double phi) {
               const double v_dot_h = c * n_dot_v + s * sine * std::cos(phi), n_dot_l = 2.0 * v_dot_h * c - n_dot_v;
               if (n_dot_l <= 0.0) return 0.0;
               const double f = black ? std::pow(std::max(0.0, 1.0 - v_dot_h), 5) : 1.0;
               return 4.0 * f * v_dot_h * n_dot_l / (n_dot_l * shadowed(n_dot_v) + n_dot_v * shadowed(n_dot_l));
             });
    });
  };
  return {part(false), part(true)};
}

/// Integral of n.l (1 - (1 - v.h)^5) / pi.
inline double diffuse_reflection(double n_dot_v) {
  const double sine = std::sqrt(1.0 - n_dot_v * n_dot_v);
  return integral(0.0, 0.5 * kReflectionPi, [&](double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return 2.0 / kReflectionPi * c * s * integral(0.0, kReflectionPi, [&](double phi) {
             const double v_dot_l = c * n_dot_v + s * sine * std::cos(phi);
             return 1.0 - std::pow(1.0 - std::sqrt(std::max(0.0, 0.5 + 0.5 * v_dot_l)), 5);
           });
  });
}

}  // namespace shd::ref
