// SPDX-License-Identifier: MIT
#include "geometry/tangents.h"

#include <cmath>
#include <cstring>

#include "data/data.h"
#include "geometry/buckets.h"
#include "geometry/copies.h"
#include "geometry/face.h"
#include "geometry/tangent_groups.h"

namespace shd::geometry {
namespace {

using data::Vec3d;

/// Stored tangent and handedness; found is false for the fallback.
struct Tangent {
  float x, y, z, w;
  bool found;
};

bool same(const Tangent& a, const Tangent& b) {
  return std::memcmp(&a, &b, 4 * sizeof(float)) == 0;
}

/// A copy of a vertex with a tangent of its own.
struct Added {
  uint32_t source;
  Tangent tangent;
};

Tangent tangent_of(const Mesh& mesh, const TangentGroups& groups, uint32_t group, uint32_t vertex) {
  const bool grouped = group != kNoGroup;
  Vec3d t = grouped ? data::normalized(groups.group[group].sum) : Vec3d{0.0, 0.0, 0.0};
  const bool found = !data::is_zero(t);
  if (!found) t = fallback_tangent(vertex_normal(mesh, vertex));
  const float w = grouped && groups.group[group].mirrored ? -1.0f : 1.0f;
  return {static_cast<float>(t.x), static_cast<float>(t.y), static_cast<float>(t.z), w, found};
}

void store(const Tangent& tangent, size_t vertex, Mesh* mesh) {
  mesh->tx[vertex] = tangent.x;
  mesh->ty[vertex] = tangent.y;
  mesh->tz[vertex] = tangent.z;
  mesh->tw[vertex] = tangent.w;
  if (!tangent.found) ++mesh->info.tangentless_count;
}

/// Stores at every vertex the tangent of its first corner. Returns whether another corner needs a different tangent.
bool store_first(const TangentGroups& groups, core::Array<uint32_t>* group_of_vertex, Mesh* mesh) {
  constexpr uint32_t kUnset = kNoGroup - 1;
  core::Array<uint32_t>& group_of = *group_of_vertex;
  bool conflict = false;
  for (size_t v = 0; v < mesh->vertex_count; ++v) group_of[v] = kUnset;
  for (size_t c = 0; c < groups.of_corner.size(); ++c) {
    uint32_t& group = group_of[mesh->indices[c]];
    if (group == kUnset) group = groups.of_corner[c];
    conflict |= group != groups.of_corner[c];
  }
  for (uint32_t v = 0; v < mesh->vertex_count; ++v) {
    if (group_of[v] == kUnset) group_of[v] = kNoGroup;
    store(tangent_of(*mesh, groups, group_of[v], v), v, mesh);
  }
  return conflict;
}

/// Makes corners whose tangent differs from the tangent of their vertex refer to copies, which follow the vertices.
core::Buffer<Added> split(const core::Allocator& allocator, const TangentGroups& groups,
                          const core::Array<uint32_t>& group_of_vertex, Mesh* mesh) {
  const Buckets corners = make_buckets(allocator, static_cast<uint32_t>(mesh->indices.size()), mesh->vertex_count,
                                       [&](uint32_t corner) { return mesh->indices[corner]; });
  struct Copy {
    uint32_t source, vertex;
  };
  core::Array<Copy> copies(allocator, groups.group.size());  // [group] latest copy made for it
  for (Copy& copy : copies) copy = {kNoGroup, 0};
  core::Buffer<Added> added(allocator);
  for (uint32_t v = 0; v < mesh->vertex_count; ++v) {
    const Tangent own = {mesh->tx[v], mesh->ty[v], mesh->tz[v], mesh->tw[v], true};
    for (const uint32_t* i = corners.begin(v); i < corners.end(v); ++i) {
      const uint32_t corner = *i;
      const uint32_t group = groups.of_corner[corner];
      if (group == group_of_vertex[v]) continue;
      Copy& copy = copies[group];
      if (copy.source != v) {
        const Tangent tangent = tangent_of(*mesh, groups, group, v);
        copy = {v, v};
        if (!same(tangent, own)) {
          copy.vertex = mesh->vertex_count + static_cast<uint32_t>(added.size());
          added.push_back({v, tangent});
        }
      }
      mesh->indices[corner] = copy.vertex;
    }
  }
  return added;
}

/// Appends copies of vertices with their own tangents.
void append(const core::Allocator& allocator, const core::Buffer<Added>& added, Mesh* mesh) {
  const size_t before = mesh->vertex_count;
  append_copies(
      allocator, added.size(), [&](size_t i) { return added[i].source; }, mesh);
  for (size_t i = 0; i < added.size(); ++i) store(added[i].tangent, before + i, mesh);
}

}  // namespace

data::Vec3d fallback_tangent(data::Vec3d n) {
  const bool along_x = std::fabs(n.x) > 0.9;
  const Vec3d axis = {along_x ? 0.0 : 1.0, along_x ? 1.0 : 0.0, 0.0};
  return data::normalized(axis - data::dot(n, axis) * n);
}

void compute_tangents(const core::Allocator& allocator, Mesh* mesh) {
  core::Array<float>* const columns[4] = {&mesh->tx, &mesh->ty, &mesh->tz, &mesh->tw};
  for (core::Array<float>* column : columns) {
    *column = core::Array<float>(allocator, data::padded(mesh->vertex_count));
    column->fill_zero();
  }
  const TangentGroups groups = group_tangents(allocator, *mesh);
  core::Array<uint32_t> group_of_vertex(allocator, mesh->vertex_count);
  if (!store_first(groups, &group_of_vertex, mesh)) return;
  const core::Buffer<Added> added = split(allocator, groups, group_of_vertex, mesh);
  if (added.size()) append(allocator, added, mesh);
}

}  // namespace shd::geometry
