// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/allocator.h"
#include "film/framebuffer.h"
#include "film/tile_color.h"
#include "raster/tile.h"

namespace shd::film {

/// Depth, colour and targets of every sample, kept between the passes of a frame with several samples per pixel.
class SampleStore {
 public:
  /// Allocates storage for `tiles` tiles, which may be 0: 4 bytes per sample, 16 per sample and target, and 1 per
  /// pixel.
  /// Throws std::bad_alloc.
  SampleStore(const core::Allocator& allocator, const Framebuffer& framebuffer, uint32_t tiles);

  bool is_empty() const { return is_saved_.size() == 0; }
  /// Restores the saved state of tile `index`; returns false if it was never saved. Threads may load and save different
  /// tiles concurrently.
  bool load(uint32_t index, raster::Tile* tile, SplitSamples* split) const;
  void save(uint32_t index, const raster::Tile& tile, const SplitSamples& split);

 private:
  const size_t depths_, colors_;   // elements per pixel
  core::Array<uint8_t> is_saved_;  // [tile]
  core::Array<float> depth_;       // [tile][kTilePixels][depths]
  core::Array<uint8_t> is_split_;  // [tile][kTilePixels]
  core::Array<float> color_;       // [tile][kTilePixels][colors], valid for split pixels
};

}  // namespace shd::film
