// SPDX-License-Identifier: MIT
#pragma once

#include <shd/image.h>

#include "film/framebuffer.h"

namespace shd::film {

/// Copies a float plane to a checked column of width * height elements, row by row from the top.
void read_plane(const Framebuffer& framebuffer, shd_plane plane, const shd_f32_out& out);

/// Like read_plane(), for integer planes.
void read_u32_plane(const Framebuffer& framebuffer, shd_plane plane, const shd_u32_out& out);

/// Whether read_color() can write the format.
bool can_read_color(shd_format format);

/// Copies colour to a checked image of the same size, in a format accepted by can_read_color(): interleaved RGBA,
/// linear except for the sRGB curve of SHD_FORMAT_RGBA8_SRGB. Integers are exactly the nearest to the clamped value.
void read_color(const Framebuffer& framebuffer, const shd_image& out);

}  // namespace shd::film
