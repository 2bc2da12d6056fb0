// SPDX-License-Identifier: MIT
#pragma once

#include "texture/domain/direction.h"
#include "texture/domain/plane_pieces.h"
#include "texture/texture.h"

namespace shd::texture {

/// Domain of the integral of one lookup of SHD_FILTER_EXACT.
struct ExactFootprint {
  uint32_t level;
  int64_t x, y, z;  // last texel whose centre is not beyond the point along any axis, before wrapping; z = 0 in 2D
  Vec3 center;      // the point, relative to the centre of this texel [texels], in [0, 1); z = 0 in 2D
  Vec3 a, b;        // sides [texels]; in 2D counter-clockwise, at least 2^-20 long and 2^-20 wide, and with z = 0
  double depth;     // edge in z of the box that a level of detail has in a 3D texture; else 0
  bool thin;        // a footprint in 2D was widened to 2^-20
  bool point;       // both sides on level 0 are shorter than 2^-20: the lookup is a point
  uint32_t layer;   // the face of CUBE
  bool finite;      // all inputs are finite
};

/// Returns the maximum number of cells that a lookup visits: 16 / tolerance^2, clamped to 2^10..2^24.
double exact_cell_limit(float tolerance);

/// Finds the footprint of lookup i. `point`: its direction, and `sampler` is that of directions; null for other
/// textures. Sides on LAT_LONG are at most one circle wide, and sides on a disc at most half of the image in u and v.
ExactFootprint exact_footprint(const Texture& texture, const Sampler& sampler, const Lookups& in, size_t i,
                               const DirectionPoint* point = nullptr);

}  // namespace shd::texture
