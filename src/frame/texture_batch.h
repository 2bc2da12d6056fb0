// SPDX-License-Identifier: MIT
#pragma once

#include "frame/tile_state.h"
#include "raster/fragments.h"

namespace shd::frame {

/// Draws pixels of one triangle whose colour is one lookup, without the table of fragments. Where the rows of the
/// tile's colour are consecutive, lookups write into them.
class TextureBatch {
 public:
  explicit TextureBatch(TileState* tile) : tile_(*tile) {}

  /// Draws those runs that may be drawn so. Returns the number of the others, moved to the front.
  size_t draw(const geometry::ScreenTriangle& triangle, raster::PixelRun* runs, size_t count);

 private:
  bool takes(uint32_t draw);
  void flush(const geometry::ScreenTriangle& triangle);

  TileState& tile_;
  BatchRuns runs_;
  size_t rows_ = 0;
  uint32_t draw_ = ~0u;  // the latest draw
  bool takes_ = false;   // whether its colour is one lookup
};

}  // namespace shd::frame
