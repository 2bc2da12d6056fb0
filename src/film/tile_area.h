// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "film/framebuffer.h"
#include "raster/tile.h"

namespace shd::film {

/// Pixels of a tile that lie in the framebuffer.
struct TileArea {
  uint32_t left, top;      // position in the framebuffer
  uint32_t width, height;  // 1..kTile
};

TileArea tile_area(const Framebuffer& framebuffer, uint32_t tile, uint32_t tiles_x);

void clear_color(const TileArea& area, const float color[4], Framebuffer* framebuffer);
void clear_depth(const TileArea& area, float depth, Framebuffer* framebuffer);
/// The planes of AOVs, empty.
void clear_aovs(const TileArea& area, Framebuffer* framebuffer);

void clear_slots(raster::Tile* tile);

/// One depth for all samples.
void fill_depth(float depth, raster::Tile* tile);
/// Depth from the framebuffer for every sample. Pixels outside the frame are left as they are.
void load_depth(const TileArea& area, const Framebuffer& framebuffer, raster::Tile* tile);
/// That of the first sample.
void store_depth(const TileArea& area, const raster::Tile& tile, Framebuffer* framebuffer);

}  // namespace shd::film
