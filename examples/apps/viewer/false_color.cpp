// SPDX-License-Identifier: MIT
#include "false_color.h"

#include <algorithm>
#include <cmath>

namespace viewer {
namespace {

constexpr uint8_t kHeat[9][3] = {{24, 26, 30},   {38, 70, 140},  {40, 120, 170}, {52, 160, 140}, {96, 190, 90},
                                 {190, 205, 70}, {240, 180, 60}, {235, 120, 50}, {205, 50, 45}};

}  // namespace

void show_overdraw(const shd_framebuffer* framebuffer, Image& image) {
  const shd_plane_view plane = shd::framebuffer_view_plane(framebuffer, SHD_PLANE_OVERDRAW);
  for (uint32_t y = 0; y < image.height; ++y) {
    const uint32_t* row = plane.u32 + y * plane.row_stride / sizeof *row;
    for (uint32_t x = 0; x < image.width; ++x) {
      uint8_t* const pixel = &image.display[4 * (size_t{y} * image.width + x)];
      std::copy_n(kHeat[std::min(row[x], 8u)], 3, pixel);
      pixel[3] = 255;
    }
  }
}

void show_depth(const shd_framebuffer* framebuffer, const shd_camera& camera, Image& image) {
  const shd_plane_view plane = shd::framebuffer_view_plane(framebuffer, SHD_PLANE_DEPTH);
  const float near = camera.near_plane, far = camera.far_plane;
  const auto distance = [&](float depth) { return near * far / (far - depth * (far - near)); };
  const float* const depths = plane.f32;
  const size_t stride = plane.row_stride / sizeof *depths;
  float low = far, high = near;
  for (uint32_t y = 0; y < image.height; ++y) {
    for (uint32_t x = 0; x < image.width; ++x) {
      const float depth = depths[y * stride + x];
      if (depth >= 1.0f) continue;
      low = std::min(low, distance(depth)), high = std::max(high, distance(depth));
    }
  }
  const float range = std::max(std::log(high / std::max(low, 1e-30f)), 1e-6f);
  for (uint32_t y = 0; y < image.height; ++y) {
    for (uint32_t x = 0; x < image.width; ++x) {
      const float depth = depths[y * stride + x];
      const float part = depth >= 1.0f ? 1.0f : std::clamp(std::log(distance(depth) / low) / range, 0.0f, 1.0f);
      const auto grey = static_cast<uint8_t>(std::lround(depth >= 1.0f ? 16.0f : 245.0f - 210.0f * part));
      uint8_t* const pixel = &image.display[4 * (size_t{y} * image.width + x)];
      pixel[0] = pixel[1] = pixel[2] = grey;
      pixel[3] = 255;
    }
  }
}

}  // namespace viewer
