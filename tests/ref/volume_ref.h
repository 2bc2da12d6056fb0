// SPDX-License-Identifier: MIT
// Rays through a volume in doubles, step by step: the oracle of volume rendering.
#pragma once

#include <math.h>

#include <shd/volume.h>

#include "ref/slices_ref.h"

namespace ref {

/// A transfer function: [count] points, each density, extinction, r, g, b.
struct TransferFunction {
  const double (*point)[5];
  int count;

  /// Value c: 0 = extinction, 1..3 = colour.
  double operator()(double density, int c) const {
    if (isnan(density)) density = 0;
    if (density < point[0][0]) return point[0][1 + c];
    for (int k = count - 1; k >= 0; --k) {
      if (density < point[k][0]) continue;
      if (k == count - 1) return point[k][1 + c];
      const double s = (density - point[k][0]) / (point[k + 1][0] - point[k][0]);
      return (1 - s) * point[k][1 + c] + s * point[k + 1][1 + c];
    }
    return point[0][1 + c];
  }
};

/// Colour and opacity of `count` steps from `origin` on, in the box.
inline void march(const Solid& solid, const TransferFunction& transfer, const Place& origin, const Place& step,
                  double offset, double dt, int count, double (&out)[4]) {
  for (double& value : out) value = 0;
  for (int k = 0; k < count && out[3] <= 0.999; ++k) {
    const double t = k + offset;
    const Place at = {origin.u + t * step.u, origin.v + t * step.v, origin.w + t * step.w};
    const double density = linear(solid, 0, at, 0);
    const double opacity = -expm1(-transfer(density, 0) * dt);
    for (int c = 0; c < 3; ++c) out[c] += (1 - out[3]) * opacity * transfer(density, 1 + c);
    out[3] += (1 - out[3]) * opacity;
  }
}

}  // namespace ref
