// SPDX-License-Identifier: MIT
#pragma once

#include <shd/image.h>

#include "film/framebuffer.h"

namespace shd::film {

/// A float plane into a checked column of width * height elements, row by row from the top.
void read_plane(const Framebuffer& framebuffer, shd_plane plane, const shd_f32_out& out);

/// A plane of uint32_t, likewise.
void read_u32_plane(const Framebuffer& framebuffer, shd_plane plane, const shd_u32_out& out);

/// True for the formats that read_color writes.
bool can_read_color(shd_format format);

/// Colour into a checked image of the same size and a format that can_read_color: interleaved RGBA, linear but
/// for the sRGB curve of SHD_FORMAT_RGBA8_SRGB. Integers are exact: the nearest to the clamped value.
void read_color(const Framebuffer& framebuffer, const shd_image& out);

}  // namespace shd::film
