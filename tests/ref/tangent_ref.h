/* SPDX-License-Identifier: MIT */
/* Brute-force tangents by the rules of Mikkelsen, "Simulation of Wrinkled Surfaces Revisited" (2008): every corner
   visits every other corner. All arithmetic in double, angles by atan2. */
#ifndef SHD_TESTS_REF_TANGENT_REF_H
#define SHD_TESTS_REF_TANGENT_REF_H

#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#define SHD_REF_NO_CORNER ((size_t)-1)

/* Rows of position, normal, uv; index triples; the other arrays have one entry for each corner. */
typedef struct shd_ref_tangents {
  const float (*vertex)[8];
  const uint32_t* indices;
  size_t corner_count;
  size_t* group;        /* smallest corner of the group; SHD_REF_NO_CORNER if there is none */
  size_t* forward;      /* the corner across the edge to the next corner */
  size_t* backward;     /* the corner across the edge from the previous corner */
  int* sign;            /* sign of the triangle: +1, -1, 0 = no uv area (then the sign of the group), 2 = left out */
  int* has_area;        /* whether the sign was not 0 */
  double (*tangent)[4]; /* unit, with handedness; the fallback if there is no tangent */
  double* strength;     /* length of the sum / sum of lengths; 0 for the fallback */
} shd_ref_tangents;

static inline double shd_ref_dot3(const double* a, const double* b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline int shd_ref_unit3(double* a) {
  const double size = sqrt(shd_ref_dot3(a, a));
  int i;
  if (!(size > 0)) return 0;
  for (i = 0; i < 3; ++i) a[i] /= size;
  return 1;
}

static inline const float* shd_ref_row(const shd_ref_tangents* m, size_t corner) {
  return m->vertex[m->indices[corner]];
}
static inline size_t shd_ref_next(size_t corner) {
  return corner / 3 * 3 + (corner + 1) % 3;
}
static inline size_t shd_ref_previous(size_t corner) {
  return corner / 3 * 3 + (corner + 2) % 3;
}

/* Whether positions, normals and uv of two corners are equal. */
static inline int shd_ref_same(const shd_ref_tangents* m, size_t a, size_t b) {
  int i;
  for (i = 0; i < 8; ++i) {
    if (shd_ref_row(m, a)[i] != shd_ref_row(m, b)[i]) return 0;
  }
  return 1;
}

/* dP/du times |uv area|; returns the sign of the uv area with v upwards, 0 or 2. */
static inline int shd_ref_along_u(const shd_ref_tangents* m, size_t triangle, double* along) {
  const float *a = shd_ref_row(m, 3 * triangle), *b = shd_ref_row(m, 3 * triangle + 1),
              *c = shd_ref_row(m, 3 * triangle + 2);
  const double bu = (double)b[6] - a[6], bv = (double)a[7] - b[7], cu = (double)c[6] - a[6], cv = (double)a[7] - c[7];
  const double area = bu * cv - cu * bv;
  double across[3];
  int i;
  for (i = 0; i < 3; ++i) along[i] = 0;
  for (i = 0; i < 3; ++i) {
    if (!isfinite(a[i]) || !isfinite(b[i]) || !isfinite(c[i])) return 2;
  }
  if (!memcmp(a, b, 12) || !memcmp(b, c, 12) || !memcmp(c, a, 12)) return 2;
  for (i = 0; i < 3; ++i) {
    along[i] = (cv * ((double)b[i] - a[i]) - bv * ((double)c[i] - a[i])) * (area < 0 ? -1 : 1);
    across[i] = bu * ((double)c[i] - a[i]) - cu * ((double)b[i] - a[i]);
  }
  if (area == 0 || shd_ref_dot3(along, along) == 0 || shd_ref_dot3(across, across) == 0) return 0;
  return area > 0 ? 1 : -1;
}

/* Number of triangles before `corner`'s that run along the edge from `corner` to the next one in the same direction. */
static inline size_t shd_ref_rank(const shd_ref_tangents* m, size_t corner) {
  size_t rank = 0, c;
  for (c = 0; c < corner / 3 * 3; ++c) {
    rank += m->sign[c] != 2 && shd_ref_same(m, c, corner) && shd_ref_same(m, shd_ref_next(c), shd_ref_next(corner));
  }
  return rank;
}

/* The corner at the same vertex across the edge from `corner` to the next one. */
static inline size_t shd_ref_across(const shd_ref_tangents* m, size_t corner) {
  size_t left = shd_ref_rank(m, corner), c;
  for (c = 0; c < m->corner_count; ++c) {
    if (m->sign[c] == 2 || !shd_ref_same(m, shd_ref_next(c), corner) || !shd_ref_same(m, c, shd_ref_next(corner))) {
      continue;
    }
    if (left-- == 0) return shd_ref_next(c);
  }
  return SHD_REF_NO_CORNER;
}

/* Direction of a corner's triangle in the plane of its normal, times its angle there. */
static inline double shd_ref_contribution(const shd_ref_tangents* m, size_t corner, double* out) {
  const float* p = shd_ref_row(m, corner);
  const double n[3] = {p[3], p[4], p[5]};
  double side[2][3], cross[3], angle;
  int i, k;
  shd_ref_along_u(m, corner / 3, out);
  for (k = 0; k < 3; ++k) {
    double* v = k < 2 ? side[k] : out;
    double along;
    if (k < 2) {
      const float* q = shd_ref_row(m, k == 0 ? shd_ref_previous(corner) : shd_ref_next(corner));
      for (i = 0; i < 3; ++i) v[i] = (double)q[i] - p[i];
    }
    along = shd_ref_dot3(n, v);
    for (i = 0; i < 3; ++i) v[i] -= along * n[i];
  }
  if (!shd_ref_unit3(out)) out[0] = out[1] = out[2] = 0;
  for (i = 0; i < 3; ++i) {
    cross[i] = side[0][(i + 1) % 3] * side[1][(i + 2) % 3] - side[0][(i + 2) % 3] * side[1][(i + 1) % 3];
  }
  angle = atan2(sqrt(shd_ref_dot3(cross, cross)), shd_ref_dot3(side[0], side[1]));
  for (i = 0; i < 3; ++i) out[i] *= angle;
  return sqrt(shd_ref_dot3(out, out));
}

/* Adds the corner to the group if the signs allow it. Returns whether it was added. */
static inline int shd_ref_join(shd_ref_tangents* m, size_t corner, size_t group, int sign) {
  size_t c;
  if (corner == SHD_REF_NO_CORNER || m->group[corner] != SHD_REF_NO_CORNER) return 0;
  if (m->sign[corner] == 0) {
    for (c = corner / 3 * 3; c < corner / 3 * 3 + 3; ++c) m->sign[c] = sign;
  }
  if (m->sign[corner] != sign) return 0;
  m->group[corner] = group;
  return 1;
}

static inline void shd_ref_group(shd_ref_tangents* m) {
  size_t c, d;
  for (c = 0; c < m->corner_count; ++c) {
    double unused[3];
    m->sign[c] = shd_ref_along_u(m, c / 3, unused);
    m->has_area[c] = m->sign[c] != 0;
    m->group[c] = m->forward[c] = m->backward[c] = SHD_REF_NO_CORNER;
  }
  for (c = 0; c < m->corner_count; ++c) {
    if (m->sign[c] == 2) continue;
    m->forward[c] = shd_ref_across(m, c);
    if (m->forward[c] != SHD_REF_NO_CORNER) m->backward[m->forward[c]] = c;
  }
  for (c = 0; c < m->corner_count; ++c) {
    int grown = 1;
    if (!m->has_area[c] || m->sign[c] == 2 || m->group[c] != SHD_REF_NO_CORNER) continue;
    m->group[c] = c;
    while (grown) {
      grown = 0;
      for (d = 0; d < m->corner_count; ++d) {
        if (m->group[d] != c) continue;
        grown |= shd_ref_join(m, m->forward[d], c, m->sign[c]);
        grown |= shd_ref_join(m, m->backward[d], c, m->sign[c]);
      }
    }
  }
}

/* The x axis, or y if the normal is near x, projected into the plane of the normal. */
static inline void shd_ref_fallback(const float* n, double* out) {
  const int axis = fabs((double)n[0]) > 0.9;
  int i;
  for (i = 0; i < 3; ++i) out[i] = (i == axis) - (double)n[axis] * n[i];
  shd_ref_unit3(out);
}

/* Fills tangent and strength of every corner. */
static inline void shd_ref_tangents_of(shd_ref_tangents* m) {
  size_t c, d;
  int i;
  shd_ref_group(m);
  for (c = 0; c < m->corner_count; ++c) {
    double sum[3] = {0, 0, 0}, lengths = 0;
    size_t group = m->group[c];
    for (d = 0; d < m->corner_count; ++d) { /* corners without a group use the first one at their vertex */
      if (m->group[c] != SHD_REF_NO_CORNER) break;
      if (m->group[d] < group && shd_ref_same(m, c, d)) group = m->group[d];
    }
    for (d = 0; d < m->corner_count && group != SHD_REF_NO_CORNER; ++d) {
      double part[3];
      if (m->group[d] != group || !m->has_area[d]) continue;
      lengths += shd_ref_contribution(m, d, part);
      for (i = 0; i < 3; ++i) sum[i] += part[i];
    }
    m->strength[c] = lengths > 0 ? sqrt(shd_ref_dot3(sum, sum)) / lengths : 0;
    if (!shd_ref_unit3(sum)) shd_ref_fallback(shd_ref_row(m, c) + 3, sum);
    for (i = 0; i < 3; ++i) m->tangent[c][i] = sum[i];
    m->tangent[c][3] = group != SHD_REF_NO_CORNER ? m->sign[group] : 1;
  }
}

#endif /* SHD_TESTS_REF_TANGENT_REF_H */
