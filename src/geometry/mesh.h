// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <shd/mesh.h>

#include "core/allocator.h"
#include "core/context.h"

namespace shd::geometry {

/// Vertices as columns of data::padded(vertex_count) elements, the padding zero, and triangles as index triples.
struct Mesh {
  uint32_t vertex_count;
  uint32_t triangle_count;
  core::Array<float> px, py, pz;                     // object space
  core::Array<float> nx, ny, nz;                     // object space, unit
  core::Array<float> u, v;                           // 0 if the caller gave none
  core::Array<float> tx, ty, tz, tw;                 // empty if the caller gave none
  core::Array<float> u1, v1;                         // the same
  core::Array<float> attribute[SHD_MAX_ATTRIBUTES];  // each empty if the caller gave none
  core::Array<uint32_t> indices;                     // 3 * triangle_count, each < vertex_count
  shd_mesh_info info;

  bool has_adjacency;
  core::Array<uint32_t> across;  // 3 * triangle_count: see edges.h; empty without adjacency
};

/// Copies a desc whose fields are in range; throws Failure for indices and positions that are refused, and
/// std::bad_alloc.
void build(const core::Context& context, const shd_mesh_desc& desc, Mesh* out);

}  // namespace shd::geometry
