// SPDX-License-Identifier: MIT
#include "frame/bake.h"

#include "film/dilate.h"

namespace shd::frame {
namespace {

constexpr uint32_t kOnePass = 0x7fffffff;  // triangles

/// The draws with the state that a bake has: all triangles, filled.
core::Buffer<Draw> solid_draws(const core::Context& context, const Frame& frame) {
  core::Buffer<Draw> draws(context.allocator);
  draws.reserve(frame.draw_count);
  for (size_t i = 0; i < frame.draw_count; ++i) {
    Draw draw = frame.draws[i];
    draw.cull = SHD_CULL_NONE;
    draw.sample_shading = draw.affine = false;
    draw.outline = {SHD_FILL_SOLID, 0, 0, 0.0f};
    draws.push_back(draw);
  }
  return draws;
}

}  // namespace

void bake(const core::Context& context, const Frame& frame, Bake* bake, shd_render_stats* stats) {
  const uint32_t width = frame.framebuffer->width, height = frame.framebuffer->height;
  bake->texels = core::Array<uint8_t>(context.allocator, size_t{width} * height);
  bake->texels.fill_zero();
  const core::Buffer<Draw> draws = solid_draws(context, frame);
  Frame flat = frame;
  flat.bake = bake;
  flat.draws = draws.data();
  flat.window = {0, 0};
  flat.viewport = {0, 0, width, height};
  flat.scissor = geometry::pixel_rectangle(0, 0, width, height);
  flat.load = false;
  flat.clear_depth = 1.0f;
  flat.pass_triangles = kOnePass;
  flat.supersampling = 0;
  flat.counts_hidden = flat.counts_conflicts = false;
  flat.visibility = SHD_VISIBILITY_DEPTH;
  flat.volume_count = 0;
  render(context, flat, stats);
  bake->zero_area_triangles = stats->culled_triangle_count;
  bake->nonfinite_triangles = stats->nonfinite_triangle_count;
  film::dilate(context, bake->dilation, bake->texels.data(), frame.framebuffer);
}

}  // namespace shd::frame
