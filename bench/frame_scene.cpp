// SPDX-License-Identifier: MIT
#include "frame_scene.h"

#include <algorithm>

namespace shd::bench {
namespace {

/// A shear in clip space.
void move_vertices(const shd_vertices* in, shd_vertex_outputs* out, void*) {
  for (size_t i = 0; i < in->count; ++i) out->y[i] += 0.05f * out->px[i];
}

}  // namespace

const std::vector<Spheres>& sphere_frames() {
  static const std::vector<Spheres> all = {make_spheres("2k", 16, 9, 2), make_spheres("100k", 30, 27, 4),
                                           make_spheres("1M", 25, 21, 10)};
  return all;
}

const std::vector<uint8_t>& frame_texels() {
  static const std::vector<uint8_t> all = make_rgba8(kFrameTextureEdge);
  return all;
}

FrameScene::FrameScene(shd_simd simd, uint32_t samples, shd_format color, uint32_t workers)
    : context_(make_context(simd, workers)) {
  shd_texture_desc texture = shd_texture_desc_default();
  texture.format = SHD_FORMAT_RGBA8;
  texture.width = texture.height = kFrameTextureEdge;
  texture.texels = frame_texels().data();
  texture.tables = SHD_TABLE_MIPMAP;
  check(shd_texture_create(context_, &texture, &texture_));
  shd_framebuffer_desc framebuffer = shd_framebuffer_desc_default();
  framebuffer.width = framebuffer.height = kFrameEdge;
  framebuffer.sample_count = samples;
  framebuffer.color_format = color;
  check(shd_framebuffer_create(context_, &framebuffer, &framebuffer_));
  desc_.framebuffer = framebuffer_;
  desc_.stats = &stats_;
}

FrameScene::FrameScene(const Spheres& spheres, shd_simd simd, const Variant& variant, uint32_t workers)
    : FrameScene(simd, variant.samples, variant.color, workers) {
  make_mesh(spheres, variant.feature);
  shd_material_desc material = shd_material_desc_default();
  material.blend = variant.blend;
  material.opacity = 0.5f;
  material.model = SHD_MODEL_BLINN_PHONG;
  for (int c = 0; c < 3; ++c) {
    material.ambient[c] = 0.0f;
    material.diffuse[c] = kDiffuse;
    material.specular[c] = kSpecular;
  }
  material.exponent = kExponent;
  if (variant.feature == Feature::kVertexProgram) material.program.vertex = move_vertices;
  make_material(material, variant.feature);
  make_lights();
  for (size_t i = 0; i < spheres.sphere_count(); ++i) {
    shd_draw draw = shd_draw_default();
    draw.mesh = mesh_;
    draw.material = variant.shaded ? material_ : nullptr;
    draw.cull = SHD_CULL_BACK;
    draw.fill = variant.feature == Feature::kLines ? SHD_FILL_WIREFRAME : SHD_FILL_SOLID;
    std::copy_n(&spheres.object_to_world[16 * i], 16, draw.object_to_world);
    draws_.push_back(draw);
  }
  desc_.view = spheres.view;
  set_draws();
  if (variant.feature == Feature::kShadows) make_shadows();
}

FrameScene::FrameScene(const Surface& surface, shd_simd simd, const SurfaceFilter& filter, shd_format color,
                       uint32_t workers)
    : FrameScene(simd, 1, color, workers) {
  make_mesh(surface);
  shd_sampler_desc sampler = shd_sampler_desc_default();
  sampler.filter = filter.filter;
  sampler.precision = filter.precision;
  sampler.max_anisotropy = 16.0f;
  sampler.profile =
      SHD_PROFILE_EXACT;  // the levels of llvmpipe: the quad lies on one level, where the default reads two
  check(shd_sampler_create(context_, &sampler, &sampler_));
  shd_material_desc material = shd_material_desc_default();
  material.model = SHD_MODEL_UNLIT;
  std::fill_n(material.diffuse, 3, 1.0f);
  make_material(material);
  shd_draw draw = shd_draw_default();
  draw.mesh = mesh_;
  draw.material = material_;
  draws_.push_back(draw);
  // Object space is (x, y, w) of clip space.
  std::fill_n(desc_.view.view_to_clip, 16, 0.0f);
  desc_.view.view_to_clip[0] = desc_.view.view_to_clip[5] = desc_.view.view_to_clip[11] = 1.0f;
  set_draws();
}

FrameScene::~FrameScene() {
  shd_framebuffer_release(framebuffer_);
  for (shd_shadow* shadow : shadows_) shd_shadow_release(shadow);
  for (shd_light* light : lights_) shd_light_release(light);
  shd_material_release(material_);
  shd_mesh_release(mesh_);
  shd_sampler_release(sampler_);
  shd_texture_release(texture_);
  shd_context_release(context_);
}

std::vector<float> FrameScene::image() const {
  std::vector<float> rgba(kLookupCount * 4);
  shd_image out = shd_image_default();
  out.format = SHD_FORMAT_RGBA32F;
  out.width = out.height = kFrameEdge;
  out.pixels = rgba.data();
  check(shd_framebuffer_read_color(framebuffer_, &out));
  return rgba;
}

void FrameScene::make_mesh(const Spheres& spheres, Feature feature) {
  shd_mesh_desc desc = shd_mesh_desc_default();
  if (feature == Feature::kNormalMap) desc.flags = SHD_MESH_TANGENTS;
  desc.vertex_count = static_cast<uint32_t>(spheres.position[0].size());
  for (int k = 0; k < 3; ++k) desc.position[k].data = desc.normal[k].data = spheres.position[k].data();
  for (int k = 0; k < 2; ++k) desc.uv[k].data = spheres.uv[k].data();
  desc.indices.data = spheres.indices.data();
  desc.index_count = spheres.indices.size();
  check(shd_mesh_create(context_, &desc, &mesh_));
}

void FrameScene::make_mesh(const Surface& surface) {
  constexpr uint32_t kIndices[6] = {0, 2, 1, 1, 2, 3};
  shd_mesh_desc desc = shd_mesh_desc_default();
  desc.vertex_count = 4;
  constexpr int kObject[3] = {0, 1, 3};
  for (int k = 0; k < 3; ++k) {
    desc.position[k].data = &surface.clip[0][kObject[k]];
    desc.position[k].stride = sizeof surface.clip[0];
  }
  for (int k = 0; k < 2; ++k) {
    desc.uv[k].data = &surface.uv[0][k];
    desc.uv[k].stride = sizeof surface.uv[0];
  }
  desc.indices.data = kIndices;
  desc.index_count = 6;
  check(shd_mesh_create(context_, &desc, &mesh_));
}

void FrameScene::make_material(const shd_material_desc& desc, Feature feature) {
  shd_material_desc textured = desc;
  const shd_slot slots[2] = {shd_slot_texture(SHD_SLOT_DIFFUSE, texture_, sampler_),
                             shd_slot_texture(SHD_SLOT_NORMAL, texture_, sampler_)};
  textured.slots = slots;
  textured.slot_count = feature == Feature::kNormalMap ? 2 : 1;
  check(shd_material_create(context_, &textured, &material_));
}

void FrameScene::make_lights() {
  for (int i = 0; i < 2; ++i) {
    shd_light_desc desc = shd_light_desc_default();
    std::copy_n(kLights[i].position, 3, desc.position);
    std::copy_n(kLights[i].intensity, 3, desc.intensity);
    check(shd_light_create(context_, &desc, &lights_[i]));
  }
  desc_.lights = lights_;
  desc_.light_count = 2;
}

void FrameScene::make_shadows() {
  for (int i = 0; i < 2; ++i) {
    shd_shadow_desc desc = shd_shadow_desc_default();
    desc.filter = SHD_SHADOW_FILTER_PCF;
    check(shd_shadow_create(context_, &desc, &shadows_[i]));
    shd_shadow_render_desc render = shd_shadow_render_desc_default();
    render.light = lights_[i];
    render.draws = desc_.draws;
    render.draw_count = desc_.draw_count;
    check(shd_shadow_render(context_, shadows_[i], &render));
  }
  desc_.shadows = shadows_;
}

void FrameScene::set_draws() {
  desc_.draws = draws_.data();
  desc_.draw_count = draws_.size();
}

}  // namespace shd::bench
