// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <shd/framebuffer.h>

#include "core/simd_target.h"
#include "io/codec/codec.h"

namespace shd::io {

/// A plane as a channel of a file: floats as kFloat or kHalf, integers as kU32.
struct PlaneChannel {
  shd_plane_view view;
  Sample sample;
  size_t step = 4;  // bytes between elements of a row
};

/// Planes as they are: user_data of a job whose `row` is plane_row().
struct PlaneRows {
  uint32_t width = 0;
  std::vector<PlaneChannel> channels;
};
void plane_row(const void* plane_rows, uint32_t y, unsigned char* out);

/// Colour as straight RGBA, or as RGB over black, in codes of 8 or 16 bits, clamped to 0..1 with NaN as 0, and rounded
/// to nearest or dithered:
/// user_data of a job whose `row` is code_row().
struct CodeRows {
  uint32_t width = 0;
  uint32_t bits = 8;  // bits of a code, 8 or 16
  core::SimdTarget simd;
  shd_plane_view plane[4] = {};    // r, g, b, a: linear, premultiplied
  const float* display = nullptr;  // [height][width][4], replaces the planes: straight, encoded. null = none
  bool curve = true;               // encodes r, g and b of the planes as sRGB
  bool dither = false;             // ordered dither of r, g and b
  bool over_black = false;         // codes times alpha, without alpha
};
void code_row(const void* code_rows, uint32_t y, unsigned char* out);

}  // namespace shd::io
