// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "core/allocator.h"

namespace shd::raster {

/// Tiles are kTile x kTile pixels, on a grid that starts at the top left corner of the framebuffer. Depth and triangle
/// of a tile take 32 KB per sample, and the fragment columns of a tile stay in L2.
constexpr int32_t kTileBits = 6;
constexpr int32_t kTile = 1 << kTileBits;
constexpr size_t kTilePixels = size_t{kTile} * kTile;

constexpr uint32_t kNoSlot = 0xffffffffu;

/// Depths are bounded in blocks of kBlock x kBlock pixels.
constexpr int32_t kBlockBits = 3;
constexpr int32_t kBlock = 1 << kBlockBits;
constexpr int32_t kBlocksPerRow = kTile / kBlock;

/// Direction in which the depths of a tile have changed since its bounds were found: only smaller depths passed, or
/// only larger ones.
enum class DepthTrend { kUnknown, kFalling, kRising };

/// Hierarchical depth: no depth of a block lies beyond its bound, so that a triangle that cannot pass is rejected
/// before its samples are visited. A bound stays valid while depths follow the trend. A bound that rejects nothing is
/// recomputed.
struct DepthBounds {
  DepthTrend trend;
  float bound[kBlocksPerRow * kBlocksPerRow];  // largest depth if falling, smallest if rising
};

/// A range that contains depths.
struct DepthRange {
  float low, high;
};
constexpr DepthRange kAnyDepths = {-std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity()};

/// Depth and visible triangle of every sample of one tile, pixels row by row.
struct Tile {
  uint32_t samples = 0;
  core::Array<float> depth;    // [kTilePixels][samples] never NaN
  core::Array<uint32_t> slot;  // [kTilePixels][samples] index into the tile's list of triangles; kNoSlot between tiles
  uint32_t sole_slot = kNoSlot;   // if not kNoSlot, the slot of all samples; all elements of `slot` are kNoSlot then
  DepthRange range = kAnyDepths;  // contains all depths; kAnyDepths once single samples were drawn
  DepthBounds bounds;
};

/// Must be called before single samples are drawn: writes the sole slot to all of them.
inline void begin_samples(Tile* tile) {
  tile->range = kAnyDepths;
  if (tile->sole_slot != kNoSlot) std::fill(tile->slot.begin(), tile->slot.end(), tile->sole_slot);
  tile->sole_slot = kNoSlot;
}

/// Throws std::bad_alloc.
inline void allocate(const core::Allocator& allocator, uint32_t samples, Tile* out) {
  out->samples = samples;
  out->depth = core::Array<float>(allocator, samples * kTilePixels);
  out->depth.fill_zero();  // the bounds also read pixels outside the frame
  out->slot = core::Array<uint32_t>(allocator, samples * kTilePixels);
  std::fill(out->slot.begin(), out->slot.end(), kNoSlot);
}

/// Must be called after depths of a tile were written without regard to the trend.
inline void forget_bounds(Tile* tile) {
  tile->bounds.trend = DepthTrend::kUnknown;
  tile->range = kAnyDepths;
}

constexpr uint32_t tile_count(uint32_t pixels) {
  return (pixels + kTile - 1) / kTile;
}

}  // namespace shd::raster
