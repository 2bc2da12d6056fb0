// SPDX-License-Identifier: MIT
#include "polygon/triangulate.h"

#include <utility>

namespace shd::polygon {
namespace {

/// Vertices that are not yet cut off, in counter-clockwise order.
struct Ring {
  uint32_t count;
  uint32_t vertex[kMaxPolygon];

  uint32_t at(uint32_t i) const { return vertex[i % count]; }
};

/// Whether the corner at position i can be cut off: a left turn whose triangle holds no other vertex.
bool is_ear(const Polygon& p, const Ring& ring, uint32_t i) {
  const uint32_t a = ring.at(i + ring.count - 1), b = ring.at(i), c = ring.at(i + 1);
  if (!(turn(p, a, b, c) > 0.0)) return false;
  for (uint32_t k = 0; k < ring.count; ++k) {
    const uint32_t v = ring.vertex[k];
    if (v == a || v == b || v == c) continue;
    if (turn(p, a, b, v) >= 0.0 && turn(p, b, c, v) >= 0.0 && turn(p, c, a, v) >= 0.0) return false;
  }
  return true;
}

bool cut_ears(const Polygon& p, Ring* ring, Triangulation* out) {
  while (ring->count > 2) {
    uint32_t ear = 0;
    while (ear < ring->count && !is_ear(p, *ring, ear)) ++ear;
    if (ear == ring->count) return false;
    uint32_t* const corner = out->corner[out->count++];
    corner[0] = ring->at(ear + ring->count - 1);
    corner[1] = ring->at(ear);
    corner[2] = ring->at(ear + 1);
    --ring->count;
    for (uint32_t k = ear; k < ring->count; ++k) ring->vertex[k] = ring->vertex[k + 1];
  }
  return true;
}

/// Whether vertex d lies inside the circle through a, b and c, which run counter-clockwise.
bool is_in_circle(const Polygon& p, uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
  double row[3][3];
  const uint32_t corner[3] = {a, b, c};
  for (int k = 0; k < 3; ++k) {
    const double x = p.x[corner[k]] - p.x[d], y = p.y[corner[k]] - p.y[d];
    row[k][0] = x;
    row[k][1] = y;
    row[k][2] = x * x + y * y;
  }
  const auto minor = [&](int i, int k) { return row[i][0] * row[k][1] - row[k][0] * row[i][1]; };
  const double sum = row[0][2] * minor(1, 2) - row[1][2] * minor(0, 2) + row[2][2] * minor(0, 1);
  double size = 0.0;
  for (const auto& r : row) size += r[2];
  return sum > 0x1p-40 * size * size;
}

/// Flips the side of triangles s and t that both have, if that makes their angles larger. Returns whether it did.
bool flip(const Polygon& p, uint32_t (&s)[3], uint32_t (&t)[3]) {
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      const uint32_t a = s[i], b = s[(i + 1) % 3], c = s[(i + 2) % 3], d = t[(k + 2) % 3];
      if (t[k] != b || t[(k + 1) % 3] != a) continue;
      const bool is_convex = turn(p, a, d, c) > 0.0 && turn(p, d, b, c) > 0.0;
      if (!is_convex || !is_in_circle(p, a, b, c, d)) return false;
      const uint32_t first[3] = {a, d, c}, second[3] = {d, b, c};
      for (int n = 0; n < 3; ++n) {
        s[n] = first[n];
        t[n] = second[n];
      }
      return true;
    }
  }
  return false;
}

}  // namespace

bool triangulate(const Polygon& polygon, Triangulation* out) {
  double area = 0.0;
  for (uint32_t i = 2; i < polygon.count; ++i) area += turn(polygon, 0, i - 1, i);
  Ring ring = {polygon.count, {}};
  for (uint32_t i = 0; i < polygon.count; ++i) ring.vertex[i] = area > 0.0 ? i : polygon.count - 1 - i;
  out->count = 0;
  if (!cut_ears(polygon, &ring, out)) return false;
  // Each flip increases the smallest angles; the bound only stops loops that rounding might cause.
  bool changed = true;
  for (uint32_t pass = 0; changed && pass < 4 * polygon.count; ++pass) {
    changed = false;
    for (uint32_t s = 0; s < out->count; ++s) {
      for (uint32_t t = s + 1; t < out->count; ++t) changed |= flip(polygon, out->corner[s], out->corner[t]);
    }
  }
  return true;
}

}  // namespace shd::polygon
