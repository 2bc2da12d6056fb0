/* SPDX-License-Identifier: MIT */
/* Projections in long double, from the published formulas with the C library: Debevec's for the discs, the tables of
   OpenGL and Vulkan for the cube, Cigolle et al. for the octahedron. */
#ifndef SHD_TESTS_REF_PROJECTION_REF_H
#define SHD_TESTS_REF_PROJECTION_REF_H

#include <math.h>
#include <stdint.h>

#include <shd/projection.h>

#define REF_PI 3.14159265358979323846264338327950288L

typedef struct ref_place {
  long double u, v;
  uint32_t face;
} ref_place;

/* Component `axis` times the sign of the table: 1 = x, -1 = -x, 2 = y and so on. */
static inline long double ref_component(const long double* n, int axis) {
  return axis > 0 ? n[axis - 1] : -n[-axis - 1];
}

/* Axis of the face, then right and down. */
static const int ref_cube_table[6][3] = {{1, -3, -2}, {-1, 3, -2}, {2, 1, 3}, {-2, 1, -3}, {3, 1, -2}, {-3, -1, -2}};

/* The point of a direction on a face of the cube, which may be another one than its own. */
static inline ref_place ref_on_face(const long double* n, uint32_t face) {
  const int* row = ref_cube_table[face];
  const long double r = fabsl(ref_component(n, row[0]));
  ref_place place = {(ref_component(n, row[1]) / r + 1.0L) / 2.0L, (ref_component(n, row[2]) / r + 1.0L) / 2.0L, face};
  return place;
}

static inline uint32_t ref_face_of(const long double* n) {
  const long double x = fabsl(n[0]), y = fabsl(n[1]), z = fabsl(n[2]);
  if (z >= x && z >= y) return n[2] < 0.0L ? 5 : 4;
  if (y >= x) return n[1] < 0.0L ? 3 : 2;
  return n[0] < 0.0L ? 1 : 0;
}

static inline ref_place ref_octahedral(const long double* n) {
  const long double sum = fabsl(n[0]) + fabsl(n[1]) + fabsl(n[2]);
  const long double x = n[0] / sum, y = n[1] / sum;
  long double p = x, q = y;
  ref_place place = {0, 0, 0};
  if (n[2] < 0.0L) {
    p = (1.0L - fabsl(y)) * (x < 0.0L ? -1.0L : 1.0L);
    q = (1.0L - fabsl(x)) * (y < 0.0L ? -1.0L : 1.0L);
  }
  place.u = 0.5L + 0.5L * p;
  place.v = 0.5L - 0.5L * q;
  return place;
}

/* `r` of Debevec: the distance from the centre, of a disc of radius 1/2, per distance from the Z axis. */
static inline ref_place ref_disc(const long double* n, int mirror_ball) {
  const long double rho = hypotl(n[0], n[1]), a = atan2l(rho, n[2]);
  const long double f = mirror_ball ? sinl(a / 2.0L) : a / REF_PI;
  const long double cosine = rho > 0.0L ? n[0] / rho : 1.0L, sine = rho > 0.0L ? n[1] / rho : 0.0L;
  ref_place place = {0.5L + 0.5L * f * cosine, 0.5L - 0.5L * f * sine, 0};
  return place;
}

/* `n` finite and not 0, of any length. */
static inline ref_place ref_project(shd_projection projection, const long double* n) {
  ref_place place = {0, 0, 0};
  switch (projection) {
    case SHD_PROJECTION_LAT_LONG:
      /* 0.0L - x is +0 for both zeros: the seam has u = 1. */
      place.u = atan2l(0.0L - n[0], n[2]) / (2.0L * REF_PI) + 0.5L;
      place.v = 0.5L - atan2l(n[1], hypotl(n[2], n[0])) / REF_PI;
      return place;
    case SHD_PROJECTION_MIRROR_BALL: return ref_disc(n, 1);
    case SHD_PROJECTION_ANGULAR: return ref_disc(n, 0);
    case SHD_PROJECTION_CUBE: return ref_on_face(n, ref_face_of(n));
    default: return ref_octahedral(n);
  }
}

/* Change of a point (u, v). */
typedef struct ref_change {
  long double du, dv;
} ref_change;

/* Vulkan 1.3 specification, "Cube Map Derivative Transformation": on the plane of a face. */
static inline ref_change ref_cube_step(const long double* n, const long double* dn, uint32_t face) {
  const int* row = ref_cube_table[face];
  const long double r = ref_component(n, row[0]), dr = ref_component(dn, row[0]);
  const long double s = ref_component(n, row[1]), t = ref_component(n, row[2]);
  ref_change step = {(r * ref_component(dn, row[1]) - s * dr) / (2.0L * r * r),
                     (r * ref_component(dn, row[2]) - t * dr) / (2.0L * r * r)};
  return step;
}

static inline ref_change ref_octahedral_step(const long double* n, const long double* dn) {
  const long double sign[3] = {n[0] < 0.0L ? -1.0L : 1.0L, n[1] < 0.0L ? -1.0L : 1.0L, n[2] < 0.0L ? -1.0L : 1.0L};
  const long double sum = fabsl(n[0]) + fabsl(n[1]) + fabsl(n[2]);
  const long double change = sign[0] * dn[0] + sign[1] * dn[1] + sign[2] * dn[2];
  const long double dp = (dn[0] * sum - n[0] * change) / (sum * sum);
  const long double dq = (dn[1] * sum - n[1] * change) / (sum * sum);
  const int folded = n[2] < 0.0L;
  ref_change step = {0.5L * (folded ? -sign[0] * sign[1] * dq : dp), -0.5L * (folded ? -sign[0] * sign[1] * dp : dq)};
  return step;
}

/* u = 1/2 + f(a) x / (2 rho), v = 1/2 - f(a) y / (2 rho), with the angle a from +Z. */
static inline ref_change ref_disc_step(const long double* n, const long double* dn, int mirror_ball) {
  const long double rho = hypotl(n[0], n[1]), square = rho * rho + n[2] * n[2], a = atan2l(rho, n[2]);
  const long double f = mirror_ball ? sinl(a / 2.0L) : a / REF_PI;
  const long double slope = mirror_ball ? cosl(a / 2.0L) / 2.0L : 1.0L / REF_PI;
  const long double x = n[0] / rho, y = n[1] / rho;
  const long double da = (n[2] * (x * dn[0] + y * dn[1]) - rho * dn[2]) / square;
  const long double turn = (x * dn[1] - y * dn[0]) / rho;
  ref_change step = {0.5L * (slope * da * x - f * turn * y), -0.5L * (slope * da * y + f * turn * x)};
  return step;
}

static inline ref_change ref_lat_long_step(const long double* n, const long double* dn) {
  const long double rho = hypotl(n[0], n[2]), square = rho * rho + n[1] * n[1];
  const long double drho = (n[0] * dn[0] + n[2] * dn[2]) / rho;
  ref_change step = {(n[0] * dn[2] - n[2] * dn[0]) / (rho * rho) / (2.0L * REF_PI),
                     (n[1] * drho - rho * dn[1]) / square / REF_PI};
  return step;
}

/* Change of the point of `n` with a change of `n`: the derivatives of ref_project(). Not for poles and centres. */
static inline ref_change ref_step(shd_projection projection, const long double* n, const long double* dn) {
  switch (projection) {
    case SHD_PROJECTION_LAT_LONG: return ref_lat_long_step(n, dn);
    case SHD_PROJECTION_MIRROR_BALL: return ref_disc_step(n, dn, 1);
    case SHD_PROJECTION_ANGULAR: return ref_disc_step(n, dn, 0);
    case SHD_PROJECTION_CUBE: return ref_cube_step(n, dn, ref_face_of(n));
    default: return ref_octahedral_step(n, dn);
  }
}

static inline void ref_normalize(long double* n) {
  const long double length = sqrtl(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  for (int c = 0; c < 3; ++c) n[c] /= length;
}

/* Unit direction of a point with u and v in [0, 1]. Returns 0 outside of the disc, else 1. */
static inline int ref_unproject(shd_projection projection, long double u, long double v, uint32_t face,
                                long double* n) {
  const long double p = 2.0L * u - 1.0L, q = 1.0L - 2.0L * v, r = hypotl(p, q);
  if (projection == SHD_PROJECTION_LAT_LONG) {
    n[0] = -sinl(REF_PI * p) * sinl(REF_PI * v);
    n[1] = cosl(REF_PI * v);
    n[2] = cosl(REF_PI * p) * sinl(REF_PI * v);
    return 1;
  }
  if (projection == SHD_PROJECTION_CUBE) {
    const int* row = ref_cube_table[face];
    const long double value[3] = {1.0L, p, -q};
    for (int i = 0; i < 3; ++i) n[(row[i] > 0 ? row[i] : -row[i]) - 1] = row[i] > 0 ? value[i] : -value[i];
    ref_normalize(n);
    return 1;
  }
  if (projection == SHD_PROJECTION_OCTAHEDRAL) {
    n[2] = 1.0L - fabsl(p) - fabsl(q);
    n[0] = n[2] < 0.0L ? (1.0L - fabsl(q)) * (p < 0.0L ? -1.0L : 1.0L) : p;
    n[1] = n[2] < 0.0L ? (1.0L - fabsl(p)) * (q < 0.0L ? -1.0L : 1.0L) : q;
    ref_normalize(n);
    return 1;
  }
  const long double a = projection == SHD_PROJECTION_ANGULAR ? REF_PI * r : 2.0L * asinl(r < 1.0L ? r : 1.0L);
  n[0] = r > 0.0L ? sinl(a) * p / r : 0.0L;
  n[1] = r > 0.0L ? sinl(a) * q / r : 0.0L;
  n[2] = cosl(a);
  if (r <= 1.0L) return 1;
  n[0] = n[1] = 0.0L, n[2] = -1.0L;
  return 0;
}

/* Solid angle per area of (u, v), from differences of directions: |dn/du x dn/dv|. Not for points at folds. */
static inline long double ref_density(shd_projection projection, long double u, long double v, uint32_t face) {
  const long double h = 1e-6L;
  long double n[4][3], a[3], b[3], c[3];
  ref_unproject(projection, u - h, v, face, n[0]);
  ref_unproject(projection, u + h, v, face, n[1]);
  ref_unproject(projection, u, v - h, face, n[2]);
  ref_unproject(projection, u, v + h, face, n[3]);
  for (int i = 0; i < 3; ++i) a[i] = (n[1][i] - n[0][i]) / (2.0L * h), b[i] = (n[3][i] - n[2][i]) / (2.0L * h);
  for (int i = 0; i < 3; ++i) c[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
  return sqrtl(c[0] * c[0] + c[1] * c[1] + c[2] * c[2]);
}

#endif /* SHD_TESTS_REF_PROJECTION_REF_H */
