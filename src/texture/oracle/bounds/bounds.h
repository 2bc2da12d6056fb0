// SPDX-License-Identifier: MIT
#pragma once

#include <shd/bounds.h>

#include "texture/oracle/bounds/model.h"
#include "texture/texture.h"

namespace shd::texture {

/// Returns whether a filter has bounds.
constexpr bool has_bounds(shd_filter filter) {
  return filter == SHD_FILTER_NEAREST || filter == SHD_FILTER_BILINEAR || filter == SHD_FILTER_NEAREST_MIP ||
         filter == SHD_FILTER_BILINEAR_MIP || filter == SHD_FILTER_TRILINEAR || filter == SHD_FILTER_ANISOTROPIC;
}

/// Smallest and largest legal values of packed lookups (<shd/bounds.h>), rounded outwards. Unwanted columns are null.
/// Returns the number of lookups that were not finite.
size_t find_bounds(const Texture& texture, const Sampler& sampler, const BoundsModel& model, const Lookups& lookups,
                   float* const (&lower)[4], float* const (&upper)[4]);

}  // namespace shd::texture
