// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "tool/handles.h"

/// A picture in memory, with the colours of a framebuffer: scene-linear and premultiplied.
struct Picture {
  uint32_t width = 0, height = 0;
  std::vector<float> rgba;  // [height][width][4]
};

using Rgb = std::array<float, 3>;  // scene-linear

/// A place in a picture, in pixels from its upper left corner.
struct PicturePoint {
  float x = 0, y = 0;
};

Picture blank_picture(uint32_t width, uint32_t height, const std::array<float, 4>& color);

Picture read_picture(const shd_framebuffer* framebuffer);

/// A framebuffer with these colours, to be saved as any other.
Framebuffer write_picture(shd_context* context, const Picture& picture);

/// The colour of a pixel: four floats.
inline float* pixel_of(Picture& picture, uint32_t x, uint32_t y) {
  return &picture.rgba[4 * (size_t{y} * picture.width + x)];
}
inline const float* pixel_of(const Picture& picture, uint32_t x, uint32_t y) {
  return &picture.rgba[4 * (size_t{y} * picture.width + x)];
}

/// Paints the lines between successive points, `width` pixels wide with round ends. One point is a disc.
void paint_stroke(Picture& picture, const std::vector<PicturePoint>& points, float width, const Rgb& color);

/// The mean of N x N pixels.
Picture reduce_picture(const Picture& picture, uint32_t n);

/// Pictures side by side, with a divider between them. They have the same height.
Picture join_pictures(const std::vector<Picture>& pictures);

/// Width of the divider [pixels].
constexpr uint32_t kDivider = 4;

/// A colour of a ramp from blue over green and yellow to red, for 0..1.
Rgb ramp_color(float part);
