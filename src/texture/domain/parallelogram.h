// SPDX-License-Identifier: MIT
/// @file
/// Cuts a parallelogram into the unit cells of a lattice and finds the moments of every piece, for integrals of
/// functions that are bilinear on each cell. Arithmetic is + - * / and floor on doubles only, so every machine computes
/// the same bits.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace shd::texture {

struct Vec2 {
  double x, y;
};

inline double cross(Vec2 a, Vec2 b) {
  return a.x * b.y - a.y * b.x;
}

/// A convex polygon. Each of four clips adds at most one corner to a parallelogram; the other corners are slack for
/// rounding.
struct Polygon {
  static constexpr size_t kMaxCorners = 16;
  size_t count = 0;
  Vec2 corner[kMaxCorners];

  void add(Vec2 p) {
    if (count < kMaxCorners) corner[count++] = p;
  }
};

/// Returns the parallelogram center + s a + t b, |s|, |t| <= 1/2. It is counter-clockwise if cross(a, b) > 0.
inline Polygon parallelogram(Vec2 center, Vec2 a, Vec2 b) {
  const Vec2 sum = {0.5 * (a.x + b.x), 0.5 * (a.y + b.y)}, difference = {0.5 * (a.x - b.x), 0.5 * (a.y - b.y)};
  Polygon out;
  out.add({center.x - sum.x, center.y - sum.y});
  out.add({center.x + difference.x, center.y + difference.y});
  out.add({center.x + sum.x, center.y + sum.y});
  out.add({center.x - difference.x, center.y - difference.y});
  return out;
}

/// Moves a polygon by -origin along one axis and returns its part where this axis is at least 0 (`above`), or at most 1
/// (Sutherland and Hodgman, "Reentrant Polygon Clipping", 1974). Corners on the line are exactly at 0 or 1.
template <double Vec2::*kAxis, double Vec2::*kOther>
Polygon clip(const Polygon& polygon, double origin, bool above) {
  const double bound = above ? 0.0 : 1.0;
  const auto is_inside = [&](Vec2 p) { return above ? p.*kAxis >= bound : p.*kAxis <= bound; };
  const auto moved = [&](size_t i) {
    Vec2 p = polygon.corner[i];
    p.*kAxis -= origin;
    return p;
  };
  Polygon out;
  if (polygon.count == 0) return out;
  Vec2 from = moved(0);
  bool inside = is_inside(from);
  for (size_t i = 1; i <= polygon.count; ++i) {
    const Vec2 to = moved(i < polygon.count ? i : 0);
    if (inside) out.add(from);
    const bool was_inside = inside;
    inside = is_inside(to);
    if (inside != was_inside) {
      const double s = (bound - from.*kAxis) / (to.*kAxis - from.*kAxis);
      Vec2 crossing;
      crossing.*kAxis = bound;
      crossing.*kOther = from.*kOther + s * (to.*kOther - from.*kOther);
      out.add(crossing);
    }
    from = to;
  }
  return out;
}

/// Moves a polygon by -origin along one axis and returns its part between 0 and 1 of this axis.
template <double Vec2::*kAxis, double Vec2::*kOther>
Polygon clip_to_unit(const Polygon& polygon, double origin) {
  return clip<kAxis, kOther>(clip<kAxis, kOther>(polygon, origin, true), 0.0, false);
}

/// Integrals of 1, x, y and x y over a polygon.
struct Moments {
  double one, x, y, xy;
};

/// Returns the moments of a polygon by Green's theorem (Steger, "On the Calculation of Arbitrary Moments of Polygons",
/// 1996). They are summed about the first corner, which avoids cancellation for small and thin polygons, and then moved
/// to the origin.
inline Moments moments(const Polygon& polygon) {
  if (polygon.count < 3) return {0, 0, 0, 0};
  const Vec2 about = polygon.corner[0];
  Moments sum = {0, 0, 0, 0};
  Vec2 p = {0, 0};
  for (size_t i = 1; i < polygon.count; ++i) {
    const Vec2 q = {polygon.corner[i].x - about.x, polygon.corner[i].y - about.y};
    const double area = cross(p, q);
    sum.one += area;
    sum.x += area * (p.x + q.x);
    sum.y += area * (p.y + q.y);
    sum.xy += area * (2 * (p.x * p.y + q.x * q.y) + p.x * q.y + q.x * p.y);
    p = q;
  }
  const double one = sum.one / 2, x = sum.x / 6, y = sum.y / 6, xy = sum.xy / 24;
  return {one, x + about.x * one, y + about.y * one, xy + about.x * y + about.y * x + about.x * about.y * one};
}

/// A closed interval; empty by default.
struct Interval {
  double low = HUGE_VAL, high = -HUGE_VAL;

  void add(double x) {
    if (x < low) low = x;
    if (x > high) high = x;
  }
};
/// Returns the smallest and the largest x of the corners whose y is `y`, or an empty interval.
inline Interval corners_at(const Polygon& polygon, double y) {
  Interval out;
  for (size_t i = 0; i < polygon.count; ++i) {
    if (polygon.corner[i].y == y) out.add(polygon.corner[i].x);
  }
  return out;
}

/// Visits the cells of row j that a counter-clockwise parallelogram covers, from left to right. Calls
/// visitor.cell(i, j, moments) for each cell [i, i + 1] x [j, j + 1] that is covered in part, with the moments about
/// (i, j), and visitor.run(j, begin, end) once for the cells begin..end - 1 that are covered completely.
template <class Visitor>
void visit_row(const Polygon& polygon, int64_t j, Visitor* visitor) {
  const Polygon slab = clip_to_unit<&Vec2::y, &Vec2::x>(polygon, static_cast<double>(j));
  Interval extent;
  for (size_t i = 0; i < slab.count; ++i) extent.add(slab.corner[i].x);
  if (!(extent.low < extent.high)) return;
  const auto first = static_cast<int64_t>(std::floor(extent.low));
  const auto end = static_cast<int64_t>(std::floor(extent.high)) + 1;
  // A cell is covered completely if its lower and its upper side are.
  const Interval lower = corners_at(slab, 0), upper = corners_at(slab, 1);
  const double low = lower.low > upper.low ? lower.low : upper.low;
  const double high = lower.high < upper.high ? lower.high : upper.high;
  int64_t run_begin = end, run_end = end;
  if (high - low >= 1) {
    run_begin = -static_cast<int64_t>(std::floor(-low));
    run_end = static_cast<int64_t>(std::floor(high));
    if (run_end <= run_begin) run_begin = run_end = end;
  }
  for (int64_t i = first; i < end; ++i) {
    if (i == run_begin) {
      visitor->run(j, run_begin, run_end);
      i = run_end - 1;
      continue;
    }
    const Moments m = moments(clip_to_unit<&Vec2::x, &Vec2::y>(slab, static_cast<double>(i)));
    if (m.one > 0) visitor->cell(i, j, m);
  }
}

/// Visits the cells of a parallelogram row by row, from below. It visits at most cell_bound() cells.
template <class Visitor>
void visit_cells(const Polygon& polygon, Visitor* visitor) {
  Interval extent;
  for (size_t i = 0; i < polygon.count; ++i) extent.add(polygon.corner[i].y);
  const auto last = static_cast<int64_t>(std::floor(extent.high));
  for (auto j = static_cast<int64_t>(std::floor(extent.low)); j <= last; ++j) visit_row(polygon, j, visitor);
}

/// Returns an upper bound of the number of cells that visit_cells() visits for sides a and b. Completely covered cells
/// are at most the area. Partly covered cells are crossed by the outline: each of its two chains, left to right and
/// bottom to top, enters a cell through a line of the lattice.
inline double cell_bound(Vec2 a, Vec2 b) {
  const double extent = std::fabs(a.x) + std::fabs(b.x) + std::fabs(a.y) + std::fabs(b.y);
  return std::fabs(cross(a, b)) + 4 * extent + 16;
}

}  // namespace shd::texture
