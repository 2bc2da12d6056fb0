// SPDX-License-Identifier: MIT
#pragma once

#include "texture/texture.h"

namespace shd::texture {

/// SHD_FILTER_EXACT: the integral over the footprint, in doubles. Returns how many lookups were not finite.
size_t sample_exact(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd,
                    const Lookups& lookups, const Texels& out);

}  // namespace shd::texture
