// SPDX-License-Identifier: MIT
#include "scene/project.h"

#include <algorithm>
#include <cmath>

#include <shd/mesh.h>

#include "extension/error.h"
#include "scene/columns.h"
#include "scene/normals.h"
#include "scene/owned.h"

namespace shd::scene {
namespace {

using extension::require;

/// A number of a vertex in two floats, each exact.
constexpr uint32_t kPart = 1u << 16;

shd_mesh_desc desc_of(const std::vector<float>& position, const Geometry& geometry) {
  shd_mesh_desc desc = shd_mesh_desc_default();
  desc.vertex_count = position.size() / 3;
  for (size_t c = 0; c < 3; ++c) desc.position[c] = {position.data() + c, 3 * sizeof(float)};
  desc.indices.data = geometry.indices.data();
  desc.index_count = geometry.indices.size();
  desc.flags = SHD_MESH_KEEP_NONFINITE;
  return desc;
}

/// For each vertex of the mesh, the vertex of the geometry that it is, or is a copy of.
std::vector<uint32_t> read_sources(const shd_mesh* mesh, size_t count) {
  std::vector<float> parts[2] = {std::vector<float>(count), std::vector<float>(count)};
  for (uint32_t i = 0; i < 2; ++i) {
    const shd_f32_out out = {parts[i].data(), 0};
    require(shd_mesh_read_attribute(mesh, i, &out));
  }
  std::vector<uint32_t> sources;
  sources.reserve(count);
  for (size_t i = 0; i < count; ++i) {
    sources.push_back(static_cast<uint32_t>(parts[0][i]) + kPart * static_cast<uint32_t>(parts[1][i]));
  }
  return sources;
}

}  // namespace

Matrix cube_of(const Bounds& box) {
  double side = 0.0;
  for (size_t c = 0; c < 3; ++c) side = std::max(side, box.high[c] - box.low[c]);
  Matrix out = kIdentity;
  if (!(side > 0.0) || !std::isfinite(side)) return out;
  for (size_t c = 0; c < 3; ++c) {
    out[5 * c] = 2.0 / side;
    out[12 + c] = -(box.low[c] + box.high[c]) / side;
  }
  return out;
}

void project_geometry(shd_context* context, shd_uv_projection projection, const Matrix& to_projection,
                      const std::vector<float>& position, Geometry* geometry) {
  shd_mesh_desc desc = desc_of(position, *geometry);
  desc.uv_projection = projection;
  for (size_t i = 0; i < 16; ++i) {
    desc.object_to_projection[i] = static_cast<float>(to_projection[i]);
    if (!std::isfinite(desc.object_to_projection[i])) return;
  }
  std::vector<float> parts[2];
  for (uint32_t i = 0; i < desc.vertex_count; ++i) {
    parts[0].push_back(static_cast<float>(i % kPart));
    parts[1].push_back(static_cast<float>(i / kPart));
  }
  const shd_f32_in attributes[2] = {{parts[0].data(), 0}, {parts[1].data(), 0}};
  desc.attributes = attributes;
  desc.attribute_count = 2;
  Mesh mesh;
  require(shd_mesh_create(context, &desc, mesh.out()));
  shd_mesh_info info = shd_mesh_info_default();
  require(shd_mesh_get_info(mesh.get(), &info));
  if (geometry->normal.empty() && geometry->shading == Shading::kSmooth) {
    geometry->normal.assign(geometry->position.size(), 0.0f);
    fill_normals(geometry->position, geometry->indices, &geometry->normal);
  }
  take_vertices(*geometry, read_sources(mesh.get(), info.vertex_count));
  geometry->uv.resize(2 * info.vertex_count);
  const shd_f32_out uv[2] = {{geometry->uv.data(), 2 * sizeof(float)}, {geometry->uv.data() + 1, 2 * sizeof(float)}};
  require(shd_mesh_read_uv(mesh.get(), uv));
  const shd_u32_out indices = {geometry->indices.data(), 0};
  require(shd_mesh_read_indices(mesh.get(), &indices));
}

}  // namespace shd::scene
