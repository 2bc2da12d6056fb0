// SPDX-License-Identifier: MIT
#pragma once

#include "texture/texture.h"

namespace shd::texture {

/// The sampler that lookups take whose level of detail, after bias and clamps, is 0 or below ...
Sampler magnifier(const Sampler& sampler);
/// ... and the one of the others.
Sampler minifier(const Sampler& sampler);

/// run_filter() with the magnifier or the minifier, chosen for each lookup; the two filters differ.
size_t sample_magnified(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd,
                        const Lookups& lookups, const Texels& out);

/// The one of the two that a single lookup takes.
Sampler sampler_of(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd, const Lookups& lookup);

}  // namespace shd::texture
