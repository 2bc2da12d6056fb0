// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "texture/oracle/bounds/model.h"
#include "texture/oracle/bounds/range.h"
#include "texture/texture.h"

namespace shd::texture {

/// One level of one layer, or of one face of a cube.
struct Plane {
  const Texture* texture;
  const Sampler* sampler;
  const BoundsModel* model;
  uint32_t layer, level;
  int64_t width, height;
  Range reference;  // reference of a comparison lookup
};

Plane plane_of(const Texture& texture, const Sampler& sampler, const BoundsModel& model, const Range& reference,
               uint32_t layer, uint32_t level);

/// Returns the values that texel (i, j) may have, for any i and j. Channels that are not finite are unbounded. On a
/// face of a cube, i and j are -1..size.
Color texel_range(const Plane& plane, int64_t i, int64_t j);

/// Returns the range of the texture's format, with the border colour where the sampler reads it.
Color format_range(const Texture& texture, const Sampler& sampler);

}  // namespace shd::texture
