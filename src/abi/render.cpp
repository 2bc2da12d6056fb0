// SPDX-License-Identifier: MIT
#include <shd/render.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>

#include <shd/shadow.h>

#include "abi/black_draws.h"
#include "abi/camera.h"
#include "abi/desc.h"
#include "abi/draws.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "abi/render.h"
#include "abi/volume.h"
#include "core/scratch.h"
#include "environment/environment.h"
#include "frame/bake.h"
#include "frame/frame.h"
#include "frame/supersample.h"

namespace {

using namespace shd;
using namespace shd::abi;

constexpr uint32_t kMaxPicture = 65536;
constexpr uint32_t kMaxSupersampling = 16;
constexpr uint32_t kMinPass = 1024, kMaxPass = 0x7fffffff;  // triangles

/// Draws with a blend in the order of draws are painted over the previous ones.
void ignore_depth(core::Buffer<frame::Draw>* draws) {
  for (size_t i = 0; i < draws->size(); ++i) {
    frame::Draw& draw = (*draws)[i];
    if (!draw.material || !material::is_unordered(*draw.material)) draw.depth.compare = SHD_COMPARE_ALWAYS;
  }
}

/// One side of a region of the picture.
shd_result check_span(const char* region, const char* start_name, const char* size_name, uint32_t start, uint32_t size,
                      uint32_t min_size, uint32_t picture) {
  char field[48];
  std::snprintf(field, sizeof field, "render.%s.%s", region, start_name);
  SHD_TRY(check_count(field, start, 0, picture - min_size));
  std::snprintf(field, sizeof field, "render.%s.%s", region, size_name);
  return check_count(field, size, min_size, picture - start);
}

shd_result check_region(const char* name, const shd_region& region, uint32_t min_size, uint32_t width,
                        uint32_t height) {
  SHD_TRY(check_span(name, "x", "width", region.x, region.width, min_size, width));
  return check_span(name, "y", "height", region.y, region.height, min_size, height);
}

/// The picture, and where framebuffer, viewport and scissor lie in it.
shd_result read_window(const shd_render_desc& desc, frame::Frame* frame) {
  SHD_TRY(check_count("render.supersampling", desc.supersampling, 1, kMaxSupersampling));
  const film::Framebuffer& framebuffer = *frame->framebuffer;
  const uint32_t width = desc.picture_width ? desc.picture_width : framebuffer.width;
  const uint32_t height = desc.picture_height ? desc.picture_height : framebuffer.height;
  SHD_TRY(check_count("render.picture_width", width, framebuffer.width, kMaxPicture));
  SHD_TRY(check_count("render.picture_height", height, framebuffer.height, kMaxPicture));
  const uint32_t factor = desc.supersampling, max_side = kMaxPicture / factor;
  if (width > max_side || height > max_side) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT,
                      "render.supersampling: %u times a picture of %u x %u exceeds %u pixels a side", factor, width,
                      height, kMaxPicture);
  }
  SHD_TRY(check_count("render.crop_x", desc.crop_x, 0, width - framebuffer.width));
  SHD_TRY(check_count("render.crop_y", desc.crop_y, 0, height - framebuffer.height));
  const shd_region all = {0, 0, width, height};
  const shd_region viewport = desc.viewport ? *desc.viewport : all, scissor = desc.scissor ? *desc.scissor : all;
  SHD_TRY(check_region("viewport", viewport, 1, width, height));
  SHD_TRY(check_region("scissor", scissor, 0, width, height));
  frame->window = {static_cast<int32_t>(desc.crop_x), static_cast<int32_t>(desc.crop_y)};
  frame->viewport = {viewport.x, viewport.y, viewport.width, viewport.height};
  frame->scissor = geometry::pixel_rectangle(static_cast<int32_t>(scissor.x), static_cast<int32_t>(scissor.y),
                                             scissor.width, scissor.height);
  return SHD_OK;
}

/// The desc's camera with the aspect of the viewport, or its view.
shd_result read_view(const shd_render_desc& desc, frame::Frame* frame) {
  if (desc.camera) {
    const float aspect = static_cast<float>(frame->viewport.width) / static_cast<float>(frame->viewport.height);
    return read_camera(desc.camera, aspect, &frame->view);
  }
  SHD_TRY(check_finite("render.view.world_to_view", desc.view.world_to_view, 16));
  SHD_TRY(check_finite("render.view.view_to_clip", desc.view.view_to_clip, 16));
  SHD_TRY(check_finite("render.view.eye", desc.view.eye, 3));
  frame->view = desc.view;
  return SHD_OK;
}

shd_result check_render_desc(const shd_render_desc& desc) {
  SHD_TRY(check_enum("render.visibility", desc.visibility, 0, SHD_VISIBILITY_NEWELL));
  SHD_TRY(check_count("render.pass_triangles", desc.pass_triangles, kMinPass, kMaxPass));
  SHD_TRY(check_flags("render.flags", desc.flags, SHD_RENDER_COUNT_HIDDEN | SHD_RENDER_LOAD));
  SHD_TRY(check_finite("render.clear_color", desc.clear_color, 4));
  SHD_TRY(check_range("render.clear_depth", static_cast<double>(desc.clear_depth), 0.0, 1.0));
  SHD_TRY(check_count("render.draw_count", desc.draw_count, 0, kMaxItems));
  SHD_TRY(check_count("render.light_count", desc.light_count, 0, kMaxItems));
  if (desc.draw_count) SHD_TRY(check_not_null("render.draws", desc.draws));
  if (desc.light_count) SHD_TRY(check_not_null("render.lights", desc.lights));
  return SHD_OK;
}

/// A shadow of a light, or none.
shd_result read_shadow(const shd_shadow* handle, const light::Light& light, const light::Shadow** out) {
  *out = nullptr;
  if (!handle) return SHD_OK;
  const light::Shadow* shadow = nullptr;
  SHD_TRY(read_handle("shadow", handle, core::ObjectType::kShadow, &shadow));
  if (!shadow->is_rendered) return core::fail(SHD_ERROR_INVALID_ARGUMENT, "shadow: it was not rendered yet");
  if (shadow->map.placement.kind != light.kind) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "shadow: rendered for a light of kind %d, not %d",
                      static_cast<int>(shadow->map.placement.kind), static_cast<int>(light.kind));
  }
  *out = shadow;
  return SHD_OK;
}

shd_result check_rotation(const char* field, const float* m) {
  SHD_TRY(check_values(field, m, 9, -2.0, 2.0));
  for (int a = 0; a < 3; ++a) {
    for (int b = a; b < 3; ++b) {
      double dot = 0.0;
      for (int c = 0; c < 3; ++c) dot += static_cast<double>(m[3 * a + c]) * static_cast<double>(m[3 * b + c]);
      const double want = a == b ? 1.0 : 0.0;
      if (std::fabs(dot - want) <= 1e-3) continue;
      return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s: columns %d and %d have the product %g, not %g", field, a, b,
                        dot, want);
    }
  }
  return SHD_OK;
}

/// Table of an environment that is missing, or null.
const char* missing_table(const environment::Environment& map, uint32_t tables) {
  if (tables & SHD_ENVIRONMENT_TABLE_GGX && map.ggx.count == 0) return "SHD_ENVIRONMENT_TABLE_GGX";
  if (tables & SHD_ENVIRONMENT_TABLE_PHONG && map.phong.count == 0) return "SHD_ENVIRONMENT_TABLE_PHONG";
  if (tables & SHD_ENVIRONMENT_TABLE_RADIANCE && map.radiance.count == 0) return "SHD_ENVIRONMENT_TABLE_RADIANCE";
  return nullptr;
}

/// The environment, and that it has the tables of the materials.
shd_result read_environment(const shd_render_desc& desc, const core::Buffer<frame::Draw>& draws,
                            shade::EnvironmentLight* out) {
  SHD_TRY(check_range("render.environment_intensity", static_cast<double>(desc.environment_intensity), 0.0, 1e12));
  SHD_TRY(check_rotation("render.environment_to_world", desc.environment_to_world));
  SHD_TRY(check_enum("render.background", desc.background, SHD_BACKGROUND_CLEAR, SHD_BACKGROUND_ENVIRONMENT));
  SHD_TRY(check_range("render.background_roughness", static_cast<double>(desc.background_roughness), 0.0, 1.0));
  if (!desc.environment) {
    if (desc.background == SHD_BACKGROUND_CLEAR) return SHD_OK;
    return core::fail(SHD_ERROR_INVALID_ARGUMENT,
                      "render.background: SHD_BACKGROUND_ENVIRONMENT, but render.environment is NULL");
  }
  const environment::Environment* map = nullptr;
  SHD_TRY(read_handle("render.environment", desc.environment, core::ObjectType::kEnvironment, &map));
  for (size_t i = 0; i < draws.size(); ++i) {
    if (!draws[i].material) continue;
    const char* missing = missing_table(*map, material::info_of(draws[i].material->model).environment_tables);
    if (!missing) continue;
    return core::fail(SHD_ERROR_INVALID_ARGUMENT,
                      "render.environment: made without %s, which the model of render.draws[%u] takes", missing,
                      draws[i].index);
  }
  if (desc.background == SHD_BACKGROUND_ENVIRONMENT) {
    const bool blurs = desc.background_roughness > 0.0f;
    const char* missing = missing_table(*map, blurs ? SHD_ENVIRONMENT_TABLE_GGX : SHD_ENVIRONMENT_TABLE_RADIANCE);
    if (missing) {
      return core::fail(SHD_ERROR_INVALID_ARGUMENT, "render.environment: made without %s, which the background takes",
                        missing);
    }
  }
  out->map = map;
  out->intensity = desc.environment_intensity;
  for (int k = 0; k < 9; ++k) out->world_to_map[k] = desc.environment_to_world[k % 3 * 3 + k / 3];  // the transpose
  return SHD_OK;
}

/// Checks that every draw of a bake has a material.
shd_result check_materials(const core::Buffer<frame::Draw>& draws) {
  for (size_t i = 0; i < draws.size(); ++i) {
    if (draws[i].material) continue;
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "render.draws[%u]: draw.material: NULL, but a bake shades every draw",
                      draws[i].index);
  }
  return SHD_OK;
}

}  // namespace

shd_result abi::render_desc(const core::Context& context, const shd_render_desc& desc, frame::Bake* bake,
                            shd_render_stats* stats) {
  SHD_TRY(check_render_desc(desc));
  frame::Frame frame = {};
  SHD_TRY(read_handle("render.framebuffer", desc.framebuffer, core::ObjectType::kFramebuffer, &frame.framebuffer));
  SHD_TRY(read_window(desc, &frame));
  SHD_TRY(read_view(desc, &frame));
  core::Buffer<frame::Draw> draws(context.allocator);
  draws.reserve(desc.draw_count);
  SHD_TRY(read_draws("render", desc.draws, desc.draw_count, &draws));
  if (bake) SHD_TRY(check_materials(draws));
  if (desc.visibility != SHD_VISIBILITY_DEPTH) ignore_depth(&draws);
  core::Array<const light::Light*> lights(context.allocator, desc.light_count);
  for (size_t i = 0; i < desc.light_count; ++i) {
    const light::LightBody* body = nullptr;
    SHD_TRY(in_element(read_handle("light", desc.lights[i], core::ObjectType::kLight, &body), "render", "lights", i));
    lights[i] = &body->light;
  }
  core::Array<const light::Shadow*> shadows(context.allocator, desc.shadows ? desc.light_count : 0);
  for (size_t i = 0; i < shadows.size(); ++i) {
    SHD_TRY(in_element(read_shadow(desc.shadows[i], *lights[i], &shadows[i]), "render", "shadows", i));
  }
  SHD_TRY(read_environment(desc, draws, &frame.environment));
  frame.background = desc.background;
  frame.background_roughness = desc.background_roughness;
  core::Buffer<frame::VolumeDraw> volumes(context.allocator);
  SHD_TRY(read_volumes(desc.volumes, desc.volume_count, &volumes));
  frame.volumes = volumes.data();
  frame.volume_count = volumes.size();
  frame.load = (desc.flags & SHD_RENDER_LOAD) != 0;
  std::memcpy(frame.clear_color, desc.clear_color, sizeof frame.clear_color);
  frame.clear_depth = desc.clear_depth;
  frame.draws = draws.data();
  frame.draw_count = draws.size();
  frame.lights = lights.data();
  frame.light_count = lights.size();
  frame.shadows = desc.shadows ? shadows.data() : nullptr;
  frame.progress = desc.progress;
  frame.present = desc.present;
  frame.counts_hidden = (desc.flags & SHD_RENDER_COUNT_HIDDEN) != 0;
  frame.visibility = desc.visibility;
  frame.counts_conflicts = desc.stats != nullptr;
  frame.supersampling = desc.supersampling;
  frame.pass_triangles = desc.pass_triangles;
  const uint64_t black_draws = bake ? 0 : report_black_draws(context, frame);
  if (bake) {
    frame::bake(context, frame, bake, stats);
  } else if (frame.supersampling > 1) {
    frame::render_supersampled(context, frame, stats);
  } else {
    frame::render(context, frame, stats);
  }
  stats->black_draw_count = black_draws;
  return SHD_OK;
}

extern "C" shd_result shd_render(shd_context* context, const shd_render_desc* desc) {
  shd_render_stats* wanted = nullptr;
  shd_render_stats stats = {};
  const shd_result result = guard([&]() -> shd_result {
    shd_render_desc read = shd_render_desc_default();
    SHD_TRY(read_desc("render", desc, false, &read));
    if (read.stats) SHD_TRY(begin_output("render.stats", read.stats));
    wanted = read.stats;
    SHD_TRY(check_context(context));
    core::ScratchScope scratch(context_of(context));
    SHD_TRY(render_desc(scratch.context, read, nullptr, &stats));
    stats.scratch_bytes = scratch.peak();
    return SHD_OK;
  });
  if (result == SHD_OK && wanted) write_desc(stats, wanted);
  return result;
}
