// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "film/framebuffer.h"
#include "raster/fragments.h"
#include "raster/tile.h"
#include "shade/columns.h"

namespace shd::film {

/// Pixels of a tile that lie in the frame.
struct TileArea {
  uint32_t left, top;      // position in the frame
  uint32_t width, height;  // 1..kTile
};

TileArea tile_area(const Framebuffer& framebuffer, uint32_t tile, uint32_t tiles_x);

/// Colour and depth to the given values, AOVs to 0, triangles to kNoTriangle.
void clear_tile(const TileArea& area, const float color[4], float depth, Framebuffer* framebuffer);

/// Depth from the framebuffer, no triangles; outside the frame a depth that nothing passes.
void load_depth(const TileArea& area, const Framebuffer& framebuffer, raster::Tile* tile);
void store_depth(const TileArea& area, const raster::Tile& tile, Framebuffer* framebuffer);

/// Colour and AOVs of a shaded batch. Returns how many rows have a colour that is not finite.
size_t write_fragments(const TileArea& area, const raster::Fragments& fragments, const shade::Radiance& radiance,
                       Framebuffer* framebuffer);

}  // namespace shd::film
