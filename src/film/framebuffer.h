// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <shd/framebuffer.h>

#include "core/allocator.h"
#include "core/context.h"
#include "film/planes.h"
#include "image/pixels.h"

namespace shd::film {

/// Planes of one size, row 0 on top; absent planes are empty arrays. Colour has four planes of floats, or interleaved
/// pixels of another format.
struct Framebuffer {
  uint32_t width, height;
  shd_format color_format;                       // RGBA32F: planes R, G, B and A; otherwise `pixels`
  uint32_t samples;                              // per pixel, during rendering
  uint32_t aovs;                                 // shd_aov bits
  size_t stride;                                 // elements between rows: width rounded up to a cache line
  core::Array<float> plane[kPlaneCount];         // [shd_plane]
  core::Array<uint32_t> u32_plane[kPlaneCount];  // [shd_plane] integer planes
  core::Array<uint8_t> pixels;                   // [height][stride] pixels of color_format, or empty
  bool is_large;                                 // the planes are larger than the caches
};

/// Whether colour is stored in planes.
inline bool has_color_planes(const Framebuffer& framebuffer) {
  return framebuffer.color_format == SHD_FORMAT_RGBA32F;
}

/// Whether colour can have the format.
constexpr bool can_draw(shd_format format) {
  return image::can_encode(format) && format != SHD_FORMAT_RGBA16;
}

/// Address of an interleaved pixel.
uint8_t* pixel_at(Framebuffer* framebuffer, size_t x, size_t y);
const uint8_t* pixel_at(const Framebuffer& framebuffer, size_t x, size_t y);

/// Creates the planes of a checked desc, filled with their empty values. Throws std::bad_alloc.
void build(const core::Context& context, const shd_framebuffer_desc& desc, Framebuffer* out);

bool has_plane(const Framebuffer& framebuffer, uint32_t plane);

/// Bit t is set if the framebuffer has target t; target 0 is colour.
uint32_t targets_of(const Framebuffer& framebuffer);

/// Size of all planes in bytes.
size_t byte_size(const Framebuffer& framebuffer);

}  // namespace shd::film
