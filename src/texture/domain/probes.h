// SPDX-License-Identifier: MIT
#pragma once

#include "texture/domain/block.h"

namespace shd::texture {

/// Finds the probes of at most kBlock lookups of SHD_FILTER_ANISOTROPIC. Returns the number of lookups that were not
/// finite.
size_t find_probes(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd, const Lookups& lookups,
                   ProbeBlock* out);

}  // namespace shd::texture
