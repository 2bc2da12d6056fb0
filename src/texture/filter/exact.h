// SPDX-License-Identifier: MIT
#pragma once

#include "texture/domain/direction.h"
#include "texture/stream.h"

namespace shd::texture {

/// A texel of a face of an image of directions.
struct FaceTexel {
  int64_t x, y;
  uint32_t face;
};

/// Properties of a projection, and functions of a target for textures of directions.
struct DirectionFunctions {
  FoldTraits traits;
  DirectionPoint (*project)(const Texture& texture, const Lookups& in, size_t i);
  FaceTexel (*fold)(const Texture& texture, uint32_t level, const FaceTexel& beyond);
  bool (*lacks_corner)(const Texture& texture, uint32_t face, bool left, bool top);
};

/// Runs SHD_FILTER_EXACT: integrates over the footprint in doubles. Point lookups go to `run_linear`, the filter
/// BILINEAR of the same target and domain. Returns the number of lookups that were not finite.
size_t run_exact(const FilterCall& call, RunFilter run_linear, const DirectionFunctions* directions = nullptr);

}  // namespace shd::texture
