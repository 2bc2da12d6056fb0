// SPDX-License-Identifier: MIT
#pragma once

#include <shd/context.h>
#include <shd/image.h>

#include "color/config.h"
#include "color/pixels.h"
#include "color/program.h"

namespace shd::color {

// Each function but apply_tile() runs a transform over a whole image on the context's executor. Sizes must be checked.
// Throws Failure.

void apply_planes(shd_context* context, const Transform& transform, const Planes& in, const shd_image& out);
void apply_image(shd_context* context, const Transform& transform, const shd_image& in, const shd_image& out);

// To an RGBA8 or RGBA8_SRGB image by a baked transform. The bits do not depend on the machine.

void apply_planes(shd_context* context, const Program& program, const Planes& in, const shd_image& out);
void apply_image(shd_context* context, const Program& program, const shd_image& in, const shd_image& out);

// A tile of a frame to an image of its size, on the calling thread, with the bits of the functions above.

void apply_tile(shd_context* context, const Transform& transform, const Planes& in, const shd_image& out);
void apply_tile(shd_context* context, const Program& program, const Planes& in, const shd_image& out);

/// Leaves alpha unchanged.
void apply_in_place(shd_context* context, const Transform& transform, const shd_image& in_out);

}  // namespace shd::color
