// SPDX-License-Identifier: MIT
#pragma once

#include "core/allocator.h"
#include "geometry/mesh.h"

namespace shd::geometry {

/// The other side of an edge of a triangle: another triangle, or one of these. Edge k runs from corner k to the next.
enum Across : uint32_t {
  kSameDirection = 1u << 28,   // flag of a triangle number: both triangles run along the edge in the same direction
  kAcrossBorder = 0xfffffffd,  // no other triangle
  kAcrossMany = 0xfffffffe,    // two or more other triangles
  kNotItsEdge = 0xffffffff     // an earlier triangle owns the edge, or the triangle has no area
};
inline bool is_triangle(uint32_t across) {
  return across < kAcrossBorder;
}
inline uint32_t triangle_of(uint32_t across) {
  return across & (kSameDirection - 1);
}

/// [3 * triangle_count] Across of each edge, stored once, at the first triangle of the edge. Corners at the same
/// position are merged, even if their vertices differ; triangles without area are ignored. Two sorts, linear for meshes
/// whose vertices have few triangles each. Needs 12 bytes per triangle, and temporarily 12 more and 12 per vertex.
/// Throws std::bad_alloc.
core::Array<uint32_t> find_across(const core::Allocator& allocator, const Mesh& mesh);

}  // namespace shd::geometry
