// SPDX-License-Identifier: MIT
#include "geometry/tessellate.h"

#include <cmath>

#include "core/executor.h"
#include "core/status.h"
#include "data/data.h"
#include "data/vec3d.h"
#include "geometry/displace.h"
#include "geometry/edges.h"
#include "geometry/row_pattern.h"
#include "geometry/tangents.h"

namespace shd::geometry {
namespace {

using data::Vec3d;
using Column = core::Array<float>;

/// Where a vertex comes from: a + s (b - a) + t (c - a), of every column.
struct Origin {
  uint32_t a, b, c;
  float unused;
  double s, t;
};

/// Counts without memory. Throws Failure when there are more than max_triangles.
size_t count_triangles(const Mesh& mesh, const shd_tessellation_desc& desc, const EdgeFactor& factor) {
  const auto refuse = [&] {
    core::require(core::fail(SHD_ERROR_INVALID_ARGUMENT, "tessellation.max_triangles: %zu of %u are not enough",
                             desc.max_triangles, mesh.triangle_count));
  };
  const bool uniform = desc.mode == SHD_TESSELLATION_UNIFORM;
  const size_t square = size_t{desc.segments} * desc.segments;
  size_t sum = uniform ? mesh.triangle_count * square : 0;
  for (size_t t = 0; t < mesh.triangle_count && !uniform && sum <= desc.max_triangles; ++t) {
    const uint32_t* const v = mesh.indices.data() + 3 * t;
    const uint32_t segments[3] = {factor(mesh, v[0], v[1]), factor(mesh, v[1], v[2]), factor(mesh, v[2], v[0])};
    sum += RowPattern(segments).triangle_count();
  }
  if (sum > desc.max_triangles) refuse();
  return sum;
}

/// Vertices and triangles as they are made.
class Cutter {
 public:
  Cutter(const core::Allocator& allocator, const Mesh& mesh, size_t triangle_count, const SplitEdges& edges)
      : mesh_(mesh),
        edges_(edges),
        vertex_count(count_vertices(mesh, edges)),
        origins(allocator, vertex_count),
        indices(allocator, 3 * triangle_count),
        next_inner_(edges.vertex_count),
        next_index_(indices.data()) {
    for (uint32_t v = 0; v < mesh.vertex_count; ++v) origins[v] = {v, v, v, 0.0f, 0.0, 0.0};
    for (size_t e = 0; e < edges.edge.size(); ++e) {
      const SplitEdge& edge = edges.edge[e];
      for (uint32_t k = 1; k < edge.segments; ++k) {
        origins[edge.first + k - 1] = {edge.start, edge.end, edge.start, 0.0f, 1.0 * k / edge.segments, 0.0};
      }
    }
  }

  void cut(uint32_t triangle);

 private:
  /// A side of the triangle at hand, seen from one of its ends.
  struct Side {
    const SplitEdge* edge;
    bool forward;

    uint32_t vertex(uint32_t place) const {
      const uint32_t k = forward ? place : edge->segments - place;
      return k == 0 ? edge->start : k == edge->segments ? edge->end : edge->first + k - 1;
    }
  };
  /// A row of the pattern: its ends and the first vertex between them.
  struct Row {
    uint32_t parts, left, right, inner;
    const Side* base;  // of the last row, or null

    uint32_t vertex(uint32_t i) const {
      if (base) return base->vertex(i);
      return i == 0 ? left : i == parts ? right : inner + i - 1;
    }
  };

  static uint32_t count_vertices(const Mesh& mesh, const SplitEdges& edges) {
    size_t sum = edges.vertex_count;
    for (size_t t = 0; t < mesh.triangle_count; ++t) sum += pattern_of(edges, t).inner_count();
    return static_cast<uint32_t>(sum);
  }
  static RowPattern pattern_of(const SplitEdges& edges, size_t triangle) {
    uint32_t segments[3];
    for (size_t k = 0; k < 3; ++k) segments[k] = edges.edge[edges.of_side[3 * triangle + k]].segments;
    return RowPattern(segments);
  }
  /// Side between two corners, seen from `from`.
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

 public:
  const uint32_t vertex_count;
  core::Array<Origin> origins;
  core::Array<uint32_t> indices;

 private:
  uint32_t next_inner_;
  uint32_t* next_index_;
};

/// Triangles between two rows: always the one whose next part has its middle further to the left. Where the rows share
/// an end, the triangle there has no third corner.
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
      origins[next_inner_++] = {corner[apex],       corner[base],
                                corner[after],      0.0f,
                                (1.0 - f) * l / pattern.left, f * k / pattern.right};
    }
    join(upper, lower, l == pattern.left_place(r - 1), k == pattern.right_place(r - 1));
    upper = lower;
  }
}

constexpr size_t kChunk = 8192;  // vertices per task

/// body(begin, end) over vertices on the executor.
template <class Body>
void for_vertices(const core::Context& context, size_t begin, size_t end, const Body& body) {
  const size_t tasks = begin < end ? (end - begin + kChunk - 1) / kChunk : 0;
  core::parallel_for(context, static_cast<uint32_t>(tasks), [&](uint32_t task, uint32_t) {
    const size_t first = begin + task * kChunk;
    body(first, end - first < kChunk ? end : first + kChunk);
  });
}

void interpolate(const core::Context& context, const Mesh& mesh, const core::Array<Origin>& origins, Mesh* out) {
  const Column* from[kMaxColumns];
  Column* to[kMaxColumns];
  size_t count = 0;
  for_each_column(&mesh, [&](const Column* column) { from[count++] = column; });
  count = 0;
  for_each_column(out, [&](Column* column) {
    if (from[count]->size()) *column = Column(context.allocator, data::padded(origins.size()));
    for (size_t i = origins.size(); i < column->size(); ++i) (*column)[i] = 0.0f;
    to[count++] = column;
  });
  for_vertices(context, 0, origins.size(), [&](size_t begin, size_t end) {
    for (size_t c = 0; c < count; ++c) {
      const float* const in = from[c]->data();
      if (!in) continue;
      for (size_t i = begin; i < end; ++i) {
        const Origin& o = origins[i];
        const double a = double{in[o.a]};
        (*to[c])[i] = static_cast<float>(a + o.s * (double{in[o.b]} - a) + o.t * (double{in[o.c]} - a));
      }
    }
  });
}

void make_unit(float* x, float* y, float* z, Vec3d otherwise) {
  Vec3d a = data::normalized({double{*x}, double{*y}, double{*z}});
  if (data::is_zero(a)) a = otherwise;
  *x = static_cast<float>(a.x);
  *y = static_cast<float>(a.y);
  *z = static_cast<float>(a.z);
}

/// Unit normals and tangents of the vertices that are new; those that cancel become (0, 0, 1) and the fallback.
void normalize_new(const core::Context& context, size_t first_new, Mesh* mesh) {
  for_vertices(context, first_new, mesh->vertex_count, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      make_unit(&mesh->nx[i], &mesh->ny[i], &mesh->nz[i], {0.0, 0.0, 1.0});
      if (mesh->tx.size() == 0) continue;
      const Vec3d n = {double{mesh->nx[i]}, double{mesh->ny[i]}, double{mesh->nz[i]}};
      make_unit(&mesh->tx[i], &mesh->ty[i], &mesh->tz[i], fallback_tangent(n));
      mesh->tw[i] = mesh->tw[i] < 0.0f ? -1.0f : 1.0f;
    }
  });
}

}  // namespace

void tessellate(const core::Context& context, const Mesh& mesh, const shd_tessellation_desc& desc,
                const texture::Texture* displacement, const texture::Sampler* sampler, Mesh* out) {
  const core::Allocator& allocator = context.allocator;
  const EdgeFactor factor(desc);
  const size_t triangle_count = count_triangles(mesh, desc, factor);
  Mesh made{};
  {
    const SplitEdges edges = split_edges(allocator, mesh, factor);
    Cutter cutter(allocator, mesh, triangle_count, edges);
    for (uint32_t t = 0; t < mesh.triangle_count; ++t) cutter.cut(t);
    made.vertex_count = cutter.vertex_count;
    made.triangle_count = static_cast<uint32_t>(triangle_count);
    made.indices = std::move(cutter.indices);
    interpolate(context, mesh, cutter.origins, &made);
  }
  normalize_new(context, mesh.vertex_count, &made);
  made.info.normalless_count = mesh.info.normalless_count;
  made.info.tangentless_count = mesh.info.tangentless_count;
  made.info.split_count = mesh.info.split_count;
  if (displacement && desc.amplitude != 0.0f) displace(context, desc, *displacement, *sampler, &made);
  measure(&made);
  *out = std::move(made);
}

}  // namespace shd::geometry
