/* SPDX-License-Identifier: MIT */
/* Brute-force vertex normals: every vertex visits every face; angles by acos, areas by Heron's formula. */
#ifndef SHD_TESTS_REF_MESH_REF_H
#define SHD_TESTS_REF_MESH_REF_H

#include <math.h>
#include <stddef.h>
#include <stdint.h>

#include <shd/mesh.h>

/* Length of p[a] - p[b]. */
static inline long double shd_ref_distance(const float* p, uint32_t a, uint32_t b) {
  long double sum = 0;
  int c;
  for (c = 0; c < 3; ++c) {
    const long double d = (long double)p[3 * a + c] - p[3 * b + c];
    sum += d * d;
  }
  return sqrtl(sum);
}

/* Area of a triangle from its sides, in the stable order of Kahan ("Miscalculating Area and Angles of a
   Needle-like Triangle"). */
static inline long double shd_ref_area(long double a, long double b, long double c) {
  long double t, square;
  if (a < b) t = a, a = b, b = t;
  if (b < c) t = b, b = c, c = t;
  if (a < b) t = a, a = b, b = t;
  square = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
  return square > 0 ? sqrtl(square) / 4 : 0;
}

/* Unit normal of the triangle; 0 if it has none. Returns whether it has one. */
static inline int shd_ref_face_normal(const float* p, const uint32_t* t, long double* n) {
  long double e[3], f[3], length;
  int c;
  for (c = 0; c < 3; ++c) {
    e[c] = (long double)p[3 * t[1] + c] - p[3 * t[0] + c];
    f[c] = (long double)p[3 * t[2] + c] - p[3 * t[0] + c];
  }
  for (c = 0; c < 3; ++c) n[c] = e[(c + 1) % 3] * f[(c + 2) % 3] - e[(c + 2) % 3] * f[(c + 1) % 3];
  length = sqrtl(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  if (!(length > 0) || isinf(length)) return 0;
  for (c = 0; c < 3; ++c) n[c] /= length;
  return 1;
}

/* Interior angle at corner `k`, by the law of cosines. */
static inline long double shd_ref_angle(const float* p, const uint32_t* t, int k) {
  const long double a = shd_ref_distance(p, t[k], t[(k + 1) % 3]);
  const long double b = shd_ref_distance(p, t[k], t[(k + 2) % 3]);
  const long double c = shd_ref_distance(p, t[(k + 1) % 3], t[(k + 2) % 3]);
  const long double cosine = (a * a + b * b - c * c) / (2 * a * b);
  return acosl(cosine > 1 ? 1 : cosine < -1 ? -1 : cosine);
}

/* Normal of one vertex; p is [vertex][3], indices [triangle][3]. Returns 0 and (0, 0, 1) if no face has area. */
static inline int shd_ref_vertex_normal(const float* p, const uint32_t* indices, size_t triangle_count,
                                        shd_normal_weight weight, uint32_t vertex, double* normal) {
  long double sum[3] = {0, 0, 0}, length;
  size_t i;
  int k, c;
  for (i = 0; i < triangle_count; ++i) {
    const uint32_t* t = indices + 3 * i;
    long double n[3], factor = 1;
    if (!shd_ref_face_normal(p, t, n)) continue;
    for (k = 0; k < 3; ++k) {
      if (t[k] != vertex) continue;
      if (weight == SHD_NORMAL_WEIGHT_AREA) {
        factor = shd_ref_area(shd_ref_distance(p, t[0], t[1]), shd_ref_distance(p, t[1], t[2]),
                              shd_ref_distance(p, t[2], t[0]));
      } else if (weight == SHD_NORMAL_WEIGHT_ANGLE) {
        factor = shd_ref_angle(p, t, k);
      }
      for (c = 0; c < 3; ++c) sum[c] += factor * n[c];
    }
  }
  length = sqrtl(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
  for (c = 0; c < 3; ++c) normal[c] = length > 0 ? (double)(sum[c] / length) : c == 2;
  return length > 0;
}

#endif /* SHD_TESTS_REF_MESH_REF_H */
