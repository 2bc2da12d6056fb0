/* SPDX-License-Identifier: MIT */
/* Slopes of a normal, and the variance that Toksvig derives from the length of a mean normal. */
#ifndef SHD_TESTS_REF_MOMENTS_REF_H
#define SHD_TESTS_REF_MOMENTS_REF_H

#include <math.h>

/** bx, by of (x, y, z), with z at least 1/32 of the length; 0 for vectors without a length. */
static inline void shd_ref_slopes(double x, double y, double z, double out[2]) {
  const double length = sqrt(x * x + y * y + z * z);
  out[0] = out[1] = 0;
  if (isnan(length) || isinf(length) || length == 0) return;
  z = fmax(z / length, 1.0 / 32);
  out[0] = x / length / z;
  out[1] = y / length / z;
}

/** Variance of a slope, derived from the length of a mean of unit normals: (1 - length) / length (Toksvig, "Mipmapping
    Normal Maps", 2005, equation 2). */
static inline double shd_ref_toksvig(double length) {
  return (1 - length) / length;
}

#endif /* SHD_TESTS_REF_MOMENTS_REF_H */
