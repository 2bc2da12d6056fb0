// SPDX-License-Identifier: MIT
#pragma once

#include <shd/bounds.h>

#include "texture/oracle/bounds/model.h"
#include "texture/texture.h"

namespace shd::texture {

/// Smallest and largest legal values of packed lookups (<shd/bounds.h>), rounded outwards. Unwanted columns are null.
/// Returns the number of lookups that were not finite.
size_t find_bounds(const Texture& texture, const Sampler& sampler, const BoundsModel& model, const Lookups& lookups,
                   float* const (&lower)[4], float* const (&upper)[4]);

}  // namespace shd::texture
