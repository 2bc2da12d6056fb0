// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/allocator.h"
#include "geometry/mesh.h"
#include "geometry/split_edges.h"

namespace shd::geometry {

/// Origin of a new vertex: every column is a + s (b - a) + t (c - a).
struct Origin {
  uint32_t a, b, c;
  float unused;
  double s, t;
};

/// Vertices and triangles of a subdivided mesh. The vertices of the original mesh come first, then the vertices on its
/// edges, then the vertices inside its triangles.
struct CutMesh {
  core::Array<Origin> origins;
  core::Array<uint32_t> indices;
};

/// Subdivides every triangle into the rows of its RowPattern. Throws std::bad_alloc.
CutMesh cut_triangles(const core::Allocator& allocator, const Mesh& mesh, const SplitEdges& edges);

}  // namespace shd::geometry
