// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <shd/mesh.h>

#include "core/allocator.h"
#include "core/context.h"

namespace shd::geometry {

/// Vertices as columns of data::padded(vertex_count) elements, padded with zeros, and triangles as index triples.
struct Mesh {
  uint32_t vertex_count;
  uint32_t triangle_count;
  core::Array<float> px, py, pz;                     // object space
  core::Array<float> nx, ny, nz;                     // object space, unit
  core::Array<float> u, v;                           // 0 if the caller gave none
  core::Array<float> tx, ty, tz, tw;                 // empty unless given or computed
  core::Array<float> u1, v1;                         // empty if the caller gave none
  core::Array<float> attribute[SHD_MAX_ATTRIBUTES];  // each empty if the caller gave none
  core::Array<uint32_t> indices;                     // 3 * triangle_count, each < vertex_count
  shd_mesh_info info;

  bool has_adjacency;
  core::Array<uint32_t> across;  // [3 * triangle_count], see edges.h; empty without adjacency
};

/// Largest number of triangles of a mesh.
constexpr size_t kMaxTriangles = size_t{1} << 28;

constexpr size_t kMaxColumns = 14 + SHD_MAX_ATTRIBUTES;

/// Calls body(column) for every column of vertices, including absent ones. AnyMesh is Mesh or const Mesh.
template <class AnyMesh, class Body>
void for_each_column(AnyMesh* mesh, const Body& body) {
  for (auto* column : {&mesh->px, &mesh->py, &mesh->pz, &mesh->nx, &mesh->ny, &mesh->nz, &mesh->u, &mesh->v, &mesh->tx,
                       &mesh->ty, &mesh->tz, &mesh->tw, &mesh->u1, &mesh->v1}) {
    body(column);
  }
  for (auto& column : mesh->attribute) body(&column);
}

/// Sets the counts and bounds of info that follow from the columns; the counts of normals and tangents stay as they
/// are.
void measure(Mesh* mesh);

/// Builds a mesh from a desc whose fields are in range. Throws Failure for an invalid index or position, and
/// std::bad_alloc.
void build(const core::Context& context, const shd_mesh_desc& desc, Mesh* out);

}  // namespace shd::geometry
