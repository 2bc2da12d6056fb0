// SPDX-License-Identifier: MIT
#include "geometry/edges.h"

#include <algorithm>

#include "geometry/buckets.h"
#include "geometry/face.h"
#include "geometry/weld.h"

namespace shd::geometry {
namespace {

/// The edges of a mesh by number: 3 t + k is edge k of triangle t.
struct Edges {
  const Mesh& mesh;
  const core::Array<uint32_t>& first;  // [vertex] lowest vertex at the same position

  uint32_t from(uint32_t edge) const { return first[mesh.indices[edge]]; }
  uint32_t to(uint32_t edge) const { return first[mesh.indices[edge % 3 == 2 ? edge - 2 : edge + 1]]; }
  uint32_t low(uint32_t edge) const { return std::min(from(edge), to(edge)); }
  uint32_t high(uint32_t edge) const { return std::max(from(edge), to(edge)); }
};

/// Stores the Across of one edge. [begin, end) are the numbers of the edge in all triangles that share it, ascending.
void store_across(const Edges& edges, const uint32_t* begin, const uint32_t* end, core::Array<uint32_t>* across) {
  uint32_t& entry = (*across)[*begin];
  if (end - begin == 1) {
    entry = kAcrossBorder;
  } else if (end - begin > 2) {
    entry = kAcrossMany;
  } else {
    entry = begin[1] / 3 + (edges.from(begin[0]) == edges.from(begin[1]) ? kSameDirection : 0u);
  }
}

}  // namespace

core::Array<uint32_t> find_across(const core::Allocator& allocator, const Mesh& mesh) {
  core::Array<uint32_t> first(allocator, mesh.vertex_count);
  const float* const position[3] = {mesh.px.data(), mesh.py.data(), mesh.pz.data()};
  weld(allocator, position, 3, mesh.vertex_count, first.data());
  const Edges edges = {mesh, first};
  core::Array<uint32_t> across(allocator, 3 * size_t{mesh.triangle_count});
  for (uint32_t t = 0; t < mesh.triangle_count; ++t) {
    const uint32_t code = is_face(mesh, t) ? kAcrossBorder : kNotItsEdge;
    for (uint32_t k = 0; k < 3; ++k) across[3 * size_t{t} + k] = code;
  }
  Buckets buckets = make_buckets(allocator, 3 * mesh.triangle_count, mesh.vertex_count, [&](uint32_t edge) {
    return across[edge] == kNotItsEdge ? kNoBucket : edges.low(edge);
  });
  std::fill(across.begin(), across.end(), kNotItsEdge);
  for (uint32_t v = 0; v < mesh.vertex_count; ++v) {
    uint32_t *begin = buckets.item.data() + buckets.start[v], *end = buckets.item.data() + buckets.start[v + 1];
    std::sort(begin, end, [&](uint32_t i, uint32_t j) {
      return edges.high(i) != edges.high(j) ? edges.high(i) < edges.high(j) : i < j;
    });
    while (begin < end) {
      const uint32_t* same = begin;
      while (begin < end && edges.high(*begin) == edges.high(*same)) ++begin;
      store_across(edges, same, begin, &across);
    }
  }
  return across;
}

}  // namespace shd::geometry
