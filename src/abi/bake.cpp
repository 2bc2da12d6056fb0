// SPDX-License-Identifier: MIT
#include "abi/bake.h"

#include <shd/environment.h>

#include "abi/desc.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "abi/render.h"
#include "core/scratch.h"
#include "data/column.h"
#include "film/dilate.h"

namespace shd::abi {

shd_result check_states(const char* field, const shd_u32_out& states, uint64_t texels) {
  return check_column(field, states, texels);
}

shd_bake_stats finish_bake(const frame::Bake& bake, const shd_render_stats& stats, const shd_u32_out& states) {
  shd_bake_stats out = shd_bake_stats_default();
  uint64_t counts[4] = {};
  for (size_t i = 0; i < bake.texels.size(); ++i) {
    const uint32_t state = bake.texels[i] & 3u;
    ++counts[state];
    out.overlapping_texel_count += (bake.texels[i] & film::kTexelShared) != 0;
    if (states.data) data::store(states, i, state);
  }
  out.triangle_count = stats.triangle_count;
  out.zero_area_triangle_count = bake.zero_area_triangles;
  out.nonfinite_triangle_count = bake.nonfinite_triangles;
  out.outside_triangle_count = bake.outside_triangles;
  out.center_texel_count = counts[SHD_TEXEL_STATE_CENTER];
  out.touched_texel_count = counts[SHD_TEXEL_STATE_TOUCHED];
  out.dilated_texel_count = counts[SHD_TEXEL_STATE_DILATED];
  out.nonfinite_texel_count = stats.nonfinite_fragment_count;
  return out;
}

namespace {

constexpr uint32_t kMaxDilation = 1024;

shd_result refuse_field(const char* field) {
  return core::fail(SHD_ERROR_INVALID_ARGUMENT, "render.%s: a bake takes its default only", field);
}

/// Checks that fields without a meaning in a bake have their defaults.
shd_result check_frame(const shd_render_desc& frame) {
  if (frame.flags != SHD_RENDER_NONE) return refuse_field("flags");
  if (frame.visibility != SHD_VISIBILITY_DEPTH) return refuse_field("visibility");
  if (frame.picture_width || frame.picture_height) return refuse_field("picture_width and picture_height");
  if (frame.crop_x || frame.crop_y) return refuse_field("crop_x and crop_y");
  if (frame.viewport) return refuse_field("viewport");
  if (frame.scissor) return refuse_field("scissor");
  if (frame.supersampling > 1) return refuse_field("supersampling");
  if (frame.background != SHD_BACKGROUND_CLEAR) return refuse_field("background");
  if (frame.present.tile) return refuse_field("present");
  return frame.volume_count ? refuse_field("volume_count") : SHD_OK;
}

shd_result check_bake(const shd_bake_desc& desc, const film::Framebuffer& framebuffer) {
  SHD_TRY(check_count("bake.uv_set", desc.uv_set, 0, 1));
  SHD_TRY(check_count("bake.dilation", desc.dilation, 0, kMaxDilation));
  if (framebuffer.samples != 1) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "render.framebuffer: %u samples a pixel, but a bake takes 1",
                      framebuffer.samples);
  }
  return check_states("bake.states", desc.states, uint64_t{framebuffer.width} * framebuffer.height);
}

shd_result bake_frame(const core::Context& context, const shd_render_desc& frame, const shd_bake_desc& desc,
                      shd_render_stats* stats, shd_bake_stats* bake_stats) {
  const film::Framebuffer* framebuffer = nullptr;
  SHD_TRY(read_handle("render.framebuffer", frame.framebuffer, core::ObjectType::kFramebuffer, &framebuffer));
  SHD_TRY(check_bake(desc, *framebuffer));
  SHD_TRY(check_frame(frame));
  frame::Bake bake = {};
  bake.uv_set = desc.uv_set;
  bake.dilation = desc.dilation;
  SHD_TRY(render_desc(context, frame, &bake, stats));
  *bake_stats = finish_bake(bake, *stats, desc.states);
  return SHD_OK;
}

}  // namespace
}  // namespace shd::abi

extern "C" shd_result shd_bake(shd_context* context, const shd_render_desc* frame, const shd_bake_desc* desc) {
  using namespace shd;
  using namespace shd::abi;
  shd_render_stats* wanted = nullptr;
  shd_bake_stats* wanted_bake = nullptr;
  shd_render_stats stats = {};
  shd_bake_stats bake_stats = {};
  const shd_result result = guard([&]() -> shd_result {
    shd_bake_desc read = shd_bake_desc_default();
    SHD_TRY(read_desc("bake", desc, true, &read));
    if (read.stats) SHD_TRY(begin_output("bake.stats", read.stats));
    wanted_bake = read.stats;
    shd_render_desc read_frame = shd_render_desc_default();
    SHD_TRY(read_desc("render", frame, false, &read_frame));
    if (read_frame.stats) SHD_TRY(begin_output("render.stats", read_frame.stats));
    wanted = read_frame.stats;
    SHD_TRY(check_context(context));
    core::ScratchScope scratch(context_of(context));
    SHD_TRY(bake_frame(scratch.context, read_frame, read, &stats, &bake_stats));
    stats.scratch_bytes = scratch.peak();
    return SHD_OK;
  });
  if (result == SHD_OK && wanted) write_desc(stats, wanted);
  if (result == SHD_OK && wanted_bake) write_desc(bake_stats, wanted_bake);
  return result;
}
