// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <shd/polyhedron.h>

#include "core/allocator.h"

namespace shd::polygon {

/// An edge of a cage, in the direction in which its first triangle runs.
struct CageEdge {
  uint32_t from, to;
  uint32_t triangle;
};

/// A triangle of a cage, counter-clockwise from outside.
struct CageTriangle {
  uint32_t vertex[3];
  uint32_t edge[3];      // opposite to vertex i
  uint32_t neighbor[3];  // triangle across edge i
  uint32_t new_edges;    // 0..3 of the edges, the first ones, are in no triangle before
  uint32_t plane;        // its face
};

/// Numbers that kernels read.
template <class T>
struct CageTables {
  core::Array<T> position;  // [vertex][3]
  core::Array<T> along;     // [edge][3] from `from` to `to`
  core::Array<T> normal;    // [triangle][4] outward, unit, and 1 / twice the area
};

/// A closed triangle mesh in normalised coordinates: (position - center) * scale lies in [-1, 1].
struct Cage {
  uint32_t vertex_count, edge_count, triangle_count, plane_count;
  double center[3];
  double scale;    // a power of two
  double longest;  // side of the bounding box, in (1, 2]

  core::Array<CageEdge> edge;
  core::Array<CageTriangle> triangle;
  CageTables<double> doubles;
  CageTables<float> floats;  // the same numbers, rounded

  // Faces of convex cages: the largest flat parts.
  core::Array<double> plane;        // [plane_count][4] outward unit normal, and its product with points of the plane
  core::Array<uint32_t> fan_start;  // [vertex_count + 1] first face of each vertex in the next two arrays
  core::Array<uint32_t> fan_plane;  // faces of a vertex, counter-clockwise from outside
  core::Array<double> fan_volume;   // det(n_0, n_j, n_j+1) of face j of a vertex, j > 0; otherwise 0
};

/// The first defect of a cage.
struct CageFlaw {
  enum Kind { kNone, kIndex, kTwice, kThin, kOpen, kTurned, kUnused, kFlat, kReflex, kCurved, kNoCorner } kind;
  uint32_t a, b, c;  // numbers of what the message names
};

/// Fills `cage` from checked columns. Throws std::bad_alloc.
CageFlaw make_cage(const core::Allocator& allocator, const shd_polyhedron_desc& desc, Cage* cage);

/// Adds the faces that WACHSPRESS needs. Throws std::bad_alloc.
CageFlaw make_faces(const core::Allocator& allocator, Cage* cage);

/// The point of a cage that is nearest to a point.
struct SurfacePoint {
  uint32_t triangle;
  double weight[3];  // for each vertex of the triangle
};

/// The nearest point of one triangle.
SurfacePoint nearest_on_triangle(const Cage& cage, uint32_t triangle, const double (&point)[3]);
/// The nearest point of all triangles.
SurfacePoint nearest_on_cage(const Cage& cage, const double (&point)[3]);

}  // namespace shd::polygon
