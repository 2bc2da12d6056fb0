// SPDX-License-Identifier: MIT
// Normals turned by maps and heights, by direct formulas in long double.
#pragma once

#include "material/material.h"
#include "ref/shade_ref.h"

namespace shd::ref {

/// A normal in tangent space, and the variance of slopes removed by filtering its texel.
struct MappedNormal {
  Vector m;
  long double variance;
};

inline MappedNormal decode(const material::Material& material, const long double t[4]) {
  const long double s = material.normal_scale[0], r = material.normal_scale[1], x = 2 * t[0] - 1, y = 2 * t[1] - 1,
                    z = 2 * t[2] - 1;
  switch (material.normal_encoding) {
    case SHD_NORMAL_ENCODING_XY: {
      const long double rest = 1 - x * x - y * y;
      return {{s * x, r * y, rest > 0 ? sqrtl(rest) : 0}, 0};
    }
    case SHD_NORMAL_ENCODING_TOKSVIG: {
      const long double length = t[3] < 0.01L ? 0.01L : t[3];
      return {{s * x, r * y, z}, length < 1 ? s * s * (1 - length) / length : 0};
    }
    case SHD_NORMAL_ENCODING_MOMENTS: return {{s * t[0], r * t[1], 1}, 0};
    default: return {{s * x, r * y, z}, 0};
  }
}

/// Covariance of the scaled slopes of moments t and their mixed moment.
struct SlopeCovariance {
  long double xx, xy, yy;
};
inline SlopeCovariance slope_covariance(const material::Material& material, const long double t[4], long double mixed) {
  const long double s = material.normal_scale[0], r = material.normal_scale[1];
  const long double xx = s * s * (t[2] - t[0] * t[0]), yy = r * r * (t[3] - t[1] * t[1]);
  const long double largest = sqrtl(xx > 0 && yy > 0 ? xx * yy : 0), xy = s * r * (mixed - t[0] * t[1]);
  return {xx > 0 ? xx : 0, xy < -largest ? -largest : xy > largest ? largest : xy, yy > 0 ? yy : 0};
}

/// m in the basis t, w (n x t), n; the length of m is kept.
inline Vector from_tangent_space(Vector n, Vector t, long double side, Vector m) {
  return m.x * t + (side * m.y) * cross(n, t) + m.z * n;
}

/// n - grad h on a surface with the given derivatives of its points and of h.
inline Vector bumped(Vector n, Vector dpdu, Vector dpdv, long double dhdu, long double dhdv) {
  const long double area = dot(n, cross(dpdu, dpdv));
  return n - (1 / area) * (dhdu * cross(dpdv, n) + dhdv * cross(n, dpdu));
}

}  // namespace shd::ref
