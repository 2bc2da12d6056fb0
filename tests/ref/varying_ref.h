/* SPDX-License-Identifier: MIT */
/* Oracle of varyings: interpolation between three vertices at a position on the screen, in double. */
#ifndef SHD_TESTS_REF_VARYING_REF_H
#define SHD_TESTS_REF_VARYING_REF_H

#include <shd/vertices.h>

/** Weights from twice the areas e of the three sub-triangles, clamped to the triangle. */
static inline void shd_ref_normalise(const double e[3], double b[3]) {
  const double sum = e[0] + e[1] + e[2];
  b[1] = e[1] / sum < 0 ? 0 : e[1] / sum > 1 ? 1 : e[1] / sum;
  b[2] = e[2] / sum < 0 ? 0 : e[2] / sum > 1 - b[1] ? 1 - b[1] : e[2] / sum;
  b[0] = 1 - b[1] - b[2];
}

/** Weights of three vertices v, [3][4] raster X, Y, Z, W, at raster position (x, y). Linear on the triangle: by areas
    of the vertices translated so that (x, y) is the origin. Linear on the screen: by areas between (X / W, Y / W), if
    all three exist; all attributes of a draw with SHD_DRAW_AFFINE have these weights. */
static inline void shd_ref_weights(const double* v, double x, double y, shd_interpolation mode, double b[3]) {
  int on_screen = mode == SHD_INTERPOLATION_AFFINE, k;
  double p[3][2], e[3];
  for (k = 0; k < 3; ++k) on_screen &= v[4 * k + 3] >= 0x1p-100;
  for (k = 0; k < 3; ++k) {
    const double scale = on_screen ? 1 / v[4 * k + 3] : 1;
    p[k][0] = (v[4 * k] - x * v[4 * k + 3]) * scale;
    p[k][1] = (v[4 * k + 1] - y * v[4 * k + 3]) * scale;
  }
  for (k = 0; k < 3; ++k) {
    const double *i = p[(k + 1) % 3], *j = p[(k + 2) % 3];
    e[k] = i[0] * j[1] - j[0] * i[1];
  }
  shd_ref_normalise(e, b);
}

/** The interpolated value of a[0], a[1] and a[2]. */
static inline double shd_ref_varying(const double* v, const float a[3], double x, double y, shd_interpolation mode) {
  double b[3];
  if (mode == SHD_INTERPOLATION_FLAT) return (double)a[0];
  shd_ref_weights(v, x, y, mode, b);
  return b[0] * (double)a[0] + b[1] * (double)a[1] + b[2] * (double)a[2];
}

#endif /* SHD_TESTS_REF_VARYING_REF_H */
