// SPDX-License-Identifier: MIT
#include "geometry/tessellate.h"

#include <cmath>

#include "core/executor.h"
#include "core/status.h"
#include "data/data.h"
#include "data/vec3.h"
#include "geometry/cut.h"
#include "geometry/displace.h"
#include "geometry/row_pattern.h"
#include "geometry/split_edges.h"
#include "geometry/tangents.h"

namespace shd::geometry {
namespace {

using data::Vec3d;
using Column = core::Array<float>;

/// Counts triangles without allocating. Throws Failure if there are more than max_triangles.
void require_triangles(const Mesh& mesh, const shd_tessellation_desc& desc, const EdgeFactor& factor) {
  const bool uniform = desc.mode == SHD_TESSELLATION_MODE_UNIFORM;
  const size_t square = size_t{desc.segments} * desc.segments;
  size_t sum = uniform ? mesh.triangle_count * square : 0;
  for (size_t t = 0; t < mesh.triangle_count && !uniform && sum <= desc.max_triangles; ++t) {
    const uint32_t* const v = mesh.indices.data() + 3 * t;
    const uint32_t segments[3] = {factor(mesh, v[0], v[1]), factor(mesh, v[1], v[2]), factor(mesh, v[2], v[0])};
    sum += RowPattern(segments).triangle_count();
  }
  if (sum <= desc.max_triangles) return;
  core::refuse(SHD_ERROR_INVALID_ARGUMENT, "tessellation.max_triangles: %u, but the %u triangles become %s%zu",
               desc.max_triangles, mesh.triangle_count, uniform ? "" : "at least ", sum);
}

constexpr size_t kChunk = 8192;  // vertices per task

/// Runs body(begin, end) over ranges of vertices on the executor.
template <class Body>
void for_vertices(const core::Context& context, size_t begin, size_t end, const Body& body) {
  const size_t tasks = begin < end ? (end - begin + kChunk - 1) / kChunk : 0;
  core::parallel_for(context, static_cast<uint32_t>(tasks), [&](uint32_t task, uint32_t) {
    const size_t first = begin + task * kChunk;
    body(first, end - first < kChunk ? end : first + kChunk);
  });
}

/// The vertices of `mesh` are copied, because interpolation would turn infinity into NaN. There is one zero, so that
/// vertices at one position have the same bits.
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
      size_t i = begin;
      for (; i < end && i < mesh.vertex_count; ++i) (*to[c])[i] = in[i] + 0.0f;
      for (; i < end; ++i) {
        const Origin& o = origins[i];
        const double a = double{in[o.a]};
        (*to[c])[i] = static_cast<float>(a + o.s * (double{in[o.b]} - a) + o.t * (double{in[o.c]} - a));
      }
    }
  });
}

void make_unit(float* x, float* y, float* z, Vec3d otherwise) {
  Vec3d a = data::normalized(Vec3d{double{*x}, double{*y}, double{*z}});
  if (data::is_zero(a)) a = otherwise;
  *x = static_cast<float>(a.x);
  *y = static_cast<float>(a.y);
  *z = static_cast<float>(a.z);
}

/// Normalises the normals and tangents of new vertices; zero vectors become (0, 0, 1) and the fallback.
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
  require_triangles(mesh, desc, factor);
  Mesh made{};
  {
    const SplitEdges edges = split_edges(allocator, mesh, factor);
    CutMesh cut = cut_triangles(allocator, mesh, edges);
    made.vertex_count = static_cast<uint32_t>(cut.origins.size());
    made.triangle_count = static_cast<uint32_t>(cut.indices.size() / 3);
    made.indices = std::move(cut.indices);
    interpolate(context, mesh, cut.origins, &made);
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
