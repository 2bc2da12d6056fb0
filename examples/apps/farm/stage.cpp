// SPDX-License-Identifier: MIT
#include "stage.h"

#include <algorithm>
#include <cmath>
#include <shd.hpp>

#include "scene_block.h"

namespace farm {

struct Stage {
  Options options;
  const char* block;
  shd::context context;
  shd::sampler sampler;
  std::vector<shd::texture> textures;
  std::vector<shd::mesh> meshes;
  std::vector<shd::material> materials;
  std::vector<shd_draw> draws;
  shd::light lights[2];
  shd::shadow shadow;
  shd::framebuffer framebuffer;
  uint32_t width = 0, height = 0;  // size of the framebuffer
};

void StageDeleter::operator()(Stage* stage) const noexcept {
  delete stage;
}

namespace {

const BlockHead& head_of(const char* block) {
  return *reinterpret_cast<const BlockHead*>(block);
}

template <class T>
const T* table(const char* block, uint64_t offset) {
  return reinterpret_cast<const T*>(block + offset);
}

void make_meshes(Stage* stage) {
  const char* block = stage->block;
  const BlockMesh* rows = table<BlockMesh>(block, head_of(block).meshes);
  const auto column = [&](uint64_t offset) { return shd_f32_column(table<float>(block, offset), 0); };
  for (uint32_t i = 0; i < head_of(block).mesh_count; ++i) {
    const BlockMesh& row = rows[i];
    shd::mesh_desc desc;
    desc.vertex_count = row.vertex_count;
    for (size_t c = 0; c < 3; ++c) desc.position[c] = column(row.position[c]), desc.normal[c] = column(row.normal[c]);
    for (size_t c = 0; c < 2; ++c) desc.uv[c] = column(row.uv[c]);
    for (size_t c = 0; c < 4 && row.tangent[0]; ++c) desc.tangent[c] = column(row.tangent[c]);
    desc.indices = shd_u32_column(table<uint32_t>(block, row.indices), 0);
    desc.index_count = row.index_count;
    stage->meshes.push_back(shd::mesh_create(stage->context, &desc));
  }
}

void make_textures(Stage* stage) {
  const char* block = stage->block;
  const BlockTexture* rows = table<BlockTexture>(block, head_of(block).textures);
  for (uint32_t i = 0; i < head_of(block).texture_count; ++i) {
    shd::texture_desc desc;
    desc.format = static_cast<shd_format>(rows[i].format);
    desc.width = rows[i].width, desc.height = rows[i].height;
    desc.texels = block + rows[i].texels;
    desc.flags = SHD_TEXTURE_BORROW;
    desc.tables = SHD_TABLE_MIPMAP;
    stage->textures.push_back(shd::texture_create(stage->context, &desc));
  }
}

void make_materials(Stage* stage) {
  const char* block = stage->block;
  const BlockMaterial* rows = table<BlockMaterial>(block, head_of(block).materials);
  for (uint32_t i = 0; i < head_of(block).material_count; ++i) {
    shd_slot slots[kSlots];
    std::copy_n(rows[i].slots, kSlots, slots);
    for (uint32_t s = 0; s < rows[i].slot_count; ++s) {
      if (rows[i].texture[s] == kNone) continue;
      slots[s].texture = stage->textures[rows[i].texture[s]];
      slots[s].sampler = stage->sampler;
    }
    shd_material_desc desc = rows[i].desc;
    desc.slots = slots, desc.slot_count = rows[i].slot_count;
    stage->materials.push_back(shd::material_create(stage->context, &desc));
  }
}

void make_draws(Stage* stage) {
  const char* block = stage->block;
  const BlockDraw* rows = table<BlockDraw>(block, head_of(block).draws);
  for (uint32_t i = 0; i < head_of(block).draw_count; ++i) {
    shd::draw draw;
    draw.mesh = stage->meshes[rows[i].mesh];
    draw.material = stage->materials[rows[i].material];
    std::copy_n(rows[i].object_to_world, 16, draw.object_to_world);
    stage->draws.push_back(draw);
  }
}

/// Light from everywhere, and a sun with shadows.
void make_lights(Stage* stage) {
  shd::light_desc ambient, sun;
  ambient.kind = SHD_LIGHT_KIND_AMBIENT;
  for (float& c : ambient.intensity) c = 0.2f;
  sun.kind = SHD_LIGHT_KIND_DIRECTIONAL;
  const float direction[3] = {0.8f, -1.1f, -0.3f}, intensity[3] = {1.6f, 1.5f, 1.4f};
  std::copy_n(direction, 3, sun.direction);
  std::copy_n(intensity, 3, sun.intensity);
  stage->lights[0] = shd::light_create(stage->context, &ambient);
  stage->lights[1] = shd::light_create(stage->context, &sun);
  shd::shadow_desc desc;
  desc.size = 2048;
  desc.filter = SHD_SHADOW_FILTER_PCF;
  stage->shadow = shd::shadow_create(stage->context, &desc);
  shd::shadow_render_desc render;
  render.light = stage->lights[1];
  render.draws = stage->draws.data(), render.draw_count = stage->draws.size();
  shd::shadow_render(stage->context, stage->shadow, &render);
}

/// The camera looks at the middle of the models; the frames are one turn.
shd_camera frame_camera(const Stage& stage, uint32_t frame) {
  const BlockHead& head = head_of(stage.block);
  shd::camera camera;
  float radius = 0.0f;
  for (size_t c = 0; c < 3; ++c) {
    const float half = 0.5f * (head.bounds_max[c] - head.bounds_min[c]);
    radius += half * half;
    camera.target[c] = head.bounds_min[c] + half;
  }
  radius = std::sqrt(radius);
  const float degree = 3.14159265f / 180.0f;
  const float turn = static_cast<float>(frame) / static_cast<float>(stage.options.frames);
  const float az = degree * (stage.options.azimuth + 360.0f * turn), el = degree * stage.options.elevation;
  const float distance = 2.1f * radius;
  camera.eye[0] = camera.target[0] + distance * std::cos(el) * std::sin(az);
  camera.eye[1] = camera.target[1] + distance * std::sin(el);
  camera.eye[2] = camera.target[2] + distance * std::cos(el) * std::cos(az);
  camera.near_plane = 0.05f * radius;
  camera.far_plane = 20.0f * radius;
  return camera;
}

void fit_framebuffer(Stage* stage, const Window& window) {
  if (stage->framebuffer && stage->width == window.width && stage->height == window.height) return;
  shd::framebuffer_desc desc;
  desc.width = window.width, desc.height = window.height;
  desc.sample_count = stage->options.samples;
  desc.color_format = SHD_FORMAT_RGBA16F;
  stage->framebuffer = shd::framebuffer_create(stage->context, &desc);
  stage->width = window.width, stage->height = window.height;
}

}  // namespace

uint64_t borrowed_bytes(const char* block) {
  const BlockTexture* rows = table<BlockTexture>(block, head_of(block).textures);
  uint64_t bytes = 0;
  for (uint32_t i = 0; i < head_of(block).texture_count; ++i) {
    bytes += uint64_t{texel_size(static_cast<shd_format>(rows[i].format))} * rows[i].width * rows[i].height;
  }
  return bytes;
}

StagePtr make_stage(const Options& options, const char* block) {
  StagePtr stage(new Stage);
  stage->options = options;
  stage->block = block;
  shd::context_desc context;
  context.worker_count = options.threads;
  stage->context = shd::context_create(&context);
  shd::sampler_desc sampler;
  sampler.filter = SHD_FILTER_ANISOTROPIC;
  stage->sampler = shd::sampler_create(stage->context, &sampler);
  make_meshes(stage.get());
  make_textures(stage.get());
  make_materials(stage.get());
  make_draws(stage.get());
  make_lights(stage.get());
  return stage;
}

Pixels render_window(Stage* stage, uint32_t frame, const Window& window) {
  fit_framebuffer(stage, window);
  const shd_camera camera = frame_camera(*stage, frame);
  const shd_light* lights[2] = {stage->lights[0], stage->lights[1]};
  const shd_shadow* shadows[2] = {nullptr, stage->shadow};
  shd::render_desc desc;
  desc.framebuffer = stage->framebuffer;
  desc.camera = &camera;
  desc.clear_color[0] = 0.55f, desc.clear_color[1] = 0.62f, desc.clear_color[2] = 0.7f, desc.clear_color[3] = 1.0f;
  desc.draws = stage->draws.data(), desc.draw_count = stage->draws.size();
  desc.lights = lights, desc.shadows = shadows, desc.light_count = 2;
  desc.picture_width = stage->options.width, desc.picture_height = stage->options.height;
  desc.supersampling = std::max(stage->options.supersampling, 1u);
  desc.crop_x = window.x, desc.crop_y = window.y;
  shd::render(stage->context, &desc);
  shd::image view;
  shd::check(shd_framebuffer_view_color(stage->framebuffer, &view));
  return {static_cast<const uint16_t*>(view.pixels), view.row_stride / sizeof(uint16_t)};
}

}  // namespace farm
