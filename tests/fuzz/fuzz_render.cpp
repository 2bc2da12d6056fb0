// SPDX-License-Identifier: MIT
// Random frames, valid and invalid: hostile vertices and matrices, odd sizes, every frequency, cull mode and flag. No
// call may crash or leak, statistics must count every triangle, and two SIMD targets give the same planes.
#include "source.h"

namespace shd::fuzz {
namespace {

constexpr size_t kMaxDraws = 3;
constexpr size_t kMaxLights = 3;

struct MeshData {
  std::vector<float> columns[8];  // x y z, nx ny nz, u v
  std::vector<uint32_t> indices;
  bool normals = false, uvs = false, indexed = false;
  uint32_t flags = 0, normal_weight = 0, vertex_count = 0;
};

struct DrawData {
  MeshData mesh;
  shd_material_desc material = shd_material_desc_default();
  shd_draw draw = shd_draw_default();
  std::vector<shd_slot> slots;
  uint32_t textured = 0;  // slots, by bit
};

/// The frame that one input describes, so that it can run on several contexts.
struct Case {
  shd_framebuffer_desc framebuffer = shd_framebuffer_desc_default();
  shd_render_desc render = shd_render_desc_default();
  DrawData draws[kMaxDraws];
  shd_light_desc lights[kMaxLights];
  size_t draw_count = 0, light_count = 0;
};

void fill_matrix(Source& source, float* matrix, bool affine) {
  const uint32_t kind = source.below(8);
  for (int i = 0; i < 16; ++i) {
    if (kind == 0) matrix[i] = source.hostile();
    if (kind == 1) matrix[i] = source.hostile_finite();
    if (kind == 2 || kind == 3) matrix[i] = source.unit() * 2.0f;
  }
  if (affine && kind != 0) {
    matrix[3] = matrix[7] = matrix[11] = 0.0f;
    matrix[15] = 1.0f;
  }
}

void fill_mesh(Source& source, MeshData& mesh) {
  mesh.normals = source.one_in(2);
  mesh.uvs = source.one_in(2);
  mesh.indexed = source.one_in(2);
  mesh.vertex_count = mesh.indexed ? source.below(40) : 3 * source.below(14);
  mesh.flags = source.one_in(64) ? source.word() : !source.one_in(16) + 2 * source.one_in(2) + 4 * !source.one_in(8);
  mesh.normal_weight = source.below(source.one_in(32) ? 100 : 3);
  const bool hostile = source.one_in(2);
  for (int k = 0; k < 8; ++k) {
    mesh.columns[k].resize(mesh.vertex_count);
    for (float& value : mesh.columns[k]) value = hostile && source.one_in(4) ? source.hostile() : source.unit();
  }
  const uint32_t count = mesh.vertex_count == 0 ? 0 : source.below(40) * 3 + source.one_in(64);
  if (!mesh.indexed) return;
  for (uint32_t i = 0; i < count; ++i) {
    mesh.indices.push_back(source.one_in(2048) ? source.word() : source.below(mesh.vertex_count));
  }
}

void fill_material(Source& source, shd_material_desc& material) {
  const auto pick = [&](uint32_t count) { return source.below(source.one_in(32) ? 100 : count); };
  const uint32_t model = source.one_in(4) ? pick(2) : 3 + pick(12);  // values above SHD_MODEL_MATCAP are debug views
  material.model = static_cast<shd_model>(model > SHD_MODEL_MATCAP && model < 15 ? 0 : model);
  if (model > SHD_MODEL_MATCAP && model < 15)
    material.debug_view = static_cast<shd_debug_view>(model - SHD_MODEL_MATCAP);
  material.flags = source.one_in(64) ? source.word() : source.below(4) + 16 * source.below(4);
  material.normal_encoding = static_cast<shd_normal_encoding>(pick(4));
  material.bump = static_cast<shd_bump>(pick(3));
  for (float* value : {&material.bump_scale, &material.normal_scale, &material.metallic, &material.roughness}) {
    *value = source.one_in(32) ? source.hostile() : std::fabs(source.unit());
  }
  material.parallax_depth = source.one_in(4) ? std::fabs(source.unit()) : 0.0f;
  material.parallax_steps = source.one_in(64) ? source.word() : 2 + source.below(10);
}

void fill_draw(Source& source, DrawData& data) {
  fill_mesh(source, data.mesh);
  fill_material(source, data.material);
  data.textured = source.one_in(2) ? source.word() & source.word() : 0;
  for (int slot = 0; slot <= SHD_SLOT_NORMAL_MIXED; ++slot) {
    if (data.textured >> slot & 1 || slot >= SHD_SLOT_HEIGHT || !source.one_in(8)) continue;
    data.slots.push_back(
        shd_slot_vertex(static_cast<shd_slot_target>(slot), source.below(source.one_in(32) ? 100 : 4)));
  }
  data.material.exponent = source.one_in(16) ? source.hostile() : static_cast<float>(source.below(200));
  for (float& value : data.material.diffuse) value = source.one_in(64) ? source.hostile() : std::fabs(source.unit());
  data.draw.frequency = static_cast<shd_frequency>(source.below(source.one_in(32) ? 100 : 3));
  data.draw.cull = static_cast<shd_cull>(source.below(source.one_in(32) ? 100 : 3));
  fill_matrix(source, data.draw.object_to_world, true);
  if (source.one_in(3)) {
    data.draw.fill = static_cast<shd_fill>(source.below(source.one_in(32) ? 100 : 4));
    data.draw.fill_width = source.one_in(16) ? source.hostile() : 64.0f * std::fabs(source.unit());
    data.draw.edges = source.below(source.one_in(32) ? 100 : 16);
    data.draw.crease_cosine = source.one_in(32) ? source.hostile() : source.unit();
  }
}

void fill_case(Source& source, Case& c) {
  c.framebuffer.width = 1 + source.below(90);
  c.framebuffer.height = 1 + source.below(90);
  c.framebuffer.aovs = source.below(8);
  c.draw_count = source.below(kMaxDraws + 1);
  c.light_count = source.below(kMaxLights + 1);
  for (size_t i = 0; i < c.draw_count; ++i) fill_draw(source, c.draws[i]);
  for (size_t i = 0; i < c.light_count; ++i) {
    c.lights[i] = shd_light_desc_default();
    c.lights[i].kind = static_cast<shd_light_kind>(source.below(4));
    if (source.one_in(3)) c.lights[i].range = source.one_in(8) ? source.hostile() : 4.0f * std::fabs(source.unit());
    c.lights[i].outer_angle = 0.01f + 1.5f * std::fabs(source.unit());
    c.lights[i].inner_angle = c.lights[i].outer_angle * std::fabs(source.unit());
    for (float& value : c.lights[i].up) value = source.unit();
    for (float& value : c.lights[i].position) value = source.hostile_finite();
    for (float& value : c.lights[i].direction) value = source.unit();
  }
  shd_camera camera = shd_camera_default();
  for (float& value : camera.eye) value = source.one_in(8) ? source.hostile() : 3.0f * source.unit();
  for (float& value : camera.target) value = source.one_in(8) ? source.hostile() : source.unit();
  shd_view view;
  if (shd_view_from_camera(&camera, &view) == SHD_OK) c.render.view = view;
  if (source.one_in(4)) fill_matrix(source, c.render.view.world_to_view, true);
  if (source.one_in(4)) fill_matrix(source, c.render.view.view_to_clip, false);
  for (float& value : c.render.clear_color) value = source.one_in(16) ? source.hostile() : source.unit();
  c.render.flags = source.below(source.one_in(32) ? 5 : 2) * SHD_RENDER_LOAD;
  c.render.visibility = static_cast<shd_visibility>(source.below(source.one_in(32) ? 5 : 3));
}

/// The objects of shd in one run.
struct Objects {
  shd_framebuffer* framebuffer = nullptr;
  shd_texture* texture = nullptr;
  shd_mesh* meshes[kMaxDraws] = {};
  shd_material* materials[kMaxDraws] = {};
  shd_light* lights[kMaxLights] = {};
};

bool make_mesh(shd_context* context, const MeshData& data, shd_mesh** out) {
  shd_f32_in attributes[4] = {};
  shd_mesh_desc desc = shd_mesh_desc_default();
  desc.vertex_count = data.vertex_count;
  desc.flags = data.flags;
  desc.normal_weight = static_cast<shd_normal_weight>(data.normal_weight);
  for (int k = 0; k < 3; ++k) {
    desc.position[k].data = data.columns[k].data();
    if (data.normals) desc.normal[k].data = data.columns[3 + k].data();
    if (data.uvs && k < 2) desc.uv[k].data = data.columns[6 + k].data();
    if (data.uvs) attributes[k + 1].data = data.columns[3 + k].data();
  }
  desc.attributes = attributes;
  desc.attribute_count = 4;
  if (data.indexed) {
    desc.indices.data = data.indices.data();
    desc.index_count = data.indices.size();
  }
  return shd_mesh_create(context, &desc, out) == SHD_OK;
}

bool make_objects(shd_context* context, const Case& c, Objects& o) {
  const uint8_t texels[16] = {255, 0, 0, 255, 0, 255, 0, 128, 0, 0, 255, 0, 255, 255, 255, 255};
  shd_texture_desc texture = shd_texture_desc_default();
  texture.format = SHD_FORMAT_RGBA8_SRGB;
  texture.width = texture.height = 2;
  texture.tables = SHD_TABLE_MIPMAP;
  texture.texels = texels;
  bool made = shd_texture_create(context, &texture, &o.texture) == SHD_OK &&
              shd_framebuffer_create(context, &c.framebuffer, &o.framebuffer) == SHD_OK;
  for (size_t i = 0; i < c.draw_count && made; ++i) {
    shd_material_desc material = c.draws[i].material;
    std::vector<shd_slot> slots = c.draws[i].slots;
    for (int slot = 0; slot <= SHD_SLOT_NORMAL_MIXED; ++slot) {
      if (!(c.draws[i].textured >> slot & 1)) continue;
      slots.push_back(shd_slot_texture(static_cast<shd_slot_target>(slot), o.texture, nullptr));
    }
    material.slots = slots.data();
    material.slot_count = static_cast<uint32_t>(slots.size());
    made = make_mesh(context, c.draws[i].mesh, &o.meshes[i]) &&
           shd_material_create(context, &material, &o.materials[i]) == SHD_OK;
  }
  for (size_t i = 0; i < c.light_count && made; ++i) {
    made = shd_light_create(context, &c.lights[i], &o.lights[i]) == SHD_OK;
  }
  return made;
}

void release(Objects& o) {
  shd_framebuffer_release(o.framebuffer);
  shd_texture_release(o.texture);
  for (shd_mesh* mesh : o.meshes) shd_mesh_release(mesh);
  for (shd_material* material : o.materials) shd_material_release(material);
  for (shd_light* light : o.lights) shd_light_release(light);
}

void read_planes(const Case& c, const Objects& o, std::vector<float>& planes) {
  const size_t pixels = size_t{c.framebuffer.width} * c.framebuffer.height;
  for (int plane = SHD_PLANE_R; plane <= SHD_PLANE_NZ; ++plane) {
    std::vector<float> values(pixels);
    shd_f32_out out = {values.data(), 0};
    if (shd_framebuffer_read_plane(o.framebuffer, static_cast<shd_plane>(plane), &out) != SHD_OK) continue;
    planes.insert(planes.end(), values.begin(), values.end());
  }
}

/// Runs the case on one target. Returns false if any part of it was refused.
bool run(const Case& c, shd_simd simd, std::vector<float>& planes) {
  Memory memory;
  shd_context* context = make_context(memory, simd);
  Objects o;
  bool made = make_objects(context, c, o);
  if (made) {
    shd_draw draws[kMaxDraws];
    shd_render_stats stats = shd_render_stats_default();
    shd_render_desc desc = c.render;
    for (size_t i = 0; i < c.draw_count; ++i) {
      draws[i] = c.draws[i].draw;
      draws[i].mesh = o.meshes[i];
      draws[i].material = o.materials[i];
    }
    desc.framebuffer = o.framebuffer;
    desc.draws = draws;
    desc.draw_count = c.draw_count;
    desc.lights = o.lights;
    desc.light_count = c.light_count;
    desc.stats = &stats;
    made = shd_render(context, &desc) == SHD_OK;
    SHD_FUZZ_CHECK(stats.nonfinite + stats.outside + stats.culled + stats.empty + stats.rasterised == stats.triangles);
    SHD_FUZZ_CHECK(stats.nonfinite_fragments <= stats.fragments);
    SHD_FUZZ_CHECK(stats.fragments <= uint64_t{c.framebuffer.width} * c.framebuffer.height);
    if (made) read_planes(c, o, planes);
  }
  if (!made) SHD_FUZZ_CHECK(shd_last_error()[0] != '\0');
  release(o);
  shd_context_release(context);
  SHD_FUZZ_CHECK(memory.live == 0);
  return made;
}

}  // namespace
}  // namespace shd::fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace shd::fuzz;
  Source source(data, size);
  Case c;
  fill_case(source, c);
  std::vector<float> best, baseline;
  const bool made = run(c, SHD_SIMD_BEST, best);
  SHD_FUZZ_CHECK(run(c, SHD_SIMD_BASELINE, baseline) == made);
  SHD_FUZZ_CHECK(same_values(best, baseline));
  return 0;
}
