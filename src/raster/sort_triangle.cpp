// SPDX-License-Identifier: MIT
#include "raster/sort_triangle.h"

#include <algorithm>
#include <cmath>

namespace shd::raster {
namespace {

/// Half a unit in the last place of depths near 1 for the vertices of both triangles, and the same for interpolation.
constexpr double kDepthRounding = 0x1p-23;

struct Slope {
  double dx, dy;  // depth per grid step
};

Slope slope_of(const geometry::ScreenTriangle& t) {
  const double x1 = static_cast<double>(t.x[1] - t.x[0]), y1 = static_cast<double>(t.y[1] - t.y[0]);
  const double x2 = static_cast<double>(t.x[2] - t.x[0]), y2 = static_cast<double>(t.y[2] - t.y[0]);
  const double z0 = static_cast<double>(t.z[0]);
  const double z1 = static_cast<double>(t.z[1]) - z0, z2 = static_cast<double>(t.z[2]) - z0;
  const double scale = 1.0 / static_cast<double>(doubled_area(t));
  return {(z1 * y2 - z2 * y1) * scale, (z2 * x1 - z1 * x2) * scale};
}

double bias_of(const Slope& slope, const PaintRule& rule) {
  const double steepest = std::max(std::fabs(slope.dx), std::fabs(slope.dy)) * geometry::kSubpixels;
  return static_cast<double>(rule.bias) + static_cast<double>(rule.slope_bias) * steepest;
}

float biased_distance(float z, double bias, bool falls) {
  const double depth = static_cast<double>(z) + bias;
  return static_cast<float>(falls ? -depth : depth);
}

void find_extents(SortTriangle* f) {
  const geometry::ScreenTriangle& t = f->triangle;
  const float d0 = biased_distance(t.z[0], f->bias, f->falls), d1 = biased_distance(t.z[1], f->bias, f->falls),
              d2 = biased_distance(t.z[2], f->bias, f->falls);
  f->nearest = std::min({d0, d1, d2});
  f->farthest = std::max({d0, d1, d2});
  f->min_x = std::min({t.x[0], t.x[1], t.x[2]});
  f->max_x = std::max({t.x[0], t.x[1], t.x[2]});
  f->min_y = std::min({t.y[0], t.y[1], t.y[2]});
  f->max_y = std::max({t.y[0], t.y[1], t.y[2]});
}

constexpr int next_of(int k) {
  return k == 2 ? 0 : k + 1;
}

/// Whether an edge of `a` separates the triangles: all of `b` lies on its outer side or on it.
bool has_separating_edge(const geometry::ScreenTriangle& a, const geometry::ScreenTriangle& b) {
  for (int k = 0; k < 3; ++k) {
    const int n = next_of(k);
    const int64_t dx = int64_t{a.x[n]} - a.x[k], dy = int64_t{a.y[n]} - a.y[k];
    bool separates = true;
    for (int i = 0; i < 3; ++i) {
      separates &= dx * (int64_t{b.y[i]} - a.y[k]) - dy * (int64_t{b.x[i]} - a.x[k]) <= 0;
    }
    if (separates) return true;
  }
  return false;
}

struct Point {
  double x, y;
};
struct Polygon {
  Point point[6];
  int count;
};

/// Clips a polygon to the inner side of edge k of `t`; points are relative to (x, y).
Polygon clip_to_edge(const Polygon& in, const geometry::ScreenTriangle& t, int k, int32_t x, int32_t y) {
  const int n = next_of(k);
  const double sx = static_cast<double>(t.x[k] - x), sy = static_cast<double>(t.y[k] - y);
  const double dx = static_cast<double>(t.x[n] - t.x[k]), dy = static_cast<double>(t.y[n] - t.y[k]);
  const auto side = [&](const Point& p) { return dx * (p.y - sy) - dy * (p.x - sx); };
  Polygon out;
  out.count = 0;
  for (int i = 0; i < in.count; ++i) {
    const Point &a = in.point[i], &b = in.point[i + 1 == in.count ? 0 : i + 1];
    const double sa = side(a), sb = side(b);
    if (sa >= 0.0 && out.count < 6) out.point[out.count++] = a;
    if ((sa >= 0.0) != (sb >= 0.0) && out.count < 6) {
      const double s = sa / (sa - sb);
      out.point[out.count++] = {a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)};
    }
  }
  return out;
}

bool straddles(const DistanceRange& range, double limit) {
  return range.low < -limit && range.high > limit;
}

struct GridPoint {
  int32_t x, y;
};

/// The point between vertices a (positive) and b (negative) where the difference d of distance is 0.
GridPoint crossing(const geometry::ScreenTriangle& t, const double d[3], int a, int b) {
  const double s = d[a] / (d[a] - d[b]);
  const auto between = [&](int32_t from, int32_t to) {
    const double value = static_cast<double>(from) + s * (static_cast<double>(to) - static_cast<double>(from));
    return static_cast<int32_t>(std::floor(value + 0.5));
  };
  return {between(t.x[a], t.x[b]), between(t.y[a], t.y[b])};
}

/// Appends a piece unless it has no area.
void add_piece(const SortTriangle& f, GridPoint a, GridPoint b, GridPoint c, TrianglePieces* out) {
  SortTriangle& piece = out->piece[out->count];
  piece = f;
  const geometry::ScreenTriangle& whole = f.triangle;
  const float low = std::min({whole.z[0], whole.z[1], whole.z[2]});
  const float high = std::max({whole.z[0], whole.z[1], whole.z[2]});
  const GridPoint corner[3] = {a, b, c};
  for (int k = 0; k < 3; ++k) {
    const double distance = distance_at(f, static_cast<double>(corner[k].x), static_cast<double>(corner[k].y));
    const auto z = static_cast<float>((f.falls ? -distance : distance) - f.bias);
    piece.triangle.x[k] = corner[k].x;
    piece.triangle.y[k] = corner[k].y;
    piece.triangle.z[k] = z > low ? std::min(z, high) : low;
    for (int i = 0; i < 3; ++i) {
      if (corner[k].x == whole.x[i] && corner[k].y == whole.y[i]) piece.triangle.z[k] = whole.z[i];
    }
  }
  if (doubled_area(piece.triangle) <= 0) return;
  find_extents(&piece);
  ++out->count;
}

}  // namespace

SortTriangle make_sort_triangle(const geometry::ScreenTriangle& triangle, const PaintRule& rule) {
  SortTriangle f = {};
  f.triangle = triangle;
  const Slope slope = slope_of(triangle);
  f.bias = bias_of(slope, rule);
  f.falls = rule.falls;
  const double sign = rule.falls ? -1.0 : 1.0;
  f.distance = sign * (static_cast<double>(triangle.z[0]) + f.bias);
  f.dx = sign * slope.dx;
  f.dy = sign * slope.dy;
  f.x = triangle.x[0];
  f.y = triangle.y[0];
  find_extents(&f);
  return f;
}

float farthest_distance(const geometry::ScreenTriangle& t, const PaintRule& rule) {
  const double bias = rule.slope_bias != 0.0f ? bias_of(slope_of(t), rule) : static_cast<double>(rule.bias);
  const float z = rule.falls ? std::min({t.z[0], t.z[1], t.z[2]}) : std::max({t.z[0], t.z[1], t.z[2]});
  return biased_distance(z, bias, rule.falls);
}

int64_t doubled_area(const geometry::ScreenTriangle& t) {
  return (int64_t{t.x[1]} - t.x[0]) * (int64_t{t.y[2]} - t.y[0]) -
         (int64_t{t.x[2]} - t.x[0]) * (int64_t{t.y[1]} - t.y[0]);
}

bool overlaps(const geometry::ScreenTriangle& a, const geometry::ScreenTriangle& b) {
  return !has_separating_edge(a, b) && !has_separating_edge(b, a);
}

double tolerance(const SortTriangle& a, const SortTriangle& b) {
  return std::fabs(a.dx - b.dx) + std::fabs(a.dy - b.dy) + kDepthRounding;
}

DistanceRange beyond_plane(const SortTriangle& a, const SortTriangle& b) {
  DistanceRange range;
  for (int k = 0; k < 3; ++k) {
    const double x = static_cast<double>(a.triangle.x[k]), y = static_cast<double>(a.triangle.y[k]);
    const double d = distance_at(a, x, y) - distance_at(b, x, y);
    range.low = k == 0 ? d : std::min(range.low, d);
    range.high = k == 0 ? d : std::max(range.high, d);
  }
  return range;
}

DistanceRange beyond_overlap(const SortTriangle& a, const SortTriangle& b) {
  const geometry::ScreenTriangle& t = a.triangle;
  Polygon shared;
  shared.count = 3;
  for (int k = 0; k < 3; ++k) {
    shared.point[k] = {static_cast<double>(t.x[k] - t.x[0]), static_cast<double>(t.y[k] - t.y[0])};
  }
  for (int k = 0; k < 3; ++k) shared = clip_to_edge(shared, b.triangle, k, t.x[0], t.y[0]);
  const double x = static_cast<double>(t.x[0]), y = static_cast<double>(t.y[0]);
  const double origin = distance_at(a, x, y) - distance_at(b, x, y);
  DistanceRange range = {0.0, 0.0};
  for (int i = 0; i < shared.count; ++i) {
    const double d = origin + (a.dx - b.dx) * shared.point[i].x + (a.dy - b.dy) * shared.point[i].y;
    range.low = i == 0 ? d : std::min(range.low, d);
    range.high = i == 0 ? d : std::max(range.high, d);
  }
  return range;
}

bool may_precede(const SortTriangle& a, const SortTriangle& b) {
  if (a.nearest >= b.farthest) return true;
  if (a.max_x <= b.min_x || b.max_x <= a.min_x || a.max_y <= b.min_y || b.max_y <= a.min_y) return true;
  const double limit = tolerance(a, b);
  if (beyond_plane(a, b).low >= -limit) return true;
  if (beyond_plane(b, a).high <= limit) return true;
  if (!overlaps(a.triangle, b.triangle)) return true;
  return beyond_overlap(a, b).low >= -limit;
}

bool split_triangle(const SortTriangle& f, const SortTriangle& plane, TrianglePieces* out) {
  out->count = 0;
  const double limit = tolerance(f, plane);
  if (!straddles(beyond_plane(f, plane), limit)) return false;
  const geometry::ScreenTriangle& t = f.triangle;
  double d[3];
  GridPoint corner[3];
  for (int k = 0; k < 3; ++k) {
    const double x = static_cast<double>(t.x[k]), y = static_cast<double>(t.y[k]);
    corner[k] = {t.x[k], t.y[k]};
    d[k] = distance_at(f, x, y) - distance_at(plane, x, y);
    if (std::fabs(d[k]) <= limit) d[k] = 0.0;
  }
  // The vertex that is alone on its side of the plane, or the vertex on the plane.
  int alone = 0;
  for (int k = 0; k < 3; ++k) {
    const double b = d[next_of(k)], c = d[next_of(next_of(k))];
    if (d[k] == 0.0 || (d[k] > 0.0 && b < 0.0 && c < 0.0) || (d[k] < 0.0 && b > 0.0 && c > 0.0)) alone = k;
  }
  const int second = next_of(alone), third = next_of(second);
  const auto cut = [&](int a, int b) { return d[a] > 0.0 ? crossing(t, d, a, b) : crossing(t, d, b, a); };
  if (d[alone] == 0.0) {
    const GridPoint middle = cut(second, third);
    add_piece(f, corner[alone], corner[second], middle, out);
    if (out->count == 0) return false;
    add_piece(f, corner[alone], middle, corner[third], out);
    return out->count == 2;
  }
  const GridPoint near_second = cut(alone, second), near_third = cut(alone, third);
  add_piece(f, corner[alone], near_second, near_third, out);
  if (out->count == 0) return false;
  add_piece(f, near_second, corner[second], corner[third], out);
  add_piece(f, near_second, corner[third], near_third, out);
  return out->count > 1;
}

}  // namespace shd::raster
