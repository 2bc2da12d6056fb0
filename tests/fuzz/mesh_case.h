// SPDX-License-Identifier: MIT
/// @file
/// Small meshes, valid and invalid: separate triangles, strips and fans, shared and coincident vertices.
#pragma once

#include "host.h"

namespace shd::fuzz {

constexpr uint32_t kMeshColumns = 14;  // position 3, normal 3, tangent 4, uv 2, uv1 2

struct MeshCase {
  shd_mesh_desc desc = shd_mesh_desc_default();
  std::vector<float> columns[kMeshColumns];
  std::vector<uint32_t> indices;
  std::vector<uint16_t> indices16;
  shd_f32_in attributes[3] = {};
  bool finite = true;  // positions
};

inline bool has_column(uint32_t k, uint32_t present) {
  return k < 3 || present >> (k < 6 ? 0 : k < 10 ? 1 : k < 12 ? 2 : 3) & 1;
}

inline void choose_columns(Source& source, MeshCase& c) {
  const uint32_t present = source.below(16);  // normal, tangent, uv, uv1
  const bool hostile = source.one_in(8);
  const bool grid = source.one_in(2);  // coincident vertices, coplanar triangles
  for (uint32_t k = 0; k < kMeshColumns; ++k) {
    if (!has_column(k, present)) continue;
    c.columns[k].resize(c.desc.vertex_count);
    for (float& value : c.columns[k]) {
      value = hostile ? source.hostile() : source.real();
      if (grid && std::fabs(value) <= 1.0f) value = std::round(2.0f * value) * 0.5f;
      if (k < 3) c.finite = c.finite && std::isfinite(value);
    }
  }
  shd_f32_in* places[kMeshColumns] = {};
  for (uint32_t k = 0; k < 3; ++k) places[k] = &c.desc.position[k], places[3 + k] = &c.desc.normal[k];
  for (uint32_t k = 0; k < 4; ++k) places[6 + k] = &c.desc.tangent[k];
  for (uint32_t k = 0; k < 2; ++k) places[10 + k] = &c.desc.uv[k], places[12 + k] = &c.desc.uv1[k];
  for (uint32_t k = 0; k < kMeshColumns; ++k) places[k]->data = c.columns[k].empty() ? nullptr : c.columns[k].data();
}

inline void choose_indices(Source& source, MeshCase& c, uint32_t max_indices) {
  const uint32_t width = source.below(4);  // none, 16 or 32 bits
  uint32_t count = source.below(max_indices + 1);
  if (c.desc.topology == SHD_TOPOLOGY_TRIANGLES && !source.one_in(64)) count -= count % 3;
  if (width == 0) {
    c.desc.index_count = source.one_in(2) ? count : 0;
    if (c.desc.topology == SHD_TOPOLOGY_TRIANGLES && c.desc.index_count == 0)
      c.desc.vertex_count -= c.desc.vertex_count % 3;
    return;
  }
  for (uint32_t i = 0; i < count; ++i) {
    uint32_t index = source.below(128);
    const bool restart = index == 127 && c.desc.topology != SHD_TOPOLOGY_TRIANGLES;
    if (index != 126) index %= c.desc.vertex_count ? c.desc.vertex_count : 1;
    if (restart) index = 0xffffffffu;
    c.indices.push_back(index);
    c.indices16.push_back(static_cast<uint16_t>(index));
  }
  c.desc.index_count = count;
  if (count == 0) return;
  if (width == 1) {
    c.desc.indices16.data = c.indices16.data();
  } else {
    c.desc.indices.data = c.indices.data();
  }
}

inline void choose_affine(Source& source, float* matrix) {
  const uint32_t kind = source.below(8);
  for (int i = 0; i < 16; ++i) {
    matrix[i] = i % 5 == 0 ? 1.0f : 0.0f;
    if (kind > 3 || (kind != 0 && i % 4 == 3)) continue;
    matrix[i] = kind == 0 ? source.hostile() : source.real();
  }
}

/// A projection of uv, mostly in place of the columns.
inline void choose_projection(Source& source, MeshCase& c) {
  c.desc.uv_projection = source.constant<shd_uv_projection>(5);
  choose_affine(source, c.desc.object_to_projection);
  if (!source.one_in(16)) c.desc.uv[0].data = c.desc.uv[1].data = nullptr;
}

/// A mesh of at most max_vertices vertices and max_indices indices. Its columns point into `c`, which must not move.
inline void choose_mesh(Source& source, MeshCase& c, uint32_t max_vertices, uint32_t max_indices) {
  c.desc.vertex_count = source.below(max_vertices + 1);
  c.desc.topology = source.constant<shd_topology>(3);
  c.desc.normal_weight = source.constant<shd_normal_weight>(3);
  c.desc.flags = source.flags(SHD_MESH_KEEP_NONFINITE | SHD_MESH_TANGENTS | SHD_MESH_ADJACENCY);
  choose_indices(source, c, max_indices);
  choose_columns(source, c);
  c.desc.attribute_count = source.one_in(32) ? source.below(12) : source.below(4);
  for (shd_f32_in& attribute : c.attributes) attribute.data = source.one_in(2) ? c.desc.position[0].data : nullptr;
  c.desc.attributes = c.desc.attribute_count > 3 ? nullptr : c.attributes;
  if (source.one_in(4)) choose_projection(source, c);
  if (source.one_in(128)) c.desc.struct_size = source.one_in(2) ? source.below(32) : 0x80000000u | source.word();
}

/// Everything that can be read from a mesh, checked.
struct MeshData {
  shd_mesh_info info = shd_mesh_info_default();
  std::vector<uint32_t> indices;
  std::vector<float> positions[3], normals[3], tangents[4];
};

inline void check_unit(float x, float y, float z) {
  const double length = std::sqrt(double{x} * x + double{y} * y + double{z} * z);
  SHD_FUZZ_CHECK(std::fabs(length - 1.0) < 1e-4);
}

inline void read_floats(shd_result (*read)(const shd_mesh*, const shd_f32_out*), const shd_mesh* mesh, size_t count,
                        int columns, std::vector<float>* out) {
  std::vector<Column<float>> values(static_cast<size_t>(columns), Column<float>(count, 2, kCanary));
  shd_f32_out places[4] = {};
  for (int k = 0; k < columns; ++k) places[k] = to_column(values[static_cast<size_t>(k)]);
  SHD_FUZZ_CHECK(read(mesh, places) == SHD_OK);
  for (int k = 0; k < columns; ++k) {
    const Column<float>& column = values[static_cast<size_t>(k)];
    column.check_canaries();
    for (size_t i = 0; i < count; ++i) out[k].push_back(column[i]);
  }
}

/// Reads a mesh back. Indices are in range, normals are unit vectors, counts agree.
inline void read_mesh(const shd_mesh* mesh, MeshData& data) {
  SHD_FUZZ_CHECK(shd_mesh_get_info(mesh, &data.info) == SHD_OK);
  const size_t vertices = data.info.vertex_count, corners = size_t{3} * data.info.triangle_count;
  Column<uint32_t> indices(corners, 1, kCanaryWord);
  const shd_u32_out place = to_column(indices);
  SHD_FUZZ_CHECK(shd_mesh_read_indices(mesh, &place) == SHD_OK);
  indices.check_canaries();
  for (size_t i = 0; i < corners; ++i) {
    SHD_FUZZ_CHECK(indices[i] < vertices);
    data.indices.push_back(indices[i]);
  }
  read_floats(shd_mesh_read_positions, mesh, vertices, 3, data.positions);
  read_floats(shd_mesh_read_normals, mesh, vertices, 3, data.normals);
  read_floats(shd_mesh_read_tangents, mesh, vertices, 4, data.tangents);
  uint32_t nonfinite = 0;
  for (size_t i = 0; i < vertices; ++i) {
    bool finite = true;
    for (int k = 0; k < 3; ++k) {
      const float value = data.positions[k][i];
      finite = finite && std::isfinite(value);
    }
    nonfinite += !finite;
    for (int k = 0; finite && k < 3; ++k) {
      SHD_FUZZ_CHECK(data.positions[k][i] >= data.info.bounds_min[k] &&
                     data.positions[k][i] <= data.info.bounds_max[k]);
    }
    check_unit(data.normals[0][i], data.normals[1][i], data.normals[2][i]);
  }
  SHD_FUZZ_CHECK(data.info.nonfinite_count == nonfinite);
}

}  // namespace shd::fuzz
