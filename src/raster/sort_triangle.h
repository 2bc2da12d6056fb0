// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "geometry/assemble.h"

namespace shd::raster {

/// Rule for ordering the triangles of a draw for painting.
struct PaintRule {
  bool painted;            // sorted by distance; triangles that are not painted come last
  bool falls;              // depth decreases with the distance from the eye
  float bias, slope_bias;  // as in DepthState
};

/// A depth-sorted triangle and the plane of its distance. Distance is depth with its bias, negated if depth decreases
/// with the distance from the eye. The pieces of a triangle keep its plane.
struct SortTriangle {
  geometry::ScreenTriangle triangle;
  double distance, dx, dy;  // at (x, y), and per 1 / kSubpixels pixel to the right and down
  double bias;              // added to the depth
  int32_t x, y;             // fixed point
  float nearest, farthest;
  int32_t min_x, max_x, min_y, max_y;  // fixed point, ends included
  bool falls;
};

SortTriangle make_sort_triangle(const geometry::ScreenTriangle& triangle, const PaintRule& rule);

/// SortTriangle::farthest of a triangle, without the other fields.
float farthest_distance(const geometry::ScreenTriangle& triangle, const PaintRule& rule);

inline double distance_at(const SortTriangle& f, double x, double y) {
  return f.distance + f.dx * (x - static_cast<double>(f.x)) + f.dy * (y - static_cast<double>(f.y));
}

/// Twice the area, in fixed point; > 0.
int64_t doubled_area(const geometry::ScreenTriangle& t);

/// Whether the interiors of two triangles overlap on the screen. Exact.
bool overlaps(const geometry::ScreenTriangle& a, const geometry::ScreenTriangle& b);

/// Differences of distance up to this value count as zero: the change over one grid step, plus the rounding of depth to
/// float.
double tolerance(const SortTriangle& a, const SortTriangle& b);

/// Smallest and largest of a set of differences of distance.
struct DistanceRange {
  double low, high;
};
/// Distances of a's vertices minus the plane of b there.
DistanceRange beyond_plane(const SortTriangle& a, const SortTriangle& b);
/// Distance of a minus distance of b over their overlap; 0 without overlap.
DistanceRange beyond_overlap(const SortTriangle& a, const SortTriangle& b);

/// Whether a may be painted before b. The tests are the five of Newell, Newell and Sancha, "A Solution to the Hidden
/// Surface Problem" (1972): depths, boxes, a behind the plane of b, b in front of the plane of a, screen overlap. If
/// all of them fail, the distances over the overlap decide.
bool may_precede(const SortTriangle& a, const SortTriangle& b);

/// The pieces of a cut triangle.
struct TrianglePieces {
  SortTriangle piece[3];
  int count;
};

/// Cuts a triangle along the plane of another one. New vertices lie on the pixel grid, within half a grid step of the
/// cut and of the edge. Returns false if the plane misses the triangle, or if one side would have no area.
bool split_triangle(const SortTriangle& f, const SortTriangle& plane, TrianglePieces* out);

}  // namespace shd::raster
