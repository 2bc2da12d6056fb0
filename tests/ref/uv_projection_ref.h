/* SPDX-License-Identifier: MIT */
/* Coordinates of one triangle by the rules of shd/uv_projection.h, in double: angles by atan2 and acos, and seams by
   trying which corners continue past 1. */
#ifndef SHD_TESTS_REF_UV_PROJECTION_REF_H
#define SHD_TESTS_REF_UV_PROJECTION_REF_H

#include <math.h>

#include <shd/uv_projection.h>

#define SHD_REF_TURN 6.283185307179586

/* place = m p for a column-major m; returns the sum of the magnitudes of all terms. */
static inline double shd_ref_place(const float* m, const float* p, double place[3]) {
  double reach = 0;
  int r, c;
  for (r = 0; r < 3; ++r) {
    place[r] = (double)m[12 + r];
    reach += fabs((double)m[12 + r]);
    for (c = 0; c < 3; ++c) {
      place[r] += (double)m[4 * c + r] * (double)p[c];
      reach += fabs((double)m[4 * c + r] * (double)p[c]);
    }
  }
  return reach;
}

/* Turn around +Y, 0 on -Z, 1/4 on -X. */
static inline double shd_ref_turn(const double place[3]) {
  const double angle = atan2(-place[0], -place[2]) / SHD_REF_TURN;
  return angle < 0 ? angle + 1 : angle;
}

/* Raises those of the turns marked in `used` that give the smallest range with the fewest raised ones; returns the mean
   of the lowest and the highest turn. */
static inline double shd_ref_close_seam(const int used[3], double turn[3]) {
  double best_range = HUGE_VAL, mean = 0;
  int best = 0, best_count = 4, raised, k;
  for (raised = 0; raised < 8; ++raised) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    int count = 0, valid = 1;
    for (k = 0; k < 3; ++k) {
      const double t = turn[k] + (raised >> k & 1);
      if (!used[k] && raised >> k & 1) valid = 0;
      if (!used[k]) continue;
      count += raised >> k & 1;
      low = fmin(low, t);
      high = fmax(high, t);
    }
    if (!valid) continue;
    if (high - low < best_range - 1e-12 || (high - low < best_range + 1e-12 && count < best_count)) {
      best_range = high - low;
      best = raised;
      best_count = count;
      mean = 0.5 * (low + high);
    }
  }
  for (k = 0; k < 3; ++k) turn[k] += best >> k & 1;
  return mean;
}

/* A sphere (v from the angle to +Y) or a cylinder. */
static inline void shd_ref_round_uv(int is_sphere, const float* m, const float* const p[3], double uv[3][2]) {
  double turn[3], mean;
  int used[3], k, any = 0;
  for (k = 0; k < 3; ++k) {
    double place[3];
    const double reach = shd_ref_place(m, p[k], place), distance = hypot(place[0], place[2]);
    used[k] = distance > reach / 1048576;
    any |= used[k];
    turn[k] = used[k] ? shd_ref_turn(place) : 0;
    uv[k][1] = is_sphere ? acos(place[1] / hypot(distance, place[1])) * 2 / SHD_REF_TURN : (1 - place[1]) / 2;
    if (is_sphere && distance == 0 && place[1] == 0) uv[k][1] = 0.5;
  }
  mean = any ? shd_ref_close_seam(used, turn) : 0;
  for (k = 0; k < 3; ++k) uv[k][0] = used[k] ? turn[k] : mean;
}

/* A cube: the side of the triangle's normal in object space, through the inverse transpose of the matrix. */
static inline void shd_ref_box_uv(const float* m, const float* const p[3], double uv[3][2]) {
  double a[3], b[3], n[3], out[3] = {0, 0, 0}, det = 0;
  int r, c, k, axis = 0;
  for (c = 0; c < 3; ++c) {
    a[c] = (double)p[1][c] - (double)p[0][c];
    b[c] = (double)p[2][c] - (double)p[0][c];
  }
  for (c = 0; c < 3; ++c) n[c] = a[(c + 1) % 3] * b[(c + 2) % 3] - a[(c + 2) % 3] * b[(c + 1) % 3];
  for (r = 0; r < 3; ++r) {
    for (c = 0; c < 3; ++c) {
      const int r1 = (r + 1) % 3, r2 = (r + 2) % 3, c1 = 4 * ((c + 1) % 3), c2 = 4 * ((c + 2) % 3);
      const double cofactor = (double)m[c1 + r1] * (double)m[c2 + r2] - (double)m[c1 + r2] * (double)m[c2 + r1];
      out[r] += cofactor * n[c];
      if (r == 0) det += (double)m[4 * c] * cofactor;
    }
  }
  if (det < 0) {
    for (k = 0; k < 3; ++k) out[k] = -out[k];
  }
  for (k = 1; k < 3; ++k) {
    if (fabs(out[k]) > fabs(out[axis])) axis = k;
  }
  for (k = 0; k < 3; ++k) {
    double q[3];
    shd_ref_place(m, p[k], q);
    if (axis == 0) uv[k][0] = (1 + (out[0] < 0 ? q[2] : -q[2])) / 2, uv[k][1] = (1 - q[1]) / 2;
    if (axis == 1) uv[k][0] = (1 + q[0]) / 2, uv[k][1] = (1 + (out[1] < 0 ? -q[2] : q[2])) / 2;
    if (axis == 2) uv[k][0] = (1 + (out[2] < 0 ? -q[0] : q[0])) / 2, uv[k][1] = (1 - q[1]) / 2;
  }
}

/* uv of the corners of a triangle whose positions are finite. */
static inline void shd_ref_project_uv(shd_uv_projection projection, const float* m, const float* const p[3],
                                      double uv[3][2]) {
  int k;
  for (k = 0; k < 3 && projection == SHD_UV_PROJECTION_PLANAR; ++k) {
    double place[3];
    shd_ref_place(m, p[k], place);
    uv[k][0] = (1 + place[0]) / 2;
    uv[k][1] = (1 - place[1]) / 2;
  }
  if (projection == SHD_UV_PROJECTION_SPHERICAL || projection == SHD_UV_PROJECTION_CYLINDRICAL) {
    shd_ref_round_uv(projection == SHD_UV_PROJECTION_SPHERICAL, m, p, uv);
  }
  if (projection == SHD_UV_PROJECTION_BOX) shd_ref_box_uv(m, p, uv);
}

#endif /* SHD_TESTS_REF_UV_PROJECTION_REF_H */
