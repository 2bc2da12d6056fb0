// SPDX-License-Identifier: MIT
// The footprint of a pixel and the probes along it in doubles: the oracle of anisotropic filters.
#pragma once

#include <math.h>

#include "ref/texture_ref.h"

namespace ref {

/// Derivatives of (u, v) in x and y.
struct Jacobian {
  double ux, vx, uy, vy;
};

/// The symmetric matrix J J^T: squared half axes of the ellipse are its eigenvalues.
struct Covariance {
  double uu, uv, vv;
};

/// J diag(width^2) J^T + diag(blur^2), then (u, v) in texels of w x h.
inline Covariance covariance(const Jacobian& j, const shd_sampler_desc& s, double w, double h) {
  const double wx = static_cast<double>(s.width_x), wy = static_cast<double>(s.width_y);
  const double bu = static_cast<double>(s.blur_u), bv = static_cast<double>(s.blur_v);
  const double ux = j.ux * wx * w, uy = j.uy * wy * w, vx = j.vx * wx * h, vy = j.vy * wy * h;
  return {ux * ux + uy * uy + bu * bu * w * w, ux * vx + uy * vy, vx * vx + vy * vy + bv * bv * h * h};
}

/// The ellipse: half axes a >= b and the direction of the longer one.
struct Ellipse {
  double a, b, u, v;
};

inline Ellipse ellipse(const Covariance& c) {
  const double angle = 0.5 * atan2(2 * c.uv, c.uu - c.vv);
  const double cosine = cos(angle), sine = sin(angle);
  const double square = (c.uu + c.vv) / 2 + hypot((c.uu - c.vv) / 2, c.uv);
  const double other = (c.uu + c.vv) / 2 - hypot((c.uu - c.vv) / 2, c.uv);
  return {sqrt(square), sqrt(fmax(other, 0)), cosine, sine};
}

/// The ellipse computed from the derivatives in texels, so that the shorter axis does not cancel.
inline Ellipse ellipse(const Jacobian& j) {
  Ellipse e = ellipse(Covariance{j.ux * j.ux + j.uy * j.uy, j.ux * j.vx + j.uy * j.vy, j.vx * j.vx + j.vy * j.vy});
  e.b = e.a > 0 ? fabs(j.ux * j.vy - j.uy * j.vx) / e.a : 0;
  return e;
}

/// Ratio of longer to shorter axis, limited.
inline double aspect(const Ellipse& e, double limit) {
  return e.a == 0 ? 1 : e.a > limit * e.b ? limit : e.a / e.b;
}

/// A coordinate with the same texels around it; if it has a period, it is small enough for exact doubles.
inline double whole_period(shd_wrap wrap, double u) {
  const bool periodic = wrap == SHD_WRAP_REPEAT || wrap == SHD_WRAP_MIRROR;
  return periodic || !isfinite(u) ? reduce(wrap, u) : u;
}

/// The average of `count` trilinear lookups of level lambda along the longer axis.
inline double anisotropic_at(const Image& image, const Ellipse& e, double lambda, int count, double u, double v,
                             int c) {
  const double w = static_cast<double>(image.levels[0].width), h = static_cast<double>(image.levels[0].height);
  double sum = 0, total = 0;
  for (int k = 0; k < count; ++k) {
    const double t = (2.0 * k + 1 - count) / (2.0 * count);
    const bool gaussian = image.sampler->probe_weights == SHD_PROBE_WEIGHTS_GAUSSIAN;
    const double weight = gaussian ? exp(-8 * t * t) : 1;
    sum += weight * trilinear(image, whole_period(image.sampler->wrap_u, u) + t * e.a * e.u / w,
                              whole_period(image.sampler->wrap_v, v) + t * e.a * e.v / h, lambda, c);
    total += weight;
  }
  return sum / total;
}

/// Anisotropic lookup on the level of SHD_PROFILE_EXACT.
inline double anisotropic(const Image& image, const Ellipse& e, int count, double u, double v, int c) {
  const double ratio = aspect(e, static_cast<double>(image.sampler->max_anisotropy));
  return anisotropic_at(image, e, log2(e.a / ratio), count, u, v, c);
}

}  // namespace ref
