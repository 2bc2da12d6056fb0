// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "raster/coverage.h"
#include "raster/tile.h"
#include "raster/triangle_setup.h"

namespace shd::raster {

// cover() and cover_mask() for a triangle that is not narrow: sample by sample, with edge functions in int64. Few
// triangles are not narrow: only those with an edge of more than 16384 pixels that crosses the tile.
/// @param slot  slot of the triangle; kNoSlot: only depth is written
void cover_wide(const TriangleSetup& triangle, const DepthState& state, uint32_t slot, Tile* tile);

void mask_wide(const TriangleSetup& triangle, const DepthState& state, const Tile& tile, CoverMask* out);

}  // namespace shd::raster
