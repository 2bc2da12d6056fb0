// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/simd_target.h"
#include "geometry/assemble.h"
#include "raster/depth_test.h"
#include "raster/tile.h"
#include "raster/triangle_setup.h"

namespace shd::raster {

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
