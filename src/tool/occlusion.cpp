// SPDX-License-Identifier: MIT
#include "tool/occlusion.h"

#include <algorithm>

#ifdef SHD_RENDER_WITH_EMBREE
#include <shd/embree.h>
#endif

#include "command/failure.h"

namespace {

/// All columns of a mesh, and one of occlusion.
struct Columns {
  std::vector<float> position[3], normal[3], tangent[4], uv[2], uv1[2], attributes[kOcclusionAttribute + 1];
  std::vector<uint32_t> indices;
};

template <size_t kCount>
void read(const shd_mesh* mesh, shd_result (*reader)(const shd_mesh*, const shd_f32_out*), uint32_t vertices,
          std::vector<float> (&columns)[kCount]) {
  shd_f32_out out[kCount];
  for (size_t c = 0; c < kCount; ++c) {
    columns[c].resize(vertices);
    out[c] = {columns[c].data(), 0};
  }
  check(reader(mesh, out), "mesh");
}

Columns read_mesh(const shd_mesh* mesh, const shd_mesh_info& info) {
  Columns columns;
  read(mesh, shd_mesh_read_positions, info.vertex_count, columns.position);
  read(mesh, shd_mesh_read_normals, info.vertex_count, columns.normal);
  read(mesh, shd_mesh_read_tangents, info.vertex_count, columns.tangent);
  read(mesh, shd_mesh_read_uv, info.vertex_count, columns.uv);
  read(mesh, shd_mesh_read_uv1, info.vertex_count, columns.uv1);
  for (uint32_t i = 0; i < kOcclusionAttribute; ++i) {
    columns.attributes[i].resize(info.vertex_count);
    const shd_f32_out out = {columns.attributes[i].data(), 0};
    check(shd_mesh_read_attribute(mesh, i, &out), "mesh");
  }
  columns.indices.resize(size_t{3} * info.triangle_count);
  const shd_u32_out indices = {columns.indices.data(), 0};
  check(shd_mesh_read_indices(mesh, &indices), "mesh");
  return columns;
}

Mesh make_mesh(shd_context* context, const Options& options, const Columns& columns) {
  shd_mesh_desc desc = shd_mesh_desc_default();
  desc.vertex_count = static_cast<uint32_t>(columns.position[0].size());
  for (size_t c = 0; c < 3; ++c) {
    desc.position[c].data = columns.position[c].data();
    desc.normal[c].data = columns.normal[c].data();
  }
  const auto& side = columns.tangent[3];
  const bool has_tangents = std::any_of(side.begin(), side.end(), [](float value) { return value != 0.0f; });
  for (size_t c = 0; c < 4 && has_tangents; ++c) desc.tangent[c].data = columns.tangent[c].data();
  for (size_t c = 0; c < 2; ++c) {
    desc.uv[c].data = columns.uv[c].data();
    desc.uv1[c].data = columns.uv1[c].data();
  }
  shd_f32_in attributes[kOcclusionAttribute + 1];
  for (size_t i = 0; i <= kOcclusionAttribute; ++i) attributes[i] = {columns.attributes[i].data(), 0};
  desc.attributes = attributes;
  desc.attribute_count = kOcclusionAttribute + 1;
  desc.indices.data = columns.indices.data();
  desc.index_count = columns.indices.size();
  desc.flags = SHD_MESH_KEEP_NONFINITE;
  if (options.line_width > 0.0f) desc.flags |= SHD_MESH_ADJACENCY;
  Mesh mesh;
  check(shd_mesh_create(context, &desc, mesh.out()), "mesh");
  return mesh;
}

std::vector<shd_draw> occluders_of(const Model& model) {
  std::vector<shd_draw> draws;
  for (const Instance& instance : model.instances) {
    shd_draw draw = shd_draw_default();
    draw.mesh = model.geometries[instance.geometry].mesh;
    std::copy(instance.object_to_world.begin(), instance.object_to_world.end(), draw.object_to_world);
    draws.push_back(draw);
  }
  return draws;
}

}  // namespace

void add_occlusion(shd_context* context, const Options& options, const Bounds& bounds, Model& model) {
  const std::vector<shd_draw> draws = occluders_of(model);
  shd_occlusion_desc desc = shd_occlusion_desc_default();
  desc.ray_count = *options.occlusion;
  if (options.occlusion_radius > 0.0f) desc.radius = options.occlusion_radius * bounds.radius;
  desc.draws = draws.data();
  desc.draw_count = draws.size();
#ifdef SHD_RENDER_WITH_EMBREE
  Owned<shd_embree, shd_embree_release> tree;
  check(shd_embree_create(context, draws.data(), draws.size(), tree.out()), "occlusion");
  check(shd_embree_get_tracer(tree.get(), &desc.tracer), "occlusion");
#endif
  std::vector<Geometry> geometries;
  for (size_t i = 0; i < model.instances.size(); ++i) {
    const Geometry& from = model.geometries[model.instances[i].geometry];
    shd_mesh_info info = shd_mesh_info_default();
    check(shd_mesh_get_info(from.mesh, &info), "mesh");
    Columns columns = read_mesh(from.mesh, info);
    columns.attributes[kOcclusionAttribute].resize(info.vertex_count);
    const shd_f32_out out = {columns.attributes[kOcclusionAttribute].data(), 0};
    check(shd_occlusion_compute_vertices(context, &desc, &draws[i], &out), "occlusion");
    geometries.emplace_back();
    geometries.back().own = make_mesh(context, options, columns);
    geometries.back().mesh = geometries.back().own.get();
    geometries.back().position = from.position;
    geometries.back().indices = from.indices;
  }
  for (size_t i = 0; i < model.instances.size(); ++i) model.instances[i].geometry = i;
  model.geometries = std::move(geometries);
}
