// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/allocator.h"
#include "geometry/mesh.h"
#include "geometry/split_edges.h"

namespace shd::geometry {

/// Where a vertex comes from: a + s (b - a) + t (c - a), of every column.
struct Origin {
  uint32_t a, b, c;
  float unused;
  double s, t;
};

/// The vertices of a mesh, those on its edges and those inside its triangles, in that order; and smaller triangles.
struct CutMesh {
  core::Array<Origin> origins;
  core::Array<uint32_t> indices;
};

/// Cuts every triangle into the rows of its RowPattern. Throws std::bad_alloc.
CutMesh cut_triangles(const core::Allocator& allocator, const Mesh& mesh, const SplitEdges& edges);

}  // namespace shd::geometry
