// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <shd/tessellate.h>

#include "core/allocator.h"
#include "geometry/mesh.h"

namespace shd::geometry {

/// Number of parts of an edge: a function of the positions of its ends, independent of their order.
class EdgeFactor {
 public:
  explicit EdgeFactor(const shd_tessellation_desc& desc);

  /// @return 1..SHD_MAX_TESSELLATION_SEGMENTS
  uint32_t operator()(const Mesh& mesh, uint32_t a, uint32_t b) const;

 private:
  uint32_t adaptive(const Mesh& mesh, uint32_t a, uint32_t b) const;

  uint32_t uniform_;  // parts of every edge, or 0 if adaptive
  double max_parts_;
  double edge_length_;         // pixels or world units
  double to_world_[16];        // column-major
  bool in_pixels_;             // whether the fields below are set
  double w_[4] = {};           // clip w = w_ . (world position, 1)
  double pixels_ = 0.0;        // [pixels] size of one unit of length at w = 1
  double w_per_length_ = 0.0;  // largest change of w per unit of length
};

/// An edge between two vertices and the vertices on it.
struct SplitEdge {
  uint32_t start, end;  // the position whose lowest vertex is lower comes first
  uint32_t segments;    // parts
  uint32_t first;       // vertex of the first of segments - 1 between the ends, in order from start to end
};

/// Every edge once, and the edge of each side of each triangle; side k goes from corner k to the next.
struct SplitEdges {
  core::Buffer<SplitEdge> edge;
  core::Array<uint32_t> of_side;  // [3 * triangle_count]
  uint32_t vertex_count;          // vertices of the mesh and all its edges
};

/// Throws std::bad_alloc.
SplitEdges split_edges(const core::Allocator& allocator, const Mesh& mesh, const EdgeFactor& factor);

}  // namespace shd::geometry
