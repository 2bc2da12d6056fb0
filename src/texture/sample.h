// SPDX-License-Identifier: MIT
#pragma once

#include "texture/texture.h"

namespace shd::texture {

/// The filters behind sample(): channels that the format stores only. Error bounds against exact arithmetic on the
/// same floats, for texels of magnitude up to m (1 for unorm) and a level of w x h:
///   nearest    exact, but for coordinates within 2^-23 of a texel's edge
///   bilinear   m (3e-7 + 2e-7 (w + h))
///   trilinear  that of both levels, and 2e-6 m for the level of detail
size_t sample_nearest(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd,
                      const Lookups& lookups, const Texels& out);
size_t sample_bilinear(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd,
                       const Lookups& lookups, const Texels& out);
size_t sample_trilinear(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd,
                        const Lookups& lookups, const Texels& out);

}  // namespace shd::texture
