/* SPDX-License-Identifier: MIT */
/* Matrices by their definitions in long double: projections by the corners of their volume, inverses by cofactors,
   rotations by rotating the axes with the quaternion's product. Column-major. */
#ifndef SHD_TESTS_REF_TRANSFORM_REF_H
#define SHD_TESTS_REF_TRANSFORM_REF_H

#include <math.h>

/* Determinant of the size x size matrix with element (row, column) at m[4 * column + row], by its first column. */
static inline long double shd_ref_determinant(const long double* m, int size) {
  long double sum = 0;
  int skip, r, c;
  if (size == 1) return m[0];
  for (skip = 0; skip < size; ++skip) {
    long double minor[16];
    for (c = 1; c < size; ++c) {
      for (r = 0; r < size; ++r) {
        if (r != skip) minor[4 * (c - 1) + r - (r > skip)] = m[4 * c + r];
      }
    }
    sum += (skip % 2 ? -1 : 1) * m[skip] * shd_ref_determinant(minor, size - 1);
  }
  return sum;
}

/* Inverse of the upper left size x size by Cramer's rule, [4 * column + row]. Returns the determinant. */
static inline long double shd_ref_invert(const float* matrix, int size, long double* out) {
  long double m[16], determinant;
  int i, row, column, r, c;
  for (i = 0; i < 16; ++i) m[i] = matrix[i];
  determinant = shd_ref_determinant(m, size);
  for (column = 0; column < size; ++column) {
    for (row = 0; row < size; ++row) {
      long double minor[16];
      for (c = 0; c < size; ++c) {
        for (r = 0; r < size; ++r) {
          /* Element (row, column) of the inverse has the cofactor of (column, row). */
          if (r != column && c != row) minor[4 * (c - (c > row)) + r - (r > column)] = m[4 * c + r];
        }
      }
      out[4 * column + row] = ((row + column) % 2 ? -1 : 1) * shd_ref_determinant(minor, size - 1) / determinant;
    }
  }
  return determinant;
}

static inline void shd_ref_apply(const float* m, const long double* in, long double* out) {
  int r, c;
  for (r = 0; r < 4; ++r) {
    out[r] = 0;
    for (c = 0; c < 4; ++c) out[r] += (long double)m[4 * c + r] * in[c];
  }
}

/* Hamilton's product of quaternions x, y, z, w. */
static inline void shd_ref_quaternion_product(const long double* a, const long double* b, long double* out) {
  out[0] = a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1];
  out[1] = a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0];
  out[2] = a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3];
  out[3] = a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2];
}

/* v turned by the quaternion: q v q* / |q|^2. */
static inline void shd_ref_rotate(const float* quaternion, const long double* v, long double* out) {
  long double q[4], conjugate[4], p[4] = {0, 0, 0, 0}, half[4], full[4], square = 0;
  int i;
  for (i = 0; i < 4; ++i) {
    q[i] = quaternion[i];
    conjugate[i] = i < 3 ? -q[i] : q[i];
    square += q[i] * q[i];
  }
  for (i = 0; i < 3; ++i) p[i] = v[i];
  shd_ref_quaternion_product(q, p, half);
  shd_ref_quaternion_product(half, conjugate, full);
  for (i = 0; i < 3; ++i) out[i] = full[i] / square;
}

#endif /* SHD_TESTS_REF_TRANSFORM_REF_H */
