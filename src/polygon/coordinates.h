// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <shd/polygon.h>

namespace shd::polygon {

constexpr uint32_t kMaxPolygon = SHD_MAX_POLYGON_VERTICES;

/// Vertices in order, in either direction.
struct Polygon {
  uint32_t count;
  double x[kMaxPolygon], y[kMaxPolygon];
};

/// The first defect of a polygon.
struct PolygonFlaw {
  enum Kind { kNone, kPointEdge, kFold, kCrossing, kStraight, kReflex } kind;
  uint32_t a, b;  // vertex, or first vertex of one edge and of another
};

/// Finds an edge of length 0, a vertex where the polygon turns back on itself, or edges that meet elsewhere.
PolygonFlaw find_flaw(const Polygon& polygon);

/// Finds a vertex without a turn, or with a turn against the direction of the polygon.
PolygonFlaw find_concavity(const Polygon& polygon);

/// Twice the signed area of the triangle of vertices a, b, c: positive if they run counter-clockwise.
double turn(const Polygon& polygon, uint32_t a, uint32_t b, uint32_t c);

/// Position of a point.
struct PolygonPlace {
  enum Kind { kInside, kOnEdge, kOutside } kind;
  uint32_t edge;  // the edge that the point lies on, or the nearest one
  double t;       // position of the nearest point on this edge, 0..1
};
PolygonPlace find_place(const Polygon& polygon, double x, double y);

/// Sets the weights of a point of an edge.
void edge_weights(const Polygon& polygon, const PolygonPlace& place, double* weights);

/// Sets the weights of a point that does not lie on an edge: all kinds but HARMONIC. Convex kinds: inside. Returns
/// false if rounding leaves no finite floats, as for points beside polygons of extreme shapes.
/// @param weights  [polygon.count]
bool closed_form_weights(const Polygon& polygon, shd_barycentric kind, double x, double y, double* weights);

}  // namespace shd::polygon
