/* SPDX-License-Identifier: MIT */
/* Brute-force edges of a mesh: every edge of every triangle is compared with every other one. */
#ifndef SHD_TESTS_REF_EDGES_REF_H
#define SHD_TESTS_REF_EDGES_REF_H

#include <math.h>
#include <stddef.h>
#include <stdint.h>

#include <shd/edges.h>

/** Records of x, y, z, and triangles as index triples. */
typedef struct shd_ref_mesh {
  const float* position;
  const uint32_t* indices;
  size_t triangles;
} shd_ref_mesh;

typedef struct shd_ref_edge {
  uint32_t vertex[2], triangle[2], kinds;
  double margin; /* smallest relative distance of the eye from the planes, and of the angle from the threshold */
} shd_ref_edge;

static inline uint32_t shd_ref_corner(const shd_ref_mesh* m, size_t triangle, size_t k) {
  return m->indices[3 * triangle + k % 3];
}

/* Whether two vertices have the same position. */
static inline int shd_ref_meet(const shd_ref_mesh* m, uint32_t a, uint32_t b) {
  const float *p = m->position + 3 * (size_t)a, *q = m->position + 3 * (size_t)b;
  return p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
}

/* Unit normal of a triangle; 0 if it has none. */
static inline int shd_ref_unit_normal(const shd_ref_mesh* m, size_t triangle, long double n[3]) {
  const float* p = m->position + 3 * (size_t)shd_ref_corner(m, triangle, 0);
  const float* q = m->position + 3 * (size_t)shd_ref_corner(m, triangle, 1);
  const float* r = m->position + 3 * (size_t)shd_ref_corner(m, triangle, 2);
  long double length;
  int c;
  for (c = 0; c < 3; ++c) {
    const int i = (c + 1) % 3, j = (c + 2) % 3;
    n[c] = ((long double)q[i] - p[i]) * ((long double)r[j] - p[j]) -
           ((long double)q[j] - p[j]) * ((long double)r[i] - p[i]);
  }
  length = sqrtl(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  if (!(length > 0) || isinf(length)) return 0;
  for (c = 0; c < 3; ++c) n[c] /= length;
  return 1;
}

/* 1 if edge l of triangle u is edge k of triangle t in opposite direction, 2 if in the same direction, otherwise 0. */
static inline int shd_ref_same_edge(const shd_ref_mesh* m, size_t t, size_t k, size_t u, size_t l) {
  const uint32_t a = shd_ref_corner(m, t, k), b = shd_ref_corner(m, t, k + 1);
  const uint32_t c = shd_ref_corner(m, u, l), d = shd_ref_corner(m, u, l + 1);
  if (shd_ref_meet(m, a, d) && shd_ref_meet(m, b, c)) return 1;
  return shd_ref_meet(m, a, c) && shd_ref_meet(m, b, d) ? 2 : 0;
}

/* (e - p) . n of a triangle, divided by the length of e - p: the sine of the angle at which it is seen. */
static inline long double shd_ref_side(const shd_ref_mesh* m, size_t triangle, const long double n[3],
                                       const float eye[4]) {
  const float* p = m->position + 3 * (size_t)shd_ref_corner(m, triangle, 0);
  long double sum = 0, square = 0;
  int c;
  for (c = 0; c < 3; ++c) {
    const long double d = (long double)eye[c] - (long double)eye[3] * p[c];
    sum += d * n[c];
    square += d * d;
  }
  return square > 0 ? sum / sqrtl(square) : 0;
}

/* Kinds of an edge between two triangles; `way` is the result of shd_ref_same_edge. */
static inline void shd_ref_classify(const shd_ref_mesh* m, const shd_edges_desc* desc, int way, shd_ref_edge* edge) {
  long double n[2][3], side[2], cosine = 0;
  int i;
  for (i = 0; i < 2; ++i) {
    (void)shd_ref_unit_normal(m, edge->triangle[i], n[i]);
    side[i] = shd_ref_side(m, edge->triangle[i], n[i], desc->eye);
  }
  for (i = 0; i < 3; ++i) cosine += n[0][i] * n[1][i];
  if (way == 2) {
    side[1] = -side[1];
    cosine = -cosine;
  }
  edge->kinds = (side[0] * side[1] <= 0 ? SHD_EDGE_SILHOUETTE : 0) |
                (cosine <= (long double)desc->crease_cosine ? SHD_EDGE_CREASE : 0);
  edge->margin = (double)fminl(fabsl(cosine - (long double)desc->crease_cosine), fminl(fabsl(side[0]), fabsl(side[1])));
}

/** Every edge, including edges of no kind, in the order of triangles. Returns their number. */
static inline size_t shd_ref_find_edges(const shd_ref_mesh* m, const shd_edges_desc* desc, shd_ref_edge* out) {
  size_t count = 0, t, u, k, l;
  long double n[3];
  for (t = 0; t < m->triangles; ++t) {
    if (!shd_ref_unit_normal(m, t, n)) continue;
    for (k = 0; k < 3; ++k) {
      shd_ref_edge edge = {{shd_ref_corner(m, t, k), shd_ref_corner(m, t, k + 1)}, {(uint32_t)t, ~0u}, 0, 1};
      size_t before = 0, after = 0;
      int way = 0;
      for (u = 0; u < m->triangles; ++u) {
        if (u == t || !shd_ref_unit_normal(m, u, n)) continue;
        for (l = 0; l < 3; ++l) {
          const int same = shd_ref_same_edge(m, t, k, u, l);
          if (!same) continue;
          before += u < t;
          after += u > t;
          way = same;
          edge.triangle[1] = (uint32_t)u;
        }
      }
      if (before) continue;
      if (after == 1) {
        shd_ref_classify(m, desc, way, &edge);
      } else {
        edge.triangle[1] = ~0u;
        edge.kinds = after ? SHD_EDGE_NONMANIFOLD : SHD_EDGE_BORDER;
      }
      out[count++] = edge;
    }
  }
  return count;
}

#endif /* SHD_TESTS_REF_EDGES_REF_H */
