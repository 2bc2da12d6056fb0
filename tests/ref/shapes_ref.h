/* SPDX-License-Identifier: MIT */
/* Properties of shapes without their triangles: areas and volumes by calculus, normals and places by
   equations; and measures of a triangle mesh by sums. */
#ifndef SHD_TESTS_REF_SHAPES_REF_H
#define SHD_TESTS_REF_SHAPES_REF_H

#include <math.h>
#include <stddef.h>
#include <stdint.h>

#include <shd/shapes.h>

#define SHD_REF_PI 3.14159265358979323846264338327950288L

/* Area of the surface; 0 where no formula is known. */
static inline long double shd_ref_shape_area(const shd_shape_desc* d) {
  const long double r = d->radius, t = d->tube_radius, x = d->size[0], y = d->size[1], z = d->size[2];
  switch (d->kind) {
    case SHD_SHAPE_SPHERE: return 4 * SHD_REF_PI * r * r;
    case SHD_SHAPE_BOX: return 2 * (x * y + y * z + z * x);
    case SHD_SHAPE_PLANE: return x * z;
    case SHD_SHAPE_TORUS: return 4 * SHD_REF_PI * SHD_REF_PI * r * t; /* Pappus */
    default: return 0;
  }
}

/* Volume inside; 0 where there is none or no formula is known. */
static inline long double shd_ref_shape_volume(const shd_shape_desc* d) {
  const long double r = d->radius, t = d->tube_radius;
  switch (d->kind) {
    case SHD_SHAPE_SPHERE: return 4 * SHD_REF_PI * r * r * r / 3;
    case SHD_SHAPE_BOX: return (long double)d->size[0] * d->size[1] * d->size[2];
    case SHD_SHAPE_TORUS: return 2 * SHD_REF_PI * SHD_REF_PI * r * t * t; /* Pappus */
    default: return 0;
  }
}

/* Distance of p from the surface, and the gradient of that distance into `normal`. Only spheres and tori. */
static inline long double shd_ref_shape_distance(const shd_shape_desc* d, const float* p, long double* normal) {
  long double q[3], away = 0, length;
  int c;
  for (c = 0; c < 3; ++c) q[c] = p[c];
  if (d->kind == SHD_SHAPE_TORUS) { /* from the nearest point of the circle in the middle of the tube */
    away = sqrtl(q[0] * q[0] + q[2] * q[2]);
    q[0] -= q[0] / away * d->radius;
    q[2] -= q[2] / away * d->radius;
  }
  length = sqrtl(q[0] * q[0] + q[1] * q[1] + q[2] * q[2]);
  for (c = 0; c < 3; ++c) normal[c] = q[c] / length;
  return length - (d->kind == SHD_SHAPE_TORUS ? d->tube_radius : d->radius);
}

/* Twice the vector area of a triangle; positions are [vertex][3]. */
static inline void shd_ref_cross(const float* p, const uint32_t* t, long double* n) {
  long double e[3], f[3];
  int c;
  for (c = 0; c < 3; ++c) {
    e[c] = (long double)p[3 * t[1] + c] - p[3 * t[0] + c];
    f[c] = (long double)p[3 * t[2] + c] - p[3 * t[0] + c];
  }
  for (c = 0; c < 3; ++c) n[c] = e[(c + 1) % 3] * f[(c + 2) % 3] - e[(c + 2) % 3] * f[(c + 1) % 3];
}

static inline long double shd_ref_mesh_area(const float* p, const uint32_t* indices, size_t count) {
  long double sum = 0, n[3];
  size_t i;
  for (i = 0; i < count; i += 3) {
    shd_ref_cross(p, indices + i, n);
    sum += sqrtl(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) / 2;
  }
  return sum;
}

/* By the divergence theorem; positive where triangles are counter-clockwise seen from outside. */
static inline long double shd_ref_mesh_volume(const float* p, const uint32_t* indices, size_t count) {
  long double sum = 0, n[3];
  size_t i;
  int c;
  for (i = 0; i < count; i += 3) {
    shd_ref_cross(p, indices + i, n);
    for (c = 0; c < 3; ++c) sum += n[c] * p[3 * indices[i] + c] / 6;
  }
  return sum;
}

#endif /* SHD_TESTS_REF_SHAPES_REF_H */
