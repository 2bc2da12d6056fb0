// SPDX-License-Identifier: MIT
#include "geometry/cut.h"

#include "geometry/row_pattern.h"

namespace shd::geometry {
namespace {

RowPattern pattern_of(const SplitEdges& edges, size_t triangle) {
  uint32_t segments[3];
  for (size_t k = 0; k < 3; ++k) segments[k] = edges.edge[edges.of_side[3 * triangle + k]].segments;
  return RowPattern(segments);
}

/// Builds the vertices and triangles of a CutMesh, triangle by triangle.
class Cutter {
 public:
  Cutter(const Mesh& mesh, const SplitEdges& edges, CutMesh* out)
      : mesh_(mesh),
        edges_(edges),
        origins_(out->origins),
        next_inner_(edges.vertex_count),
        next_index_(out->indices.data()) {
    for (uint32_t v = 0; v < mesh.vertex_count; ++v) origins_[v] = {v, v, v, 0.0f, 0.0, 0.0};
    for (size_t e = 0; e < edges.edge.size(); ++e) {
      const SplitEdge& edge = edges.edge[e];
      for (uint32_t k = 1; k < edge.segments; ++k) {
        origins_[edge.first + k - 1] = {edge.start, edge.end, edge.start, 0.0f, 1.0 * k / edge.segments, 0.0};
      }
    }
  }

  void cut(uint32_t triangle);

 private:
  /// One side of the current triangle, walked from one of its ends.
  struct Side {
    const SplitEdge* edge;
    bool forward;

    uint32_t vertex(uint32_t place) const {
      const uint32_t k = forward ? place : edge->segments - place;
      return k == 0 ? edge->start : k == edge->segments ? edge->end : edge->first + k - 1;
    }
  };
  /// One row of the pattern: its ends and the first vertex between them.
  struct Row {
    uint32_t parts, left, right, inner;
    const Side* base;  // side of the last row, otherwise null

    uint32_t vertex(uint32_t i) const {
      if (base) return base->vertex(i);
      return i == 0 ? left : i == parts ? right : inner + i - 1;
    }
  };

  /// The side between two corners, walked from corner `from`.
  Side side_from(uint32_t triangle, uint32_t side, uint32_t from) const {
    const SplitEdge& edge = edges_.edge[edges_.of_side[3 * size_t{triangle} + side]];
    return {&edge, edge.start == mesh_.indices[3 * size_t{triangle} + from]};
  }
  void add_triangle(uint32_t a, uint32_t b, uint32_t c) {
    *next_index_++ = a;
    *next_index_++ = b;
    *next_index_++ = c;
  }
  void join(const Row& upper, const Row& lower, bool same_left, bool same_right);

  const Mesh& mesh_;
  const SplitEdges& edges_;
  core::Array<Origin>& origins_;
  uint32_t next_inner_;
  uint32_t* next_index_;
};

/// Adds the triangles between two rows. Each step advances on the row whose next part has its middle further to the
/// left. Where both rows share an end, the triangle there is degenerate and is left out.
void Cutter::join(const Row& upper, const Row& lower, bool same_left, bool same_right) {
  const uint32_t steps = upper.parts + lower.parts;
  uint32_t i = 0, j = 0;
  for (uint32_t step = 0; step < steps; ++step) {
    const bool down = j < lower.parts && (i == upper.parts || (2 * j + 1) * upper.parts <= (2 * i + 1) * lower.parts);
    const bool flat = (step == 0 && same_left) || (step + 1 == steps && same_right);
    if (!flat) add_triangle(upper.vertex(i), lower.vertex(j), down ? lower.vertex(j + 1) : upper.vertex(i + 1));
    (down ? j : i) += 1;
  }
}

void Cutter::cut(uint32_t triangle) {
  const RowPattern pattern = pattern_of(edges_, triangle);
  const uint32_t apex = pattern.apex_corner(), base = pattern.base_side, after = (base + 1) % 3;
  const uint32_t* const corner = mesh_.indices.data() + 3 * size_t{triangle};
  const Side left = side_from(triangle, apex, apex);  // the side after the apex ends at the base's first corner
  const Side right = side_from(triangle, after, apex);
  const Side bottom = side_from(triangle, base, base);
  Row upper = {0, corner[apex], corner[apex], 0, nullptr};
  for (uint32_t r = 1; r <= pattern.rows; ++r) {
    const uint32_t l = pattern.left_place(r), k = pattern.right_place(r);
    const bool last = r == pattern.rows;
    const Row lower = {pattern.parts(r), left.vertex(l), right.vertex(k), next_inner_, last ? &bottom : nullptr};
    for (uint32_t i = 1; i < lower.parts && !last; ++i) {
      const double f = 1.0 * i / lower.parts;
      origins_[next_inner_++] = {corner[apex],         corner[base], corner[after], 0.0f, (1.0 - f) * l / pattern.left,
                                 f * k / pattern.right};
    }
    join(upper, lower, l == pattern.left_place(r - 1), k == pattern.right_place(r - 1));
    upper = lower;
  }
}

}  // namespace

CutMesh cut_triangles(const core::Allocator& allocator, const Mesh& mesh, const SplitEdges& edges) {
  size_t vertices = edges.vertex_count, triangles = 0;
  for (size_t t = 0; t < mesh.triangle_count; ++t) {
    const RowPattern pattern = pattern_of(edges, t);
    vertices += pattern.inner_count();
    triangles += pattern.triangle_count();
  }
  CutMesh out = {core::Array<Origin>(allocator, vertices), core::Array<uint32_t>(allocator, 3 * triangles)};
  Cutter cutter(mesh, edges, &out);
  for (uint32_t t = 0; t < mesh.triangle_count; ++t) cutter.cut(t);
  return out;
}

}  // namespace shd::geometry
