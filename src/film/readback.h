// SPDX-License-Identifier: MIT
#pragma once

#include <shd/image.h>

#include "core/simd_target.h"
#include "film/framebuffer.h"

namespace shd::film {

/// Copies a float plane, or one channel of interleaved colour, to a checked column of width * height elements, row by
/// row from the top.
void read_plane(const Framebuffer& framebuffer, shd_plane plane, const shd_f32_out& out);

/// Like read_plane(), for integer planes.
void read_u32_plane(const Framebuffer& framebuffer, shd_plane plane, const shd_u32_out& out);

/// Copies colour to a checked image of the same size, in a format accepted by image::can_encode().
void read_color(const core::SimdTarget& simd, const Framebuffer& framebuffer, const shd_image& out);

}  // namespace shd::film
