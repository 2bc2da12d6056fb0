// SPDX-License-Identifier: MIT
#include "tool/zoom.h"

#include <algorithm>
#include <cmath>

#include "command/failure.h"
#include "tool/samples.h"
#include "tool/show.h"

namespace {

/// The pixels that are enlarged, and by how much.
struct Window {
  uint32_t left, top, size, scale;
};

Window window_of(const Options& options) {
  const ZoomOption& zoom = options.zoom;
  const auto begin = [&zoom](uint32_t at, uint32_t side) {
    return std::min(at - std::min(at, zoom.size / 2), side - zoom.size);
  };
  return {begin(zoom.x, options.width), begin(zoom.y, options.height), zoom.size,
          std::min(options.width, options.height) / zoom.size};
}

/// Squares with the colours of pixels. Squares of 8 pixels or more have a line at their left and upper side.
Picture enlarge(const Picture& picture, const Window& window) {
  const uint32_t side = window.size * window.scale;
  Picture out = blank_picture(side, side, {});
  for (uint32_t y = 0; y < side; ++y) {
    for (uint32_t x = 0; x < side; ++x) {
      float* const to = pixel_of(out, x, y);
      std::copy_n(pixel_of(picture, window.left + x / window.scale, window.top + y / window.scale), 4, to);
      const bool is_line = window.scale >= 8 && (x % window.scale == 0 || y % window.scale == 0);
      for (size_t c = 0; c < 4 && is_line; ++c) to[c] = 0.7f * to[c] + 0.3f * (c < 3 ? 0.3f : 1.0f);
    }
  }
  return out;
}

/// Draws the visible edges of the triangles over the enlarged picture.
void paint_edges(const Stage& stage, const Frame& frame, const Window& window, Picture& picture) {
  shd_framebuffer_desc planes = shd_framebuffer_desc_default();
  planes.width = picture.width;
  planes.height = picture.height;
  planes.sample_count = 4;
  Framebuffer framebuffer;
  check(shd_framebuffer_create(stage.context, &planes, framebuffer.out()), "framebuffer");
  shd_material_desc ink = shd_material_desc_default();
  ink.model = SHD_MODEL_UNLIT;
  const float orange[3] = {1.0f, 0.35f, 0.0f};
  std::copy_n(orange, 3, ink.diffuse);
  Material material;
  check(shd_material_create(stage.context, &ink, material.out()), "--zoom");
  std::vector<shd_draw> draws(frame.draws.draws.begin(),
                              frame.draws.draws.begin() + static_cast<std::ptrdiff_t>(frame.draws.solid_count));
  for (shd_draw& draw : draws) {
    draw.material = nullptr;
    draw.fill = SHD_FILL_SOLID;
    draw.depth_bias = 1e-5f;
    draw.depth_bias_slope = 2.0f;
  }
  for (size_t i = 0; i < frame.draws.solid_count; ++i) {
    shd_draw edges = frame.draws.draws[i];
    edges.material = material.get();
    edges.fill = SHD_FILL_WIREFRAME;
    edges.fill_width = 1.5f;
    edges.depth_bias = edges.depth_bias_slope = 0.0f;
    edges.compare = SHD_COMPARE_LESS_EQUAL;
    draws.push_back(edges);
  }
  shd_render_desc desc = shd_render_desc_default();
  desc.framebuffer = framebuffer.get();
  desc.view = window_view(stage.options, frame.camera.view, window.left, window.top, window.size, window.size);
  desc.draws = draws.data();
  desc.draw_count = draws.size();
  check(shd_render(stage.context, &desc), "--zoom");
  const Picture lines = read_picture(framebuffer.get());
  for (size_t i = 0; i < picture.rgba.size(); ++i) {
    picture.rgba[i] = lines.rgba[i] + (1.0f - lines.rgba[i | 3]) * picture.rgba[i];
  }
}

/// A black ring between white ones, filled with black if the sample shows the model.
void paint_dot(const PicturePoint& at, float radius, bool is_filled, Picture& picture) {
  std::vector<PicturePoint> circle;
  for (int i = 0; i <= 24; ++i) {
    const float angle = 6.2831853f * static_cast<float>(i) / 24.0f;
    circle.push_back({at.x + radius * std::cos(angle), at.y + radius * std::sin(angle)});
  }
  const float line = std::max(0.3f * radius, 1.0f);
  paint_stroke(picture, circle, 2.2f * line, {1, 1, 1});
  if (is_filled) {
    paint_stroke(picture, {at}, 2.0f * radius + line, {0, 0, 0});
  } else {
    paint_stroke(picture, circle, line, {0, 0, 0});
  }
}

}  // namespace

Picture zoom_picture(const Stage& stage, const Frame& frame, const Picture& picture) {
  const Window window = window_of(stage.options);
  Picture out = enlarge(picture, window);
  if (stage.options.wire_width == 0.0f) paint_edges(stage, frame, window, out);
  const std::vector<PicturePoint> places = sample_places(stage.options);
  const auto scale = static_cast<float>(window.scale);
  const float radius = std::min(0.2f * scale / std::sqrt(static_cast<float>(places.size())), 8.0f);
  const auto visit = [&](size_t i, const shd_framebuffer* framebuffer) {
    const std::vector<uint32_t> draw = read_numbers(framebuffer, SHD_PLANE_DRAW);
    for (uint32_t y = 0; y < window.size; ++y) {
      for (uint32_t x = 0; x < window.size; ++x) {
        const size_t pixel = size_t{window.top + y} * stage.options.width + window.left + x;
        const PicturePoint at = {scale * (static_cast<float>(x) + places[i].x),
                                 scale * (static_cast<float>(y) + places[i].y)};
        if (radius >= 1.5f) paint_dot(at, radius, draw[pixel] != kNothing, out);
      }
    }
  };
  visit_samples(stage.context, stage.options, frame.camera.view, frame.draws, SHD_AOV_DRAW, visit);
  return out;
}
