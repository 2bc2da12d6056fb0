// SPDX-License-Identifier: MIT
#pragma once

#include "frame/tile_state.h"
#include "raster/fragments.h"
#include "raster/texture_places.h"

namespace shd::frame {

/// Draws pixels of one triangle whose colour is one lookup, without the table of fragments. Where the rows of the
/// tile's colour are consecutive, lookups write into them.
class TextureBatch {
 public:
  explicit TextureBatch(TileState* tile) : tile_(*tile) {}

  /// Lets pixels go to the framebuffer, and not to the tile's colour, if all that are visible are of such materials and
  /// the framebuffer has interleaved pixels of one sample. Returns whether they go there.
  bool begin_direct();

  /// Draws the runs that cover all samples, if the draw is of such a material and the triangle has enough pixels.
  /// Returns the number of other runs, which are moved to the front.
  size_t draw(const geometry::ScreenTriangle& triangle, raster::PixelRun* runs, size_t count);

 private:
  /// Whether the colour of a draw is one lookup, and no further planes are wanted.
  bool takes(uint32_t draw);
  /// Whether all visible pixels of the tile are of such materials, in triangles with enough pixels.
  bool takes_all();
  /// Draws the pixels of the triangle in a cell.
  void draw_cell(const geometry::ScreenTriangle& triangle, const raster::Cell& cell, const raster::PixelRun* runs,
                 size_t count);
  /// Adds the pixels of a run that lie in a cell.
  void add_in_cell(const raster::PixelRun& run, const raster::Cell& cell);
  void add(const raster::PixelRun& pixels);
  /// Shades the rows and empties the batch.
  void flush();

  TileState& tile_;
  BatchRuns runs_;
  raster::TrianglePlanes planes_;  // planes of the triangle that is drawn, in one cell
  size_t rows_ = 0;
  uint32_t draw_ = ~0u;  // the latest draw
  bool takes_ = false;   // whether its colour is one lookup
  bool direct_ = false;  // pixels go to the framebuffer
  alignas(64) uint32_t pixels_[raster::kBatch];
};

}  // namespace shd::frame
