// SPDX-License-Identifier: MIT
// Random frames, valid and invalid: hostile vertices and matrices, every model, blend, frequency and flag, windows and
// samples. No call may crash or leak, statistics count every triangle, a refused frame and pixels outside the scissor
// do not change, and two SIMD targets give the same planes.
#include "frame_case.h"
#include "mutator.h"

namespace shd::fuzz {
namespace {

/// The objects of shd in one run.
struct Objects {
  shd_framebuffer* framebuffer = nullptr;
  shd_texture* texture = nullptr;
  shd_sampler* sampler = nullptr;
  shd_shadow* shadow = nullptr;
  shd_mesh* meshes[kMaxDraws] = {};
  shd_material* materials[kMaxDraws] = {};
  shd_light* lights[kMaxLights] = {};
  ~Objects() {
    shd_framebuffer_release(framebuffer);
    shd_texture_release(texture);
    shd_sampler_release(sampler);
    shd_shadow_release(shadow);
    for (shd_mesh* mesh : meshes) shd_mesh_release(mesh);
    for (shd_material* material : materials) shd_material_release(material);
    for (shd_light* light : lights) shd_light_release(light);
  }
};

bool make_draw(const Host& host, const DrawCase& c, size_t i, Objects& o) {
  shd_material_desc desc = c.material;
  shd_slot slots[kMaxSlots];
  for (uint32_t k = 0; k < desc.slot_count; ++k) {
    slots[k] = c.slots[k];
    if (slots[k].source != SHD_SLOT_SOURCE_TEXTURE) continue;
    slots[k].texture = o.texture;
    slots[k].sampler = o.sampler;
  }
  desc.slots = slots;
  return host.ok(shd_mesh_create(host.context, &c.mesh.desc, &o.meshes[i])) &&
         (!c.has_material || host.ok(shd_material_create(host.context, &desc, &o.materials[i])));
}

bool make_objects(const Host& host, const FrameCase& c, Objects& o) {
  bool made = host.ok(shd_framebuffer_create(host.context, &c.framebuffer, &o.framebuffer));
  bool textured = false;
  for (size_t i = 0; i < c.render.draw_count; ++i) textured = textured || c.draws[i].material.slot_count > 0;
  if (made && textured) {
    made = host.ok(shd_texture_create(host.context, &c.texture.desc, &o.texture)) &&
           host.ok(shd_sampler_create(host.context, &c.sampler, &o.sampler));
  }
  for (size_t i = 0; i < c.render.light_count && made; ++i) {
    made = host.ok(shd_light_create(host.context, &c.lights[i], &o.lights[i]));
  }
  for (size_t i = 0; i < c.render.draw_count && made; ++i) made = make_draw(host, c.draws[i], i, o);
  return made;
}

/// Colour, depth, and the other planes of floats that the framebuffer has.
void read_planes(const FrameCase& c, const Objects& o, std::vector<float>& planes) {
  const size_t pixels = size_t{c.framebuffer.width} * c.framebuffer.height;
  for (int plane = SHD_PLANE_R; plane <= SHD_PLANE_TARGET3_A; ++plane) {
    shd_plane_view view = shd_plane_view_default();
    if (plane < SHD_PLANE_DEPTH && c.framebuffer.color_format != SHD_FORMAT_RGBA32F) {
      const size_t first = planes.size();
      planes.resize(first + pixels);
      const shd_f32_out out = shd_f32_out_column(planes.data() + first, 0);
      SHD_FUZZ_CHECK(shd_framebuffer_read_plane(o.framebuffer, static_cast<shd_plane>(plane), &out) == SHD_OK);
      continue;
    }
    if (shd_framebuffer_view_plane(o.framebuffer, static_cast<shd_plane>(plane), &view) != SHD_OK) continue;
    for (size_t i = 0; i < pixels; ++i) {
      const size_t at = i / c.framebuffer.width * (view.row_stride / 4) + i % c.framebuffer.width;
      planes.push_back(view.f32 ? view.f32[at] : static_cast<float>(view.u32[at]));
    }
  }
}

bool inside(const shd_region& region, uint32_t x, uint32_t y) {
  return x - region.x < region.width && y - region.y < region.height && x >= region.x && y >= region.y;
}

void check_scissor(const FrameCase& c, const std::vector<float>& before, const std::vector<float>& after) {
  const size_t pixels = size_t{c.framebuffer.width} * c.framebuffer.height;
  for (size_t i = 0; i < after.size(); ++i) {
    const auto x = static_cast<uint32_t>(i % pixels % c.framebuffer.width);
    const auto y = static_cast<uint32_t>(i % pixels / c.framebuffer.width);
    if (inside(c.scissor, c.render.crop_x + x, c.render.crop_y + y)) continue;
    SHD_FUZZ_CHECK(same_value(before[i], after[i]));
  }
}

void check_stats(const shd_render_stats& stats) {
  SHD_FUZZ_CHECK(stats.nonfinite_triangle_count + stats.outside_triangle_count + stats.culled_triangle_count +
                     stats.empty_triangle_count + stats.rasterized_triangle_count ==
                 stats.triangle_count);
  SHD_FUZZ_CHECK(stats.nonfinite_fragment_count <= stats.fragment_count);
  SHD_FUZZ_CHECK(stats.clipped_triangle_count <= stats.triangle_count);
}

/// A shadow of the first light, for frames with one.
const shd_shadow* render_shadow(const Host& host, const FrameCase& c, const shd_render_desc& desc, Objects& o) {
  if (!c.shadow || desc.light_count == 0) return nullptr;
  shd_shadow_desc shadow = shd_shadow_desc_default();
  shadow.size = 16;
  shd_shadow_render_desc render = shd_shadow_render_desc_default();
  render.light = o.lights[0];
  render.draws = desc.draws;
  render.draw_count = desc.draw_count;
  const bool made = host.ok(shd_shadow_create(host.context, &shadow, &o.shadow)) &&
                    host.ok(shd_shadow_render(host.context, o.shadow, &render));
  return made ? o.shadow : nullptr;
}

void render(const Host& host, const FrameCase& c, Objects& o, std::vector<float>& planes) {
  shd_draw draws[kMaxDraws];
  shd_render_stats stats = shd_render_stats_default();
  shd_render_desc desc = c.render;
  for (size_t i = 0; i < desc.draw_count; ++i) {
    draws[i] = c.draws[i].draw;
    draws[i].mesh = o.meshes[i];
    draws[i].material = o.materials[i];
    draws[i].instances = draws[i].instance_count ? c.draws[i].instances[0] : nullptr;
  }
  desc.framebuffer = o.framebuffer;
  desc.draws = draws;
  desc.lights = o.lights;
  desc.stats = &stats;
  const shd_shadow* shadows[kMaxLights] = {render_shadow(host, c, desc, o)};
  if (shadows[0]) desc.shadows = shadows;
  std::vector<float> before;
  read_planes(c, o, before);
  const bool made = host.ok(shd_render(host.context, &desc));
  check_stats(stats);
  read_planes(c, o, planes);
  if (made && desc.scissor) check_scissor(c, before, planes);
  if (!made && host.memory.budget != 0) SHD_FUZZ_CHECK(same_values(before, planes));
}

void run(const FrameCase& c, shd_simd simd, std::vector<float>& planes) {
  Host host(simd, c.budget);
  if (!host.context) return;
  Objects o;
  if (make_objects(host, c, o)) render(host, c, o, planes);
}

}  // namespace

void describe(Source& source) {
  FrameCase c;
  choose_frame(source, c);
}

}  // namespace shd::fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace shd::fuzz;
  compare_targets<FrameCase, std::vector<float>>(
      data, size, choose_frame, run, [](const std::vector<float>& best, const std::vector<float>& baseline) {
        SHD_FUZZ_CHECK(same_values(best, baseline));
      });
  return 0;
}
