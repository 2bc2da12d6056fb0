// SPDX-License-Identifier: MIT
#include "occlusion.h"

#include <algorithm>

namespace viewer {
namespace {

constexpr float kRadius = 1.5f;  // [radii of the model]

/// All columns of a mesh, and one of occlusion.
struct Columns {
  std::vector<float> position[3], normal[3], tangent[4], uv[2], uv1[2], occlusion;
  std::vector<uint32_t> indices;
};

template <size_t kCount>
void read(void (*reader)(const shd_mesh*, const shd_f32_out*), const shd_mesh* mesh, uint32_t vertices,
          std::vector<float> (&columns)[kCount]) {
  shd_f32_out out[kCount];
  for (size_t c = 0; c < kCount; ++c) {
    columns[c].resize(vertices);
    out[c] = shd_f32_out_column(columns[c].data(), 0);
  }
  reader(mesh, out);
}

Columns read_mesh(const shd_mesh* mesh) {
  const shd_mesh_info info = shd::mesh_get_info(mesh);
  Columns columns;
  read(shd::mesh_read_positions, mesh, info.vertex_count, columns.position);
  read(shd::mesh_read_normals, mesh, info.vertex_count, columns.normal);
  read(shd::mesh_read_tangents, mesh, info.vertex_count, columns.tangent);
  read(shd::mesh_read_uv, mesh, info.vertex_count, columns.uv);
  read(shd::mesh_read_uv1, mesh, info.vertex_count, columns.uv1);
  columns.occlusion.resize(info.vertex_count, 1.0f);
  columns.indices.resize(size_t{3} * info.triangle_count);
  const shd_u32_out indices = shd::out(columns.indices);
  shd::mesh_read_indices(mesh, &indices);
  return columns;
}

shd::mesh make_mesh(shd_context* context, const Columns& columns) {
  shd::mesh_desc desc;
  desc.vertex_count = static_cast<uint32_t>(columns.occlusion.size());
  const std::vector<float>& side = columns.tangent[3];
  const bool has_tangents = std::any_of(side.begin(), side.end(), [](float value) { return value != 0.0f; });
  for (size_t c = 0; c < 4; ++c) {
    if (c < 3) desc.position[c] = shd::in(columns.position[c]), desc.normal[c] = shd::in(columns.normal[c]);
    if (has_tangents) desc.tangent[c] = shd::in(columns.tangent[c]);
    if (c < 2) desc.uv[c] = shd::in(columns.uv[c]), desc.uv1[c] = shd::in(columns.uv1[c]);
  }
  const shd_f32_in occlusion = shd::in(columns.occlusion);
  desc.attributes = &occlusion, desc.attribute_count = 1;
  desc.indices = shd::in(columns.indices), desc.index_count = columns.indices.size();
  desc.flags = SHD_MESH_KEEP_NONFINITE;
  return shd::mesh_create(context, &desc);
}

}  // namespace

void add_occlusion(shd_context* context, Assets& assets) {
  std::vector<shd_draw> draws;
  for (const Part& part : assets.parts) {
    draws.push_back(shd_draw_default());
    draws.back().mesh = part.mesh;
    std::copy(part.object_to_world.begin(), part.object_to_world.end(), draws.back().object_to_world);
    if (assets.surfaces[part.surface].is_floor) draws.pop_back();  // nothing lies below it
  }
  shd::occlusion_desc desc;
  desc.radius = kRadius * assets.bounds.radius;
  desc.ray_count = 48;
  desc.map_size = 512;
  desc.draws = draws.data(), desc.draw_count = draws.size();
  for (Part& part : assets.parts) {
    Columns columns = read_mesh(part.mesh);
    shd::draw draw;
    draw.mesh = part.mesh;
    std::copy(part.object_to_world.begin(), part.object_to_world.end(), draw.object_to_world);
    const shd_f32_out out = shd::out(columns.occlusion);
    shd::occlusion_compute_vertices(context, &desc, &draw, &out);
    assets.meshes.push_back(make_mesh(context, columns));
    part.mesh = assets.meshes.back();
  }
  for (SurfaceAsset& surface : assets.surfaces) {
    const auto is_occlusion = [](const shd_slot& slot) { return slot.target == SHD_SLOT_OCCLUSION; };
    if (std::any_of(surface.slots.begin(), surface.slots.end(), is_occlusion)) continue;  // the file has its own
    surface.slots.push_back(shd_slot_vertex(SHD_SLOT_OCCLUSION, 0));
    surface.wraps.emplace_back();
  }
}

}  // namespace viewer
