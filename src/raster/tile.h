// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace shd::raster {

/// Tiles are kTile x kTile pixels, on a grid that starts at the top left corner of the frame: depth and triangle
/// of a tile take 32 KB, and its fragment columns stay in L2.
constexpr int32_t kTileBits = 6;
constexpr int32_t kTile = 1 << kTileBits;
constexpr size_t kTilePixels = size_t{kTile} * kTile;

constexpr uint32_t kNoSlot = 0xffffffffu;

/// Depth and nearest triangle of the pixels of one tile, row by row.
struct Tile {
  alignas(64) float depth[kTilePixels];
  alignas(64) uint32_t slot[kTilePixels];  // position in the tile's list of triangles, or kNoSlot
};

constexpr uint32_t tile_count(uint32_t pixels) {
  return (pixels + kTile - 1) / kTile;
}

}  // namespace shd::raster
