// SPDX-License-Identifier: MIT
#include "geometry/displace.h"

#include <cmath>

#include "core/executor.h"
#include "data/vec3d.h"
#include "geometry/tangents.h"
#include "geometry/weld.h"

namespace shd::geometry {
namespace {

using data::Vec3d;
using Column = core::Array<float>;

Vec3d at(const Column& x, const Column& y, const Column& z, size_t i) {
  return {double{x[i]}, double{y[i]}, double{z[i]}};
}
void store(Vec3d a, size_t i, Column* x, Column* y, Column* z) {
  (*x)[i] = static_cast<float>(a.x);
  (*y)[i] = static_cast<float>(a.y);
  (*z)[i] = static_cast<float>(a.z);
}
bool fits(Vec3d a) {
  constexpr double kMost = 3.4028234663852886e38;
  return std::fabs(a.x) <= kMost && std::fabs(a.y) <= kMost && std::fabs(a.z) <= kMost;
}

/// The texture at the uv of every vertex, channel r.
Column sample_heights(const core::Context& context, float lod, const texture::Texture& texture,
                      const texture::Sampler& sampler, const Mesh& mesh) {
  constexpr size_t kChunk = 4096;  // vertices per task
  const size_t count = mesh.vertex_count;
  Column heights(context.allocator, count);
  Column lods(context.allocator, kChunk);
  for (float& value : lods) value = lod;
  core::parallel_for(context, static_cast<uint32_t>((count + kChunk - 1) / kChunk), [&](uint32_t task, uint32_t) {
    const size_t first = task * kChunk;
    texture::Lookups lookups = {};
    lookups.count = count - first < kChunk ? count - first : kChunk;
    lookups.u = mesh.u.data() + first;
    lookups.v = mesh.v.data() + first;
    lookups.lod = lods.data();
    texture::Texels out = {};
    out.channel[0] = heights.data() + first;
    texture::sample(texture, sampler, context.simd, lookups, out);
  });
  return heights;
}

void move_vertices(const core::Allocator& allocator, const shd_tessellation_desc& desc, const Column& heights,
                   Mesh* mesh) {
  const size_t count = mesh->vertex_count;
  core::Array<uint32_t> place(allocator, count);
  const float* const columns[3] = {mesh->px.data(), mesh->py.data(), mesh->pz.data()};
  weld(allocator, columns, 3, count, place.data());
  struct Move {
    Vec3d sum;
    double count;
  };
  core::Array<Move> moves(allocator, count);
  moves.fill_zero();
  for (size_t i = 0; i < count; ++i) {
    const double height = double{desc.amplitude} * (double{heights[i]} - double{desc.offset});
    Move& move = moves[place[i]];
    if (std::isfinite(height)) move.sum = move.sum + height * at(mesh->nx, mesh->ny, mesh->nz, i);
    move.count += 1.0;
  }
  for (size_t i = 0; i < count; ++i) {
    const Move& move = moves[place[i]];
    const Vec3d moved = at(mesh->px, mesh->py, mesh->pz, i) + 1.0 / move.count * move.sum;
    if (fits(moved)) store(moved, i, &mesh->px, &mesh->py, &mesh->pz);
  }
}

/// Which vertices share position and normal, by the lowest of them.
core::Array<uint32_t> smooth_groups(const core::Allocator& allocator, const Mesh& mesh) {
  core::Array<uint32_t> group(allocator, mesh.vertex_count);
  const float* const columns[6] = {mesh.px.data(), mesh.py.data(), mesh.pz.data(),
                                   mesh.nx.data(), mesh.ny.data(), mesh.nz.data()};
  weld(allocator, columns, 6, mesh.vertex_count, group.data());
  return group;
}

/// Sums of cross products over groups; a vertex whose faces have no area keeps its normal.
void compute_displaced_normals(const core::Allocator& allocator, const core::Array<uint32_t>& group, Mesh* mesh) {
  core::Array<Vec3d> sums(allocator, mesh->vertex_count);
  sums.fill_zero();
  for (size_t t = 0; t < mesh->triangle_count; ++t) {
    const uint32_t* const v = mesh->indices.data() + 3 * t;
    const Vec3d a = at(mesh->px, mesh->py, mesh->pz, v[0]);
    const Vec3d n = data::cross(at(mesh->px, mesh->py, mesh->pz, v[1]) - a, at(mesh->px, mesh->py, mesh->pz, v[2]) - a);
    if (!(data::dot(n, n) < INFINITY)) continue;
    for (int k = 0; k < 3; ++k) {
      Vec3d& sum = sums[group[v[k]]];
      sum = sum + n;
    }
  }
  for (size_t i = 0; i < mesh->vertex_count; ++i) {
    const Vec3d n = data::normalized(sums[group[i]]);
    if (!data::is_zero(n)) store(n, i, &mesh->nx, &mesh->ny, &mesh->nz);
  }
}

void turn_tangents(Mesh* mesh) {
  if (mesh->tx.size() == 0) return;
  for (size_t i = 0; i < mesh->vertex_count; ++i) {
    const Vec3d n = at(mesh->nx, mesh->ny, mesh->nz, i);
    const Vec3d given = at(mesh->tx, mesh->ty, mesh->tz, i);
    Vec3d t = data::normalized(given - data::dot(n, given) * n);
    if (data::is_zero(t)) t = fallback_tangent(n);
    store(t, i, &mesh->tx, &mesh->ty, &mesh->tz);
  }
}

}  // namespace

void displace(const core::Context& context, const shd_tessellation_desc& desc, const texture::Texture& texture,
              const texture::Sampler& sampler, Mesh* mesh) {
  const core::Allocator& allocator = context.allocator;
  const bool computed = desc.normals == SHD_DISPLACED_NORMALS_COMPUTED;
  const Column heights = sample_heights(context, desc.lod, texture, sampler, *mesh);
  const core::Array<uint32_t> group = computed ? smooth_groups(allocator, *mesh) : core::Array<uint32_t>();
  move_vertices(allocator, desc, heights, mesh);
  if (!computed) return;
  compute_displaced_normals(allocator, group, mesh);
  turn_tangents(mesh);
}

}  // namespace shd::geometry
