// SPDX-License-Identifier: MIT
#pragma once

#include <shd/image.h>

#include "core/context.h"

namespace shd::texture {

/// Lower bound of z, by which the x and y of a unit normal are divided to get its slopes.
constexpr double kMinNormalZ = 1.0 / 32.0;

/// Writes the slopes of normals, the squares of the slopes and their products, as shd_mip_build_moments does. The
/// images have the same size and their row strides set. `normals` has three or four channels; `out` has four channels
/// and `mixed`, which may be null, has one channel, of binary16 or binary32. Throws std::bad_alloc.
void write_moments(const core::Context& context, const shd_image& normals, const shd_image& out,
                   const shd_image* mixed);

}  // namespace shd::texture
