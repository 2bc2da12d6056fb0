// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "film/blend.h"
#include "film/framebuffer.h"
#include "raster/fragments.h"
#include "raster/tile.h"
#include "shade/columns.h"

namespace shd::film {

/// Pixels of a tile that lie in the framebuffer.
struct TileArea {
  uint32_t left, top;      // position in the framebuffer
  uint32_t width, height;  // 1..kTile
};

TileArea tile_area(const Framebuffer& framebuffer, uint32_t tile, uint32_t tiles_x);

/// Colour and depth of pixels to the given values, the other planes empty.
void clear_area(const TileArea& area, const float color[4], float depth, Framebuffer* framebuffer);

void clear_slots(raster::Tile* tile);

/// Depth from the framebuffer for every sample, no triangles. Pixels outside the frame are left as they are.
void load_depth(const TileArea& area, const Framebuffer& framebuffer, raster::Tile* tile);
/// That of the first sample.
void store_depth(const TileArea& area, const raster::Tile& tile, Framebuffer* framebuffer);

/// Colour from the framebuffer for every one of several samples.
/// @param color  [kTilePixels][samples][4]
void load_color(const TileArea& area, const Framebuffer& framebuffer, uint32_t samples, float* color);
/// Plain averages to the framebuffer; samples that are all the same stay what they are, to the bit.
void resolve_color(const TileArea& area, const float* color, uint32_t samples, Framebuffer* framebuffer);

/// Colour of a shaded batch to the samples that show it. Returns how many rows have one that is not finite.
size_t write_fragments(const raster::Fragments& fragments, const shade::Radiance& radiance, const SampleColor* colors,
                       uint32_t samples);

}  // namespace shd::film
