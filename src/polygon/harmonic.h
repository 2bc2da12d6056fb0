// SPDX-License-Identifier: MIT
#pragma once

#include "core/allocator.h"
#include "polygon/triangulate.h"

namespace shd::polygon {

/// Harmonic coordinates of a polygon: the values at the nodes of linear elements. The sides of each triangle of the
/// triangulation have `segments` parts.
struct HarmonicField {
  Triangulation triangles;
  uint32_t segments, vertex_count;
  uint32_t first_interior;     // node after those of vertices and sides
  core::Array<uint32_t> side;  // [vertex][vertex] number of the side between two vertices
  core::Array<double> value;   // [node][vertex_count]
};

/// Nodes of the triangulations of a polygon.
size_t harmonic_node_count(uint32_t vertex_count, uint32_t segments);

/// Solves the Laplace equation for all vertices of a polygon without flaws. Returns false if it cannot be triangulated.
/// Throws std::bad_alloc.
bool solve_harmonic(const core::Allocator& allocator, const Polygon& polygon, uint32_t segments, HarmonicField* out);

/// Sets the weights of a point inside.
void harmonic_weights(const Polygon& polygon, const HarmonicField& field, double x, double y, double* weights);

}  // namespace shd::polygon
