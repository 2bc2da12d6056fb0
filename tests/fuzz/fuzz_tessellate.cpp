// SPDX-License-Identifier: MIT
// Tessellation and displacement of random meshes and shapes, with tangents. Counts agree, the vertices of the mesh keep
// their places, finite positions stay finite, and nothing but the columns is written.
#include "mesh_case.h"
#include "mutator.h"
#include "texture_case.h"

namespace shd::fuzz {
namespace {

struct Case {
  bool use_shape = false;
  shd_shape_desc shape = shd_shape_desc_default();
  MeshCase mesh;
  shd_tessellation_desc desc = shd_tessellation_desc_default();
  shd_view view = {};
  float object_to_world[16] = {};
  bool use_view = false, use_matrix = false, use_texture = false, use_sampler = false;
  TextureCase texture;
  shd_sampler_desc sampler = shd_sampler_desc_default();
  uint64_t budget = 0;
};

void choose_shape(Source& source, shd_shape_desc& shape) {
  shape.kind = source.constant<shd_shape>(5);
  shape.radius = source.one_in(8) ? source.hostile() : 1.0f + source.real(0, 1);
  shape.tube_radius = source.one_in(8) ? source.hostile() : source.real(0, 1);
  for (float& size : shape.size) size = source.one_in(8) ? source.hostile() : source.real(0, 4);
  for (uint32_t& parts : shape.segments) parts = source.one_in(64) ? 4097 : 1 + source.below(4);
  if (shape.kind == SHD_SHAPE_TEAPOT) shape.segments[0] = 2;
}

void choose_matrix(Source& source, float* matrix) {
  for (int i = 0; i < 16; ++i) matrix[i] = i % 5 == 0 ? 1.0f : 0.0f;
  const uint32_t kind = source.below(8);
  for (int i = 0; i < 16 && kind < 4; ++i) matrix[i] = kind == 0 ? source.hostile() : source.real();
  if (kind != 0) matrix[3] = matrix[7] = matrix[11] = 0.0f, matrix[15] = 1.0f;
}

void choose_case(Source& source, Case& c) {
  c.budget = choose_budget(source);
  shd_tessellation_desc& desc = c.desc;
  desc.mode = source.constant<shd_tessellation_mode>(2);
  desc.segments = source.one_in(64) ? source.word() : 1 + source.below(4);
  desc.max_segments = source.one_in(64) ? source.word() : 1 + source.below(5);
  desc.edge_length = source.one_in(8) ? source.hostile() : source.real(0.05f, 2.0f);
  desc.picture_width = source.one_in(64) ? source.word() : 1 + source.below(64);
  desc.picture_height = source.one_in(64) ? source.word() : 1 + source.below(64);
  desc.max_triangles = 80;
  desc.lod = source.real(-2, 4);
  desc.amplitude = source.one_in(8) ? source.hostile() : source.real();
  desc.offset = source.one_in(8) ? source.hostile() : source.real();
  desc.normals = source.constant<shd_displaced_normals>(3);
  c.use_view = source.one_in(4);
  c.use_matrix = source.one_in(4);
  choose_matrix(source, c.view.world_to_view);
  choose_matrix(source, c.view.view_to_clip);
  for (float& value : c.view.eye) value = source.real();
  choose_matrix(source, c.object_to_world);
  c.use_texture = source.one_in(2);
  c.use_sampler = source.one_in(2);
  c.use_shape = source.one_in(8);
  if (c.use_shape) choose_shape(source, c.shape);
  choose_mesh(source, c.mesh, 7, 12);
  if (!c.use_texture) return;
  choose_texture(source, c.texture, 3);
  choose_sampler(source, c.sampler);
}

/// The shape in columns of exactly its size, and in longer ones.
void check_shape(const Host& host, const shd_shape_desc& desc) {
  size_t vertices = 0, corners = 0;
  if (!host.ok(shd_shape_count(&desc, &vertices, &corners))) {
    SHD_FUZZ_CHECK(vertices == 0 && corners == 0);
    return;
  }
  if (vertices > 2048) return;
  std::vector<Column<float>> floats(8, Column<float>(vertices + 1, 1, kCanary));
  Column<uint32_t> indices(corners + 1, 1, kCanaryWord);
  shd_shape_columns columns = shd_shape_columns_default();
  columns.vertex_count = vertices + 1;
  columns.index_count = corners + 1;
  for (size_t k = 0; k < 3; ++k)
    columns.position[k] = to_column(floats[k]), columns.normal[k] = to_column(floats[3 + k]);
  for (size_t k = 0; k < 2; ++k) columns.uv[k] = to_column(floats[6 + k]);
  columns.indices = to_column(indices);
  SHD_FUZZ_CHECK(shd_shape_fill(&desc, &columns) == SHD_OK);
  indices.check_canaries(corners);
  for (const Column<float>& column : floats) {
    column.check_canaries(vertices);
    for (size_t i = 0; i < vertices; ++i) SHD_FUZZ_CHECK(std::isfinite(column[i]));
  }
  for (size_t i = 0; i < vertices; ++i) check_unit(floats[3][i], floats[4][i], floats[5][i]);
  for (size_t i = 0; i < corners; ++i) SHD_FUZZ_CHECK(indices[i] < vertices);
}

struct Objects {
  shd_mesh *coarse = nullptr, *fine = nullptr;
  shd_texture* texture = nullptr;
  shd_sampler* sampler = nullptr;
  ~Objects() {
    shd_mesh_release(coarse);
    shd_mesh_release(fine);
    shd_texture_release(texture);
    shd_sampler_release(sampler);
  }
};

bool make(const Host& host, const Case& c, Objects& o) {
  if (c.use_shape) check_shape(host, c.shape);
  if (c.use_shape && c.shape.kind == SHD_SHAPE_TEAPOT) return false;  // more than max_triangles
  return host.ok(c.use_shape ? shd_mesh_create_shape(host.context, &c.shape, c.mesh.desc.flags, &o.coarse)
                             : shd_mesh_create(host.context, &c.mesh.desc, &o.coarse)) &&
         (!c.use_texture || host.ok(shd_texture_create(host.context, &c.texture.desc, &o.texture))) &&
         (!c.use_texture || !c.use_sampler || host.ok(shd_sampler_create(host.context, &c.sampler, &o.sampler)));
}

void check_fine(const Case& c, const MeshData& coarse, const MeshData& fine) {
  const uint64_t triangles = coarse.info.triangle_count;
  SHD_FUZZ_CHECK(fine.info.triangle_count <= c.desc.max_triangles);
  SHD_FUZZ_CHECK(fine.info.vertex_count >= coarse.info.vertex_count);
  SHD_FUZZ_CHECK(fine.info.triangle_count >= triangles);
  if (c.desc.mode == SHD_TESSELLATION_MODE_UNIFORM) {
    SHD_FUZZ_CHECK(fine.info.triangle_count == triangles * c.desc.segments * c.desc.segments);
  }
  const bool displaced = c.use_texture && c.desc.amplitude != 0.0f;
  for (size_t i = 0; i < coarse.info.vertex_count; ++i) {
    for (int k = 0; k < 3; ++k) {
      const float before = coarse.positions[k][i], after = fine.positions[k][i];
      if (!displaced) SHD_FUZZ_CHECK(same_value(before + 0.0f, after));
      if (!displaced) SHD_FUZZ_CHECK(same_value(coarse.normals[k][i] + 0.0f, fine.normals[k][i]));
      if (std::isfinite(before)) SHD_FUZZ_CHECK(std::isfinite(after) || coarse.info.nonfinite_count > 0);
    }
  }
  if (coarse.info.nonfinite_count == 0) SHD_FUZZ_CHECK(fine.info.nonfinite_count == 0);
}

void run(const Case& c, shd_simd simd, MeshData& fine) {
  Host host(simd, c.budget);
  if (!host.context) return;
  Objects o;
  if (!make(host, c, o)) return;
  MeshData coarse;
  read_mesh(o.coarse, coarse);
  shd_tessellation_desc desc = c.desc;
  if (c.use_view) desc.view = c.view;
  if (c.use_matrix) std::copy_n(c.object_to_world, 16, desc.object_to_world);
  desc.displacement = o.texture;
  desc.sampler = o.sampler;
  if (!host.ok(shd_mesh_tessellate(host.context, o.coarse, &desc, &o.fine))) {
    SHD_FUZZ_CHECK(!o.fine);
    return;
  }
  read_mesh(o.fine, fine);
  check_fine(c, coarse, fine);
}

}  // namespace

void describe(Source& source) {
  Case c;
  choose_case(source, c);
}

}  // namespace shd::fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace shd::fuzz;
  compare_targets<Case, MeshData>(data, size, choose_case, run, [](const MeshData& best, const MeshData& baseline) {
    SHD_FUZZ_CHECK(best.indices == baseline.indices);
    for (int k = 0; k < 3; ++k) SHD_FUZZ_CHECK(same_values(best.positions[k], baseline.positions[k]));
    for (int k = 0; k < 3; ++k) SHD_FUZZ_CHECK(same_values(best.normals[k], baseline.normals[k]));
    for (int k = 0; k < 4; ++k) SHD_FUZZ_CHECK(same_values(best.tangents[k], baseline.tangents[k]));
  });
  return 0;
}
