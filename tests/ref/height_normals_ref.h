/* SPDX-License-Identifier: MIT */
/* The normal of a height field at a texel, in double. */
#ifndef SHD_TESTS_REF_HEIGHT_NORMALS_REF_H
#define SHD_TESTS_REF_HEIGHT_NORMALS_REF_H

#include <math.h>
#include <stddef.h>

#include <shd/mip.h>

/** A height map of [height][width] numbers. */
struct shd_ref_heights {
  const double *height_at;
  long width, height;
  shd_wrap wrap_u, wrap_v;
};

/** Index of a texel at most one beyond an edge, or -1 for the border. */
static inline long shd_ref_beyond(shd_wrap wrap, long i, long n) {
  if (i >= 0 && i < n) return i;
  if (wrap == SHD_WRAP_REPEAT) return i < 0 ? n - 1 : 0;
  if (wrap == SHD_WRAP_BORDER) return -1;
  return i < 0 ? 0 : n - 1; /* one texel beyond the edge, clamps and mirrors read the same texel */
}

static inline double shd_ref_height(const struct shd_ref_heights *map, long x, long y) {
  const long column = shd_ref_beyond(map->wrap_u, x, map->width), row = shd_ref_beyond(map->wrap_v, y, map->height);
  if (column < 0 || row < 0) return 0;
  return isfinite(map->height_at[row * map->width + column]) ? map->height_at[row * map->width + column] : 0;
}

/** The unit vector along (-s hx, s hy, 1), by 3 x 3 weights: those of the slope along x, transposed for y. */
static inline void shd_ref_height_normal(const struct shd_ref_heights *map, shd_height_slope slope, double s, long x,
                                         long y, double out[3]) {
  static const double kWeights[3][3][3] = {{{0, 0, 0}, {-0.5, 0, 0.5}, {0, 0, 0}},
                                           {{0, 0, 0}, {0, -1, 1}, {0, 0, 0}},
                                           {{-0.125, 0, 0.125}, {-0.25, 0, 0.25}, {-0.125, 0, 0.125}}};
  double hx = 0, hy = 0, length;
  int row, column;
  for (row = 0; row < 3; ++row) {
    for (column = 0; column < 3; ++column) {
      const double h = shd_ref_height(map, x + column - 1, y + row - 1);
      hx += kWeights[slope][row][column] * h;
      hy += kWeights[slope][column][row] * h;
    }
  }
  length = sqrt(s * hx * s * hx + s * hy * s * hy + 1);
  out[0] = -s * hx / length;
  out[1] = s * hy / length;
  out[2] = 1 / length;
}

#endif /* SHD_TESTS_REF_HEIGHT_NORMALS_REF_H */
