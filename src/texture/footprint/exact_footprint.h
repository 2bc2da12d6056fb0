// SPDX-License-Identifier: MIT
#pragma once

#include "texture/footprint/parallelogram.h"
#include "texture/texture.h"

namespace shd::texture {

/// What one lookup of SHD_FILTER_EXACT integrates over.
struct ExactFootprint {
  uint32_t level;
  int64_t x, y;  // the texel of that level below and left of the point, before wrapping
  Vec2 center;   // the point, in texels from the centre of that one
  Vec2 a, b;     // sides in texels, counter-clockwise; a piece of at least 2^-20 by 2^-20
  bool thin;     // widened to that
  bool point;    // no longer than that at level 0: the point alone
  uint32_t layer;
  bool finite;  // whether all that was given is
};

/// Most cells that a lookup visits: 16 / tolerance^2, but 2^10..2^24.
double exact_cell_limit(float tolerance);

/// Footprint of lookup i.
ExactFootprint exact_footprint(const Texture& texture, const Sampler& sampler, const Lookups& in, size_t i);

}  // namespace shd::texture
