// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <shd/render.h>

#include "core/simd_target.h"
#include "geometry/assemble.h"
#include "raster/sample_pattern.h"
#include "raster/tile.h"

namespace shd::raster {

/// How the depths of a draw meet those of the tile.
struct DepthState {
  shd_compare compare;
  bool writes;
  float bias, slope_bias;  // slope_bias: times the larger of |dz/dx| and |dz/dy| per pixel
};

/// Where triangles are drawn.
struct CoverArea {
  const SamplePattern& pattern;
  int32_t left, top;       // pixel position of the tile in the picture
  geometry::PixelBox box;  // pixels of the picture that may change, within the tile
};

/// Depth-tests triangles into a tile, in order: where a sample is covered and passes, depth (if the state writes it)
/// and slot are replaced.
/// @param entries     [count] indices into `triangles`
/// @param first_slot  slot of entries[0], the others follow; kNoSlot: depth alone, all slots stay
void cover(const core::SimdTarget& simd, const CoverArea& area, const DepthState& state,
           const geometry::ScreenTriangle* triangles, const uint32_t* entries, size_t count, uint32_t first_slot,
           Tile* tile);

/// Samples of each pixel that a triangle covers, as bits.
struct CoverMask {
  geometry::PixelBox box;  // of the tile; the others are not written
  alignas(64) uint32_t bits[kTilePixels];
};

/// Covered samples of one triangle whose depth passes against the tile's, or all of them if `compare` is
/// SHD_COMPARE_ALWAYS. The tile stays as it is.
void cover_mask(const core::SimdTarget& simd, const CoverArea& area, const DepthState& state,
                const geometry::ScreenTriangle& triangle, const Tile& tile, CoverMask* out);

}  // namespace shd::raster
