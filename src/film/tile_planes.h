// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "core/allocator.h"
#include "core/simd_target.h"
#include "film/framebuffer.h"
#include "film/tile_area.h"

namespace shd::film {

/// Planes of colour, r, g, b and a, from the first pixel of a tile on.
struct TilePlanes {
  float* plane[4];
  size_t stride;  // elements between rows
};

/// Whether tiles are drawn in planes of their own: those of framebuffers with interleaved pixels, and of large ones,
/// which are written once.
inline bool has_color_block(const Framebuffer& framebuffer) {
  return !has_color_planes(framebuffer) || framebuffer.is_large;
}

/// The planes of a tile that is drawn apart from its framebuffer.
class ColorBlock {
 public:
  /// Allocates memory if has_color_block(). Throws std::bad_alloc.
  void allocate(const core::Allocator& allocator, const Framebuffer& framebuffer);
  /// The planes in which the tile is drawn: those of the framebuffer unless has_color_block().
  TilePlanes planes(const TileArea& area, Framebuffer* framebuffer);

 private:
  core::Array<float> planes_;  // [4][kTilePixels]
};

/// The planes first..first + 3 of the framebuffer.
TilePlanes planes_of(const TileArea& area, uint32_t first, Framebuffer* framebuffer);

/// Fills a part of a tile. `part` lies in `area`, both in pixels of the framebuffer.
void fill_color(const TileArea& area, const TileArea& part, const float color[4], const TilePlanes& planes);

/// Fills a run of pixels of a tile, except those outside `area`.
void fill_color(const TileArea& area, const raster::PixelRun& run, const float color[4], const TilePlanes& planes);

/// Reads the colour of a tile from the framebuffer, and writes that of a part of it, if has_color_block().
void load_color(const TileArea& area, const Framebuffer& framebuffer, const TilePlanes& planes);
void store_color(const core::SimdTarget& simd, const TileArea& area, const TileArea& part, const TilePlanes& planes,
                 Framebuffer* framebuffer);

/// Writes a run of pixels of a tile whose framebuffer has interleaved pixels of 4 bytes.
void store_pixels(const core::SimdTarget& simd, const TileArea& area, const raster::PixelRun& run,
                  const uint32_t* pixels, Framebuffer* framebuffer);
/// Encodes a run of pixels of a tile whose framebuffer has interleaved pixels. `plane`: r, g, b and a of the run.
void store_pixels(const core::SimdTarget& simd, const TileArea& area, const raster::PixelRun& run,
                  const float* const plane[4], Framebuffer* framebuffer);

}  // namespace shd::film
