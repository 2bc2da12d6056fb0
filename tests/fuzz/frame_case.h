// SPDX-License-Identifier: MIT
/// @file
/// Small frames, valid and invalid: materials of all models and blends, lights, draws, windows and flags.
#pragma once

#include "mesh_case.h"
#include "texture_case.h"

namespace shd::fuzz {

constexpr size_t kMaxDraws = 2;
constexpr size_t kMaxLights = 2;
constexpr size_t kMaxSlots = 3;

struct DrawCase {
  MeshCase mesh;
  shd_material_desc material = shd_material_desc_default();
  shd_slot slots[kMaxSlots];
  shd_draw draw = shd_draw_default();
  float instances[2][16] = {};
  bool has_material = true;
};

struct FrameCase {
  shd_framebuffer_desc framebuffer = shd_framebuffer_desc_default();
  shd_render_desc render = shd_render_desc_default();
  shd_region viewport = {}, scissor = {};
  DrawCase draws[kMaxDraws];
  shd_light_desc lights[kMaxLights];
  TextureCase texture;
  shd_sampler_desc sampler = shd_sampler_desc_default();
  bool shadow = false;
  uint64_t budget = 0;
};

inline void write_program(const shd_fragments* in, shd_radiance* out, void*) {
  for (size_t i = 0; i < in->count; ++i) {
    out->r[i] = in->u[i];
    out->g[i] = in->nx[i];
    out->b[i] = in->px[i];
    if (out->discard) out->discard[i] = in->u[i] > 0.5f;
  }
}

inline void move_vertices(const shd_vertices* in, shd_vertex_outputs* out, void*) {
  for (size_t i = 0; i < in->count; ++i) {
    out->x[i] += 0.125f * in->py[i];
    for (uint32_t k = 0; k < out->varying_count; ++k) out->varying[k][i] = in->px[i];
  }
}

inline void choose_coordinates(Source& source, shd_slot& slot) {
  if (slot.source != SHD_SLOT_SOURCE_TEXTURE && !source.one_in(16)) return;
  slot.coordinates = source.constant<shd_slot_coordinates>(3);
  slot.place_space = source.constant<shd_place_space>(2);
  slot.triplanar_sharpness = source.one_in(16) ? source.below(256) : 1 + source.below(8);
  choose_affine(source, slot.place_transform);
  if (slot.coordinates != SHD_SLOT_COORDINATES_PROJECTED) return;
  for (size_t i = 3; i < 16; i += 4) slot.place_transform[i] = source.real();
}

inline void choose_slots(Source& source, DrawCase& c) {
  c.material.slot_count = source.one_in(2) ? 0 : source.below(kMaxSlots + 1);
  for (uint32_t i = 0; i < c.material.slot_count; ++i) {
    // At most one slot for each coefficient, except for one in 32.
    const uint32_t target = source.one_in(32) ? source.below(16) : source.below(4) * 3 + i;
    c.slots[i] = shd_slot_default();
    c.slots[i].target = static_cast<shd_slot_target>(target);
    c.slots[i].source = source.one_in(4) ? source.constant<shd_slot_source>(3) : SHD_SLOT_SOURCE_TEXTURE;
    c.slots[i].attribute = source.below(source.one_in(32) ? 16 : 3);
    c.slots[i].channel = source.below(source.one_in(32) ? 8 : 4);
    c.slots[i].uv_set = source.below(source.one_in(32) ? 4 : 2);
    if (source.one_in(4)) choose_coordinates(source, c.slots[i]);
    if (!source.one_in(4)) continue;
    for (float& value : c.slots[i].uv_transform) value = 2.0f * source.real();
  }
}

inline void choose_material(Source& source, DrawCase& c) {
  shd_material_desc& m = c.material;
  m.model = source.constant<shd_model>(11);
  m.debug_view = source.one_in(8) ? source.constant<shd_debug_view>(5) : SHD_DEBUG_VIEW_NONE;
  m.flags = source.one_in(2) ? source.flags(63) : 0;
  m.blend = source.constant<shd_blend>(7);
  for (float& value : m.diffuse) value = source.real(0, 1);
  m.opacity = source.real(0, 1);
  m.alpha_cutoff = source.one_in(4) ? source.real(0, 1) : 0.0f;
  m.exponent = source.one_in(4) ? source.real(0, 200) : 16.0f;
  m.metallic = source.real(0, 1);
  m.roughness = source.real(0, 1);
  m.ior = source.one_in(8) ? source.real(1, 4) : 1.5f;
  for (float& value : m.ambient) value = source.one_in(4) ? source.real(0, 1) : value;
  m.normal_encoding = source.constant<shd_normal_encoding>(4);
  m.bump = source.constant<shd_bump>(3);
  m.bump_scale = source.one_in(4) ? source.real(-4, 4) : 1.0f;
  m.parallax_depth = source.one_in(8) ? source.real(0, 1) : 0.0f;
  m.parallax_steps = source.one_in(16) ? source.below(300) : 2 + source.below(4);
  m.toon_steps = source.one_in(16) ? source.below(300) : 1 + source.below(4);
  if (m.model == SHD_MODEL_PROGRAM) m.program.fragment = write_program;
  if (m.model != SHD_MODEL_PROGRAM && !source.one_in(32)) m.flags &= ~uint32_t{SHD_MATERIAL_DISCARDS};
  if (source.one_in(8)) {
    m.program.vertex = move_vertices;
    m.varying_count = source.below(source.one_in(32) ? 20 : 3);
  }
  choose_slots(source, c);
}

inline void choose_draw(Source& source, DrawCase& c) {
  shd_draw& draw = c.draw;
  draw.frequency = source.constant<shd_frequency>(3);
  draw.flags = source.one_in(4) ? source.flags(3) : 0;
  draw.cull = source.constant<shd_cull>(3);
  draw.compare = source.one_in(4) ? source.constant<shd_compare>(8) : SHD_COMPARE_LESS;
  draw.depth_bias = source.one_in(8) ? source.real() : 0.0f;
  draw.depth_bias_slope = source.one_in(8) ? source.hostile_finite() : 0.0f;
  draw.fill = source.one_in(4) ? source.constant<shd_fill>(4) : SHD_FILL_SOLID;
  draw.fill_width = source.one_in(2) ? source.real(0.0625f, 8) : 1.0f;
  draw.edges = source.one_in(4) ? source.flags(SHD_EDGE_ALL) : uint32_t{SHD_EDGE_ALL};
  draw.crease_cosine = source.real();
  choose_affine(source, draw.object_to_world);
  draw.instance_count = source.one_in(16) ? source.below(3) : 0;
  for (size_t i = 0; i < draw.instance_count; ++i) choose_affine(source, c.instances[i]);
  c.has_material = !source.one_in(8);
  choose_material(source, c);
  choose_mesh(source, c.mesh, 6, 9);
}

inline void choose_frame_light(Source& source, shd_light_desc& light) {
  light = shd_light_desc_default();
  light.kind = source.constant<shd_light_kind>(4);
  if (source.one_in(4)) light.range = source.real(0, 4);
  light.outer_angle = source.real(0.01f, 1.57f);
  for (float& value : light.position) value = source.one_in(16) ? source.hostile_finite() : 2.0f * source.real();
  for (float& value : light.direction) value = source.real();
}

inline void choose_region(Source& source, shd_region& region) {
  region.x = source.below(8);
  region.y = source.below(8);
  region.width = source.one_in(16) ? source.below(40) : 1 + source.below(8);
  region.height = source.one_in(16) ? source.below(40) : 1 + source.below(8);
}

/// Size and position of the framebuffer in its picture, samples and planes.
inline void choose_window(Source& source, FrameCase& c) {
  constexpr uint32_t kSamples[] = {1, 1, 1, 1, 2, 4, 8, 16};
  c.framebuffer.width = 1 + source.below(12);
  c.framebuffer.height = 1 + source.below(12);
  c.framebuffer.sample_count = kSamples[source.below(8)];
  c.framebuffer.aovs = source.one_in(2) ? source.flags(4095) : 0;
  if (source.one_in(8)) {
    c.render.picture_width = c.framebuffer.width + source.below(8);
    c.render.picture_height = c.framebuffer.height + source.below(8);
    c.render.crop_x = source.below(8);
    c.render.crop_y = source.below(8);
  }
  choose_region(source, c.viewport);
  choose_region(source, c.scissor);
  if (source.one_in(8)) c.render.viewport = &c.viewport;
  if (source.one_in(8)) c.render.scissor = &c.scissor;
  c.render.supersampling = source.one_in(32) ? source.below(4) : 1;
  c.render.pass_triangles = source.one_in(16) ? source.below(2) * 1024 : 1u << 21;
}

/// A frame whose pointers lead into `c`, which must not move.
inline void choose_frame(Source& source, FrameCase& c) {
  c.budget = choose_budget(source);
  choose_window(source, c);
  c.render.draw_count = source.below(kMaxDraws + 1);
  c.render.light_count = source.below(kMaxLights + 1);
  c.render.flags = source.one_in(2) ? source.flags(3) : 0;
  c.render.visibility = source.constant<shd_visibility>(3);
  for (float& value : c.render.clear_color) value = source.real();
  c.render.clear_depth = source.one_in(8) ? source.real(0, 1) : 1.0f;
  shd_camera camera = shd_camera_default();
  for (float& value : camera.eye) value = source.one_in(16) ? source.hostile() : 3.0f * source.real();
  for (float& value : camera.target) value = source.one_in(16) ? source.hostile() : source.real();
  shd_view view;
  if (shd_view_from_camera(&camera, &view) == SHD_OK) c.render.view = view;
  if (source.one_in(4)) choose_affine(source, c.render.view.world_to_view);
  if (source.one_in(4)) choose_affine(source, c.render.view.view_to_clip);
  c.shadow = source.one_in(16);
  for (size_t i = 0; i < c.render.light_count; ++i) choose_frame_light(source, c.lights[i]);
  for (size_t i = 0; i < c.render.draw_count; ++i) choose_draw(source, c.draws[i]);
  choose_texture(source, c.texture, 4);
  choose_sampler(source, c.sampler);
  if (source.one_in(4)) {
    constexpr shd_format kColors[] = {SHD_FORMAT_RGBA8, SHD_FORMAT_RGBA8_SRGB, SHD_FORMAT_RGBA16F, SHD_FORMAT_RGBA16F};
    c.framebuffer.color_format = source.one_in(32) ? source.constant<shd_format>(22) : kColors[source.below(4)];
  }
}

}  // namespace shd::fuzz
