// SPDX-License-Identifier: MIT
#pragma once

#include "texture/domain/parallelogram.h"
#include "texture/texture.h"

namespace shd::texture {

/// Domain of the integral of one lookup of SHD_FILTER_EXACT.
struct ExactFootprint {
  uint32_t level;
  int64_t x, y;  // last texel whose centre is not beyond the point along either axis, before wrapping
  Vec2 center;   // the point, relative to the centre of this texel [texels], in [0, 1)
  Vec2 a, b;     // sides [texels], counter-clockwise; at least 2^-20 long and 2^-20 wide
  bool thin;     // the footprint was widened to 2^-20
  bool point;    // both sides on level 0 are shorter than 2^-20: the lookup is a point
  uint32_t layer;
  bool finite;  // all inputs are finite
};

/// Returns the maximum number of cells that a lookup visits: 16 / tolerance^2, clamped to 2^10..2^24.
double exact_cell_limit(float tolerance);

/// Finds the footprint of lookup i.
ExactFootprint exact_footprint(const Texture& texture, const Sampler& sampler, const Lookups& in, size_t i);

}  // namespace shd::texture
