// SPDX-License-Identifier: MIT
#include "polygon/coordinates.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shd::polygon {
namespace {

/// Points closer to an edge than this part of the distance to its farther vertex lie on it.
constexpr double kOnEdge = 0x1p-40;

struct Offset {
  double x, y;
};
double cross(const Offset& a, const Offset& b) {
  return a.x * b.y - a.y * b.x;
}
double dot(const Offset& a, const Offset& b) {
  return a.x * b.x + a.y * b.y;
}
double length(const Offset& a) {
  return std::sqrt(dot(a, a));
}

/// Points farther from vertex 0 than this times the distance to its farthest vertex are moved to there.
constexpr double kFarthest = 0x1p20;

/// Moves a point towards vertex 0, so that differences of its distances to the vertices are not lost in rounding.
Offset limit_distance(const Polygon& p, double x, double y) {
  const Offset away = {x - p.x[0], y - p.y[0]};
  const double distance = length(away);
  if (distance <= kFarthest * length({p.x[1] - p.x[0], p.y[1] - p.y[0]})) return {x, y};
  double farthest = 0.0;
  for (uint32_t i = 1; i < p.count; ++i) {
    farthest = std::max(farthest, length({p.x[i] - p.x[0], p.y[i] - p.y[0]}));
  }
  if (distance <= kFarthest * farthest) return {x, y};
  const double scale = kFarthest * farthest / distance;
  return {p.x[0] + scale * away.x, p.y[0] + scale * away.y};
}

Offset between(const Polygon& p, uint32_t from, uint32_t to) {
  return {p.x[to] - p.x[from], p.y[to] - p.y[from]};
}
uint32_t next(const Polygon& p, uint32_t i) {
  return i + 1 == p.count ? 0 : i + 1;
}
uint32_t previous(const Polygon& p, uint32_t i) {
  return i == 0 ? p.count - 1 : i - 1;
}

/// Whether vertex c, which lies on the line of edge ab, lies on the edge.
bool is_within(const Polygon& p, uint32_t a, uint32_t b, uint32_t c) {
  return dot(between(p, c, a), between(p, c, b)) <= 0.0;
}

/// Whether the edges from a to b and from c to d share a point.
bool meet(const Polygon& p, uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
  const double ab_c = turn(p, a, b, c), ab_d = turn(p, a, b, d), cd_a = turn(p, c, d, a), cd_b = turn(p, c, d, b);
  if (ab_c == 0.0 && is_within(p, a, b, c)) return true;
  if (ab_d == 0.0 && is_within(p, a, b, d)) return true;
  if (cd_a == 0.0 && is_within(p, c, d, a)) return true;
  if (cd_b == 0.0 && is_within(p, c, d, b)) return true;
  return ((ab_c > 0.0) != (ab_d > 0.0)) && ab_c != 0.0 && ab_d != 0.0 && ((cd_a > 0.0) != (cd_b > 0.0)) &&
         cd_a != 0.0 && cd_b != 0.0;
}

/// Distances and products that the weights are made of.
struct Star {
  Offset s[kMaxPolygon];        // from the point to the vertices
  double r[kMaxPolygon];        // their lengths
  double area[kMaxPolygon];     // twice the area of the triangle of the point and edge i
  double product[kMaxPolygon];  // s_i . s_i+1
};

void fill(const Polygon& p, double x, double y, Star* star) {
  for (uint32_t i = 0; i < p.count; ++i) {
    star->s[i] = {p.x[i] - x, p.y[i] - y};
    star->r[i] = length(star->s[i]);
  }
  for (uint32_t i = 0; i < p.count; ++i) {
    star->area[i] = cross(star->s[i], star->s[next(p, i)]);
    star->product[i] = dot(star->s[i], star->s[next(p, i)]);
  }
}

/// The tangent of half the angle from vertex i to the next one. The two forms have no cancellation in their halves.
double half_tangent(const Polygon& p, const Star& star, uint32_t i) {
  const double lengths = star.r[i] * star.r[next(p, i)];
  if (star.product[i] < 0.0) return (lengths - star.product[i]) / star.area[i];
  return star.area[i] / (lengths + star.product[i]);
}

double weight(const Polygon& p, const Star& star, shd_barycentric kind, uint32_t i) {
  const uint32_t before = previous(p, i), after = next(p, i);
  switch (kind) {
    case SHD_BARYCENTRIC_WACHSPRESS: return turn(p, before, i, after) / (star.area[before] * star.area[i]);
    case SHD_BARYCENTRIC_MEAN_VALUE: return (half_tangent(p, star, before) + half_tangent(p, star, i)) / star.r[i];
    default:
      return (star.r[before] * star.r[before] - star.product[before]) / star.area[before] +
             (star.r[after] * star.r[after] - star.product[i]) / star.area[i];
  }
}

/// Whether a ray to the right of a point crosses the polygon an odd number of times.
bool is_inside(const Polygon& p, double x, double y) {
  bool inside = false;
  for (uint32_t i = 0; i < p.count; ++i) {
    const uint32_t k = next(p, i);
    if ((p.y[i] > y) == (p.y[k] > y)) continue;
    const double side = cross(between(p, i, k), {x - p.x[i], y - p.y[i]});
    if ((side > 0.0) == (p.y[k] > p.y[i])) inside = !inside;
  }
  return inside;
}

}  // namespace

double turn(const Polygon& polygon, uint32_t a, uint32_t b, uint32_t c) {
  return cross(between(polygon, a, b), between(polygon, a, c));
}

PolygonFlaw find_flaw(const Polygon& p) {
  for (uint32_t i = 0; i < p.count; ++i) {
    const Offset edge = between(p, i, next(p, i));
    if (edge.x == 0.0 && edge.y == 0.0) return {PolygonFlaw::kPointEdge, i, next(p, i)};
  }
  for (uint32_t i = 0; i < p.count; ++i) {
    const uint32_t before = previous(p, i), after = next(p, i);
    const bool turns_back = dot(between(p, i, before), between(p, i, after)) > 0.0;
    if (turn(p, before, i, after) == 0.0 && turns_back) return {PolygonFlaw::kFold, i, i};
  }
  for (uint32_t i = 0; i < p.count; ++i) {
    for (uint32_t k = i + 2; k < p.count; ++k) {
      if (next(p, k) == i) continue;
      if (meet(p, i, next(p, i), k, next(p, k))) return {PolygonFlaw::kCrossing, i, k};
    }
  }
  return {PolygonFlaw::kNone, 0, 0};
}

PolygonFlaw find_concavity(const Polygon& p) {
  uint32_t left = 0;
  for (uint32_t i = 0; i < p.count; ++i) left += turn(p, previous(p, i), i, next(p, i)) > 0.0;
  const bool is_left = 2 * left > p.count;
  for (uint32_t i = 0; i < p.count; ++i) {
    const double here = turn(p, previous(p, i), i, next(p, i));
    if (here == 0.0) return {PolygonFlaw::kStraight, i, i};
    if ((here > 0.0) != is_left) return {PolygonFlaw::kReflex, i, i};
  }
  return {PolygonFlaw::kNone, 0, 0};
}

PolygonPlace find_place(const Polygon& p, double point_x, double point_y) {
  const auto [x, y] = limit_distance(p, point_x, point_y);
  PolygonPlace nearest = {PolygonPlace::kOutside, 0, 0.0};
  double least = HUGE_VAL;
  for (uint32_t i = 0; i < p.count; ++i) {
    const Offset edge = between(p, i, next(p, i)), to = {x - p.x[i], y - p.y[i]};
    const double t = std::min(std::max(dot(to, edge) / dot(edge, edge), 0.0), 1.0);
    const Offset apart = {to.x - t * edge.x, to.y - t * edge.y};
    const double distance = length(apart);
    if (!(distance < least)) continue;
    least = distance;
    nearest.edge = i;
    nearest.t = t;
    const double far = std::max(length(to), length({to.x - edge.x, to.y - edge.y}));
    nearest.kind = distance <= kOnEdge * far ? PolygonPlace::kOnEdge : PolygonPlace::kOutside;
  }
  if (nearest.kind != PolygonPlace::kOnEdge && is_inside(p, x, y)) nearest.kind = PolygonPlace::kInside;
  return nearest;
}

void edge_weights(const Polygon& polygon, const PolygonPlace& place, double* weights) {
  std::fill_n(weights, polygon.count, 0.0);
  weights[place.edge] = 1.0 - place.t;
  weights[next(polygon, place.edge)] = place.t;
}

bool closed_form_weights(const Polygon& polygon, shd_barycentric kind, double x, double y, double* weights) {
  constexpr double kLargest = static_cast<double>(std::numeric_limits<float>::max());
  const Offset point = limit_distance(polygon, x, y);
  Star star;
  fill(polygon, point.x, point.y, &star);
  double sum = 0.0;
  for (uint32_t i = 0; i < polygon.count; ++i) {
    weights[i] = weight(polygon, star, kind, i);
    sum += weights[i];
  }
  bool is_finite = true;
  for (uint32_t i = 0; i < polygon.count; ++i) {
    weights[i] /= sum;
    is_finite = is_finite && std::fabs(weights[i]) <= kLargest;
  }
  return is_finite;
}

}  // namespace shd::polygon
