// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/context.h"
#include "frame/frame.h"

namespace shd::frame {

/// A frame whose triangles lie at their texture coordinates, and what was found in it.
struct Bake {
  uint32_t uv_set;               // 0 or 1
  uint32_t dilation;             // texels
  core::Array<uint8_t> texels;   // [height][width] states: see film/dilate.h
  uint64_t outside_triangles;    // with a corner beyond the texture
  uint64_t zero_area_triangles;  // on the grid of 1/256 texel
  uint64_t nonfinite_triangles;
};

/// Draws a frame with one sample per pixel into its framebuffer, one opaque fragment per touched texel, then dilates
/// it. Window, viewport, scissor, load, passes, supersampling, visibility and volumes of the frame are replaced. All
/// draws have a material. Throws Failure and std::bad_alloc; then the framebuffer may hold a part of the result.
void bake(const core::Context& context, const Frame& frame, Bake* bake, shd_render_stats* stats);

}  // namespace shd::frame
