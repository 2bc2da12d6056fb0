// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "texture/oracle/bounds/model.h"
#include "texture/oracle/bounds/range.h"
#include "texture/store/reader.h"
#include "texture/texture.h"

namespace shd::texture {

/// Texture, sampler and precision of a call, the reader of its texels, and the reference of a lookup.
struct BoundsCall {
  const Texture& texture;
  const Sampler& sampler;
  const BoundsModel& model;
  TexelReader& reader;
  Range reference;  // reference of the lookup, of comparison lookups
};

/// One level of one layer, of one face of a cube, or of a 3D texture.
struct Plane {
  const BoundsCall* call;
  uint32_t layer, level;
  int64_t size[3];  // width, height, and slices of a 3D texture; otherwise 1
};

Plane plane_of(const BoundsCall& call, uint32_t layer, uint32_t level);

/// Number of axes of texel coordinates.
inline int axes_of(const Texture& texture) {
  return texture.depth != 0 ? 3 : 2;
}

/// Returns the wrap of an axis. Images of directions have no wraps: they continue beyond their edges (fold.h).
inline shd_wrap wrap_of(const BoundsCall& call, int axis) {
  if (call.texture.projection != SHD_PROJECTION_NONE) return SHD_WRAP_CLAMP;
  return axis == 0 ? call.sampler.wrap_u : axis == 1 ? call.sampler.wrap_v : call.sampler.wrap_w;
}

/// Returns the values of a texel of the image.
Color stored_range(const Plane& plane, uint32_t image, int64_t x, int64_t y);

/// Returns the values that texel (i, j, k) may have, for any i, j and k. Channels that are not finite are unbounded. On
/// a face of a cube, i and j are -1..size. k has no effect unless the texture is 3D.
Color texel_range(const Plane& plane, int64_t i, int64_t j, int64_t k = 0);

/// Returns the range of the texture's format, with the border colour where the sampler reads it.
Color format_range(const Texture& texture, const Sampler& sampler);

}  // namespace shd::texture
