// SPDX-License-Identifier: MIT
#include "geometry/displace.h"

#include <cmath>

#include "core/executor.h"
#include "data/vec3.h"
#include "geometry/face.h"
#include "geometry/tangents.h"
#include "geometry/weld.h"
#include "texture/lookup/sample.h"

namespace shd::geometry {
namespace {

using data::Vec3d;
using Column = core::Array<float>;

void store(Vec3d a, size_t i, Column* x, Column* y, Column* z) {
  (*x)[i] = static_cast<float>(a.x);
  (*y)[i] = static_cast<float>(a.y);
  (*z)[i] = static_cast<float>(a.z);
}
bool fits(Vec3d a) {
  constexpr double kMaxFloat = 3.4028234663852886e38;
  return std::fabs(a.x) <= kMaxFloat && std::fabs(a.y) <= kMaxFloat && std::fabs(a.z) <= kMaxFloat;
}

/// Channel r of the texture at the uv of every vertex.
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

/// Displacement of the vertices, one for each position.
struct Moves {
  core::Array<uint32_t> place;
  core::Array<Vec3d> of_place;

  Vec3d operator[](size_t vertex) const { return of_place[place[vertex]]; }
};

Moves find_moves(const core::Allocator& allocator, const shd_tessellation_desc& desc, const Column& heights,
                 const Mesh& mesh) {
  const size_t count = mesh.vertex_count;
  Moves moves = {core::Array<uint32_t>(allocator, count), core::Array<Vec3d>(allocator, count)};
  const float* const columns[3] = {mesh.px.data(), mesh.py.data(), mesh.pz.data()};
  weld(allocator, columns, 3, count, moves.place.data());
  core::Array<uint32_t> together(allocator, count);
  together.fill_zero();
  moves.of_place.fill_zero();
  for (size_t i = 0; i < count; ++i) {
    const double height = double{desc.amplitude} * (double{heights[i]} - double{desc.offset});
    Vec3d& sum = moves.of_place[moves.place[i]];
    if (std::isfinite(height)) sum = sum + height * vertex_normal(mesh, i);
    ++together[moves.place[i]];
  }
  for (size_t i = 0; i < count; ++i) {
    if (together[i] == 0) continue;
    Vec3d& move = moves.of_place[i];
    move = 1.0 / together[i] * move;
    if (!fits(position(mesh, i) + move)) move = {0.0, 0.0, 0.0};
  }
  return moves;
}

void move_vertices(const Moves& moves, Mesh* mesh) {
  for (size_t i = 0; i < mesh->vertex_count; ++i) {
    store(position(*mesh, i) + moves[i], i, &mesh->px, &mesh->py, &mesh->pz);
  }
}

/// Groups vertices that share position and normal; a group is named by its lowest vertex.
core::Array<uint32_t> smooth_groups(const core::Allocator& allocator, const Mesh& mesh) {
  core::Array<uint32_t> group(allocator, mesh.vertex_count);
  const float* const columns[6] = {mesh.px.data(), mesh.py.data(), mesh.pz.data(),
                                   mesh.nx.data(), mesh.ny.data(), mesh.nz.data()};
  weld(allocator, columns, 6, mesh.vertex_count, group.data());
  return group;
}

/// Sides and normal of a triangle; the length of the normal is twice the area.
struct FaceSides {
  Vec3d side[3];  // [k] opposite to corner k
  Vec3d normal;
};
FaceSides sides_of(const Mesh& mesh, const uint32_t* v) {
  const Vec3d a = position(mesh, v[0]);
  const Vec3d b = position(mesh, v[1]);
  const Vec3d c = position(mesh, v[2]);
  return {{c - b, a - c, b - a}, data::cross(b - a, c - a)};
}

/// Tilts normals by the gradient of the displacement along them, computed on the faces before they move. A vertex whose
/// faces have no area keeps its normal.
void tilt_normals(const core::Allocator& allocator, const core::Array<uint32_t>& group, const Moves& moves,
                  Mesh* mesh) {
  struct Slope {
    Vec3d sum;
    double area;
  };
  core::Array<Slope> slopes(allocator, mesh->vertex_count);
  slopes.fill_zero();
  for (size_t t = 0; t < mesh->triangle_count; ++t) {
    const uint32_t* const v = mesh->indices.data() + 3 * t;
    const FaceSides face = sides_of(*mesh, v);
    const double area = data::length(face.normal);
    if (!(area > 0.0 && area < INFINITY)) continue;
    Vec3d across = {0.0, 0.0, 0.0};
    for (int k = 0; k < 3; ++k) {
      const double height = data::dot(moves[v[k]], vertex_normal(*mesh, v[k]));
      across = across + height * face.side[k];
    }
    const Vec3d gradient = data::cross(1.0 / area * face.normal, across);  // times the area
    for (int k = 0; k < 3; ++k) {
      Slope& slope = slopes[group[v[k]]];
      slope.sum = slope.sum + gradient;
      slope.area += area;
    }
  }
  for (size_t i = 0; i < mesh->vertex_count; ++i) {
    const Slope& slope = slopes[group[i]];
    if (!(slope.area > 0.0)) continue;
    const Vec3d n = vertex_normal(*mesh, i);
    const Vec3d gradient = 1.0 / slope.area * slope.sum;
    const Vec3d tilted = data::normalized(n - (gradient - data::dot(gradient, n) * n));
    if (!data::is_zero(tilted)) store(tilted, i, &mesh->nx, &mesh->ny, &mesh->nz);
  }
}

/// Computes normals as sums of the surrounding face normals; a vertex whose faces have no area keeps its normal.
void compute_face_normals(const core::Allocator& allocator, const core::Array<uint32_t>& group, Mesh* mesh) {
  core::Array<Vec3d> sums(allocator, mesh->vertex_count);
  sums.fill_zero();
  for (size_t t = 0; t < mesh->triangle_count; ++t) {
    const uint32_t* const v = mesh->indices.data() + 3 * t;
    const Vec3d n = sides_of(*mesh, v).normal;
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
    const Vec3d n = vertex_normal(*mesh, i);
    const Vec3d given = {double{mesh->tx[i]}, double{mesh->ty[i]}, double{mesh->tz[i]}};
    Vec3d t = data::normalized(given - data::dot(n, given) * n);
    if (data::is_zero(t)) t = fallback_tangent(n);
    store(t, i, &mesh->tx, &mesh->ty, &mesh->tz);
  }
}

}  // namespace

void displace(const core::Context& context, const shd_tessellation_desc& desc, const texture::Texture& texture,
              const texture::Sampler& sampler, Mesh* mesh) {
  const core::Allocator& allocator = context.allocator;
  const Column heights = sample_heights(context, desc.lod, texture, sampler, *mesh);
  const Moves moves = find_moves(allocator, desc, heights, *mesh);
  if (desc.normals == SHD_DISPLACED_NORMALS_KEPT) return move_vertices(moves, mesh);
  const core::Array<uint32_t> group = smooth_groups(allocator, *mesh);
  if (desc.normals == SHD_DISPLACED_NORMALS_TILTED) tilt_normals(allocator, group, moves, mesh);
  move_vertices(moves, mesh);
  if (desc.normals == SHD_DISPLACED_NORMALS_FACES) compute_face_normals(allocator, group, mesh);
  turn_tangents(mesh);
}

}  // namespace shd::geometry
