// SPDX-License-Identifier: MIT
// Levels of detail of SHD_PROFILE_LEAST_ERROR in doubles, after the text of <shd/sampler.h>.
#pragma once

#include <math.h>

#include "ref/footprint_ref.h"

namespace ref {

constexpr double kFinerLevel = 3.0 / 8;

/// Level of an isotropic lookup: the squares of the half axes add up to the squares of the derivatives in texels.
inline double least_error_lambda(const Jacobian& j, double w, double h) {
  return log2(hypot(hypot(j.ux * w, j.vx * h), hypot(j.uy * w, j.vy * h)) / sqrt(2.0)) - kFinerLevel;
}

/// Level of the probes: the longer axis is divided into as many parts as the limit of anisotropy allows.
inline double least_error_probe_lambda(const Ellipse& e, double limit) {
  const double ratio = aspect(e, limit);
  return log2(hypot(e.a / ratio, e.b) / sqrt(2.0)) - 1.0 / 8 - 1 / (4 * ratio);
}

}  // namespace ref
