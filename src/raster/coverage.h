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

/// Depth-tests triangles into a tile, in order. Where a sample is covered and passes, its slot is replaced, and its
/// depth if the state writes depth.
/// @param entries     [count] indices into `triangles`
/// @param first_slot  slot of entries[0]; entries[i] gets first_slot + i; kNoSlot: only depth is written
void cover(const core::SimdTarget& simd, const CoverArea& area, const DepthState& state,
           const geometry::ScreenTriangle* triangles, const uint32_t* entries, size_t count, uint32_t first_slot,
           Tile* tile);

/// The samples that a triangle covers, as bits for each pixel.
struct CoverMask {
  geometry::PixelBox box;  // pixels of the tile that are set; the others are not written
  alignas(64) uint32_t bits[kTilePixels];
};

/// Samples of one triangle that are covered and whose depth passes against the tile's depth; all covered samples if
/// `compare` is SHD_COMPARE_ALWAYS. Does not change the tile.
void cover_mask(const core::SimdTarget& simd, const CoverArea& area, const DepthState& state,
                const geometry::ScreenTriangle& triangle, const Tile& tile, CoverMask* out);

}  // namespace shd::raster
