// SPDX-License-Identifier: MIT Random volumes in small frames, valid and invalid: 3D textures of all formats, transfer
// functions, boxes, matrices and cameras. Alpha stays in [0, 1], pixels are finite, a refused frame does not change,
// and every target gives the same bits.
#include "mutator.h"
#include "texture_case.h"

namespace shd::fuzz {
namespace {

constexpr uint32_t kWidth = 13, kHeight = 7, kMaxFunction = 5;
constexpr size_t kPixels = kWidth * kHeight;

struct Case {
  TextureCase texture;
  shd_volume_desc desc = shd_volume_desc_default();
  std::vector<float> function[5];  // density, extinction, r, g, b
  float object_to_world[16] = {};
  shd_camera camera = shd_camera_default();
  bool is_lit = false;
  uint64_t budget = 0;
};

void choose_function(Source& source, Case& c) {
  const bool hostile = source.one_in(4);
  const uint32_t count = source.between(1, kMaxFunction);
  float density = source.real();
  for (uint32_t i = 0; i < count; ++i) {
    c.function[0].push_back(hostile ? source.hostile() : density);
    density += std::fabs(source.real());
    c.function[1].push_back(hostile ? source.hostile() : 20.0f * std::fabs(source.real()));
    for (int k = 2; k < 5; ++k) c.function[k].push_back(hostile ? source.hostile() : std::fabs(source.real()));
  }
  c.desc.point_count = source.one_in(64) ? source.below(2) * 257 : count;
}

void choose_case(Source& source, Case& c) {
  c.budget = choose_budget(source);
  choose_texture(source, c.texture, 5);
  const bool is_solid = !source.one_in(32) && c.texture.desc.layer_count <= 3;  // there are texels of no more slices
  c.texture.desc.kind = is_solid ? SHD_TEXTURE_KIND_3D : SHD_TEXTURE_KIND_2D;
  if (is_solid) {
    c.texture.desc.depth = static_cast<uint32_t>(c.texture.desc.layer_count);
    c.texture.desc.layer_count = 1;
  }
  if (!source.one_in(32)) c.texture.desc.tables &= SHD_TABLE_MIPMAP;
  choose_function(source, c);
  for (float& value : c.desc.bounds_min) value = source.one_in(8) ? source.hostile() : -1.0f;
  for (float& value : c.desc.bounds_max) value = source.one_in(8) ? source.hostile() : 1.0f;
  c.desc.step = source.one_in(8) ? source.hostile() : 0.125f;
  c.desc.jitter = source.real(0.0f, 1.0f);
  c.desc.seed = source.below(256);
  c.is_lit = source.one_in(2);
  const bool moved = source.one_in(2);
  for (int i = 0; i < 16; ++i) {
    c.object_to_world[i] = i % 5 == 0 ? 1.0f : 0.0f;
    if (moved && i % 4 != 3) c.object_to_world[i] = source.real();
  }
  for (float& value : c.camera.eye) value = 3.0f + 4.0f * source.real();
  c.camera.fov_y = source.real(0.1f, 2.0f);
  c.camera.near_plane = source.one_in(4) ? source.hostile() : 0.125f;
}

/// Results of one run.
struct Output {
  bool made = false;
  std::vector<float> planes;
};

struct Objects {
  shd_texture* texture = nullptr;
  shd_material* material = nullptr;
  shd_light* light = nullptr;
  shd_volume* volume = nullptr;
  shd_framebuffer* framebuffer = nullptr;
  ~Objects() {
    shd_framebuffer_release(framebuffer);
    shd_volume_release(volume);
    shd_light_release(light);
    shd_material_release(material);
    shd_texture_release(texture);
  }
};

bool make_objects(const Host& host, const Case& c, Objects& o) {
  shd_volume_desc desc = c.desc;
  shd_framebuffer_desc framebuffer = shd_framebuffer_desc_default();
  framebuffer.width = kWidth, framebuffer.height = kHeight;
  if (!host.ok(shd_texture_create(host.context, &c.texture.desc, &o.texture))) return false;
  if (c.is_lit && !host.ok(shd_material_create(host.context, nullptr, &o.material))) return false;
  desc.texture = o.texture;
  desc.material = o.material;
  desc.density = shd_f32_column(c.function[0].data(), 0);
  desc.extinction = shd_f32_column(c.function[1].data(), 0);
  for (int k = 0; k < 3; ++k) desc.color[k] = shd_f32_column(c.function[2 + k].data(), 0);
  return host.ok(shd_volume_create(host.context, &desc, &o.volume)) &&
         host.ok(shd_light_create(host.context, nullptr, &o.light)) &&
         host.ok(shd_framebuffer_create(host.context, &framebuffer, &o.framebuffer));
}

void read_planes(const Objects& o, std::vector<float>& planes) {
  planes.resize(4 * kPixels);
  for (int k = 0; k < 4; ++k) {
    const shd_f32_out out = shd_f32_out_column(&planes[static_cast<size_t>(k) * kPixels], 0);
    SHD_FUZZ_CHECK(shd_framebuffer_read_plane(o.framebuffer, static_cast<shd_plane>(SHD_PLANE_R + k), &out) == SHD_OK);
  }
}

void run(const Case& c, shd_simd simd, Output& output) {
  Host host(simd, c.budget);
  Objects o;
  if (!host.context || !make_objects(host, c, o)) return;
  shd_volume_draw draw = shd_volume_draw_default();
  shd_render_desc desc = shd_render_desc_default();
  std::vector<float> before;
  draw.volume = o.volume;
  std::memcpy(draw.object_to_world, c.object_to_world, sizeof c.object_to_world);
  desc.framebuffer = o.framebuffer;
  desc.camera = &c.camera;
  desc.lights = &o.light;
  desc.light_count = 1;
  desc.volumes = &draw;
  desc.volume_count = 1;
  read_planes(o, before);
  output.made = host.ok(shd_render(host.context, &desc));
  read_planes(o, output.planes);
  if (!output.made && host.memory.budget != 0) SHD_FUZZ_CHECK(same_values(before, output.planes));
  for (size_t i = 0; i < output.planes.size() && output.made; ++i) {
    SHD_FUZZ_CHECK(std::isfinite(output.planes[i]));
    if (i >= 3 * kPixels) SHD_FUZZ_CHECK(output.planes[i] >= 0.0f && output.planes[i] <= 1.0f);
  }
}

}  // namespace

void describe(Source& source) {
  Case c;
  choose_case(source, c);
}

}  // namespace shd::fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace shd::fuzz;
  compare_targets<Case, Output>(data, size, choose_case, run, [](const Output& best, const Output& baseline) {
    SHD_FUZZ_CHECK(best.made == baseline.made && same_values(best.planes, baseline.planes));
  });
  return 0;
}
