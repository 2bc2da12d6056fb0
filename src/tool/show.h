// SPDX-License-Identifier: MIT
#pragma once
#include "tool/stage.h"

/// The picture of a frame: the shaded frame, or the view of `--show`.
/// @param progress  progress of the shaded frame
Picture show_frame(const Stage& stage, const Frame& frame, const shd_progress& progress);

/// The shaded frame.
Picture shade_frame(const Stage& stage, const Frame& frame);

/// Values of the samples of each pixel as colours, averaged over the pixel: show_planes.cpp.
Picture show_depth(const Stage& stage, const Frame& frame);
Picture show_position(const Stage& stage, const Frame& frame);
Picture show_overdraw(const Stage& stage, const Frame& frame);
Picture show_level(const Stage& stage, const Frame& frame);
Picture show_nearest_level(const Stage& stage, const Frame& frame);

/// The axes of tangent space over the shaded frame.
Picture show_tangents(const Stage& stage, const Frame& frame);

/// The footprints of pixels in texture space, over the shaded frame.
Picture show_footprints(const Stage& stage, const Frame& frame);

/// The triangles in texture space over their texture.
Picture show_uv_layout(const Stage& stage, const Frame& frame);

/// Ambient, diffuse and specular light and their sum, side by side.
Picture show_terms(const Stage& stage, const Frame& frame);

/// The pixels of a grid over the picture, at the distance of `--show-step`.
template <class Visit>
void visit_grid(const Options& options, Visit visit) {
  const uint32_t step = options.show_step ? options.show_step : 32;
  for (uint32_t y = step / 2; y < options.height; y += step) {
    for (uint32_t x = step / 2; x < options.width; x += step) visit(x, y, static_cast<float>(step));
  }
}

/// A plane of a framebuffer.
std::vector<float> read_floats(const shd_framebuffer* framebuffer, shd_plane plane);
std::vector<uint32_t> read_numbers(const shd_framebuffer* framebuffer, shd_plane plane);

/// SHD_PLANE_DRAW and SHD_PLANE_TRIANGLE where nothing was drawn.
constexpr uint32_t kNothing = 0xffffffff;
