// SPDX-License-Identifier: MIT
#pragma once

#include <shd/image.h>

#include "core/context.h"

namespace shd::texture {

/// Lower bound of the z of a unit normal that its slopes are divided by.
constexpr double kMinNormalZ = 1.0 / 32.0;

/// Slopes of normals, and their squares, as shd_normal_moments has them. Of images of one size, with their row strides
/// set: normals of three or four channels, `out` of four of binary16 or binary32. Throws std::bad_alloc.
void write_moments(const core::Context& context, const shd_image& normals, const shd_image& out);

}  // namespace shd::texture
