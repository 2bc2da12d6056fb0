// SPDX-License-Identifier: MIT
#include "tool/show.h"

#include "command/failure.h"

std::vector<float> read_floats(const shd_framebuffer* framebuffer, shd_plane plane) {
  shd_framebuffer_info info = shd_framebuffer_info_default();
  check(shd_framebuffer_get_info(framebuffer, &info), "--show");
  std::vector<float> values(size_t{info.width} * info.height);
  const shd_f32_out out = shd_f32_out_column(values.data(), 0);
  check(shd_framebuffer_read_plane(framebuffer, plane, &out), "--show");
  return values;
}

std::vector<uint32_t> read_numbers(const shd_framebuffer* framebuffer, shd_plane plane) {
  shd_framebuffer_info info = shd_framebuffer_info_default();
  check(shd_framebuffer_get_info(framebuffer, &info), "--show");
  std::vector<uint32_t> values(size_t{info.width} * info.height);
  const shd_u32_out out = {values.data(), 0};
  check(shd_framebuffer_read_u32_plane(framebuffer, plane, &out), "--show");
  return values;
}

Picture shade_frame(const Stage& stage, const Frame& frame) {
  render(stage, stage.options, frame, shd_progress{});
  return read_picture(stage.framebuffer.get());
}

Picture show_frame(const Stage& stage, const Frame& frame, const shd_progress& progress) {
  switch (stage.options.show) {
    case Show::kDepth: return show_depth(stage, frame);
    case Show::kPosition: return show_position(stage, frame);
    case Show::kOverdraw: return show_overdraw(stage, frame);
    case Show::kLevel: return show_level(stage, frame);
    case Show::kLevelNearest: return show_nearest_level(stage, frame);
    case Show::kTangents: return show_tangents(stage, frame);
    case Show::kFootprint: return show_footprints(stage, frame);
    case Show::kUvLayout: return show_uv_layout(stage, frame);
    case Show::kTerms: return show_terms(stage, frame);
    default: break;
  }
  render(stage, stage.options, frame, progress);
  return read_picture(stage.framebuffer.get());
}
