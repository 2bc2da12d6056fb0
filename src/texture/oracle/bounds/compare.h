// SPDX-License-Identifier: MIT
/// @file
/// Bounds of comparison lookups: each texel becomes the range of its comparison before it is blended.
#pragma once

#include "texture/oracle/bounds/range.h"
#include "texture/texture.h"

namespace shd::texture {

/// Returns the numbers that an implementation may compare with texels instead of the reference of lookup i.
Range reference_range(const Texture& texture, const Lookups& in, size_t i);

/// Returns the range of the comparison of a reference with a texel.
Range compared_range(const Sampler& sampler, const Range& reference, const Range& texel);

}  // namespace shd::texture
