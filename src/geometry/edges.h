// SPDX-License-Identifier: MIT
#pragma once

#include "core/allocator.h"
#include "geometry/mesh.h"

namespace shd::geometry {

/// What lies across an edge of a triangle: another triangle, or one of these. Edge k runs from corner k to the next.
enum Across : uint32_t {
  kSameDirection = 1u << 28,   // with the number of a triangle that runs along the edge the same way
  kAcrossBorder = 0xfffffffd,  // no other triangle
  kAcrossMany = 0xfffffffe,    // two other triangles or more
  kNotItsEdge = 0xffffffff     // an earlier triangle's, or that of one without area
};
inline bool is_triangle(uint32_t across) {
  return across < kAcrossBorder;
}
inline uint32_t triangle_of(uint32_t across) {
  return across & (kSameDirection - 1);
}

/// [3 * triangle_count] what lies across each edge, told once, to the first of its triangles. Corners at the same place
/// are one, whatever their vertices; triangles without area are none. In two sorts that are linear for meshes whose
/// vertices have few triangles each; 12 bytes a triangle, and while it works 12 more and 12 for each vertex. Throws
/// std::bad_alloc.
core::Array<uint32_t> find_across(const core::Allocator& allocator, const Mesh& mesh);

}  // namespace shd::geometry
