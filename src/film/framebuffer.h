// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <shd/framebuffer.h>

#include "core/allocator.h"
#include "core/context.h"
#include "film/planes.h"

namespace shd::film {

/// Planes of one size, row 0 on top; absent planes are empty arrays.
struct Framebuffer {
  uint32_t width, height;
  uint32_t samples;                              // per pixel, during rendering
  uint32_t aovs;                                 // shd_aov bits
  size_t stride;                                 // elements between rows: width rounded up to a cache line
  core::Array<float> plane[kPlaneCount];         // [shd_plane]
  core::Array<uint32_t> u32_plane[kPlaneCount];  // [shd_plane] integer planes
};

/// Creates the planes of a checked desc, filled with their empty values. Throws std::bad_alloc.
void build(const core::Context& context, const shd_framebuffer_desc& desc, Framebuffer* out);

bool has_plane(const Framebuffer& framebuffer, shd_plane plane);

/// Bit t is set if the framebuffer has target t; target 0 is colour.
uint32_t targets_of(const Framebuffer& framebuffer);

/// Size of all planes in bytes.
size_t byte_size(const Framebuffer& framebuffer);

}  // namespace shd::film
