// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/allocator.h"

namespace shd::raster {

/// Tiles are kTile x kTile pixels, on a grid that starts at the top left corner of the framebuffer: depth and triangle
/// of a tile take 32 KB a sample, and its fragment columns stay in L2.
constexpr int32_t kTileBits = 6;
constexpr int32_t kTile = 1 << kTileBits;
constexpr size_t kTilePixels = size_t{kTile} * kTile;

constexpr uint32_t kNoSlot = 0xffffffffu;

/// Depths are bounded in blocks of kBlock x kBlock pixels.
constexpr int32_t kBlockBits = 3;
constexpr int32_t kBlock = 1 << kBlockBits;
constexpr int32_t kBlocksPerRow = kTile / kBlock;

/// Which way the depths of a tile went since its bounds were found: comparisons that let smaller ones pass, or larger
/// ones.
enum class DepthTrend { kUnknown, kFalling, kRising };

/// Hierarchical depth: what no depth of a block lies beyond, so that a triangle that cannot pass is dropped before its
/// samples are looked at. A bound stays true while depths follow the trend, and is found anew where it does not help.
struct DepthBounds {
  DepthTrend trend;
  float bound[kBlocksPerRow * kBlocksPerRow];  // largest depth if falling, smallest if rising
};

/// Depth and visible triangle of every sample of one tile, pixels row by row.
struct Tile {
  uint32_t samples = 0;
  core::Array<float> depth;    // [kTilePixels][samples]
  core::Array<uint32_t> slot;  // [kTilePixels][samples] position in the tile's list of triangles, or kNoSlot
  DepthBounds bounds;
};

/// Throws std::bad_alloc.
inline void allocate(const core::Allocator& allocator, uint32_t samples, Tile* out) {
  out->samples = samples;
  out->depth = core::Array<float>(allocator, samples * kTilePixels);
  out->depth.fill_zero();  // bounds look at pixels outside the frame too
  out->slot = core::Array<uint32_t>(allocator, samples * kTilePixels);
}

/// Depths of a tile were written in any way.
inline void forget_bounds(Tile* tile) {
  tile->bounds.trend = DepthTrend::kUnknown;
}

constexpr uint32_t tile_count(uint32_t pixels) {
  return (pixels + kTile - 1) / kTile;
}

}  // namespace shd::raster
