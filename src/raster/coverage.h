// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/simd_target.h"
#include "geometry/assemble.h"
#include "raster/tile.h"

namespace shd::raster {

/// Depth-tests triangles into a tile, in order: where a centre is covered and nearer, depth and slot are replaced.
/// @param entries     [count] indices into `triangles`
/// @param first_slot  slot of entries[0]; the others follow
/// @param left, top   pixel position of the tile in the frame, multiples of kTile
void cover(const core::SimdTarget& simd, const geometry::ScreenTriangle* triangles, const uint32_t* entries,
           size_t count, uint32_t first_slot, int32_t left, int32_t top, Tile* tile);

}  // namespace shd::raster
