// SPDX-License-Identifier: MIT
#pragma once

#include "texture/texture.h"

namespace shd::texture {

/// Returns the sampler for magnification: for lookups whose level of detail is at most 0 after bias and clamps.
Sampler magnifier(const Sampler& sampler);
/// Returns the sampler for all other lookups.
Sampler minifier(const Sampler& sampler);

/// Calls sample() with the magnifier or the minifier, chosen for each lookup. The sampler's magnification is not
/// SHD_MAGNIFICATION_DEFAULT.
size_t sample_magnified(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd,
                        const Lookups& lookups, const Texels& out);

/// Returns the sampler of the two that a single lookup takes.
Sampler sampler_of(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd, const Lookups& lookup);

}  // namespace shd::texture
