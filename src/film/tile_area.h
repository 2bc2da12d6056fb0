// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/simd_target.h"
#include "film/framebuffer.h"
#include "raster/tile.h"

namespace shd::film {

/// The pixels of a tile that lie in the framebuffer.
struct TileArea {
  uint32_t left, top;      // position in the framebuffer
  uint32_t width, height;  // 1..kTile
};

TileArea tile_area(const Framebuffer& framebuffer, uint32_t tile, uint32_t tiles_x);

void clear_depth(const TileArea& area, float depth, Framebuffer* framebuffer);
/// Sets the planes of AOVs to their empty values.
void clear_aovs(const TileArea& area, Framebuffer* framebuffer);

/// Sets every sample to the depth of its pixel in the framebuffer. Pixels outside the framebuffer keep their values.
void load_depth(const TileArea& area, const Framebuffer& framebuffer, raster::Tile* tile);
/// Writes the depth of the first sample of each pixel to the framebuffer.
void store_depth(const core::SimdTarget& simd, const TileArea& area, const raster::Tile& tile,
                 Framebuffer* framebuffer);

}  // namespace shd::film
