// SPDX-License-Identifier: MIT
/// @file
/// Contract of store/bc/: textures whose memory holds compressed blocks.
///
/// Filters emit the level, column and row of each texel, as for any store. Before a stream is consumed, place.cpp finds
/// the places of its texels in a cache of decoded blocks, and decodes the blocks that are missing.
///
/// | file           | contents                                    |
/// |----------------|---------------------------------------------|
/// | levels.h, .cpp | blocks of levels in memory, and as a store  |
/// | cache.h, .cpp  | decoded blocks, kept between calls          |
/// | place.cpp      | texels of a stream to places in a cache     |
/// | place_rows.cpp | rows of quads to places in a cache          |
/// | windows-inl.h  | blocks side by side in a cache              |
///
/// A cache is four rows of texels in memory, each block 4 x 4 of them at one place along the rows.
/// Blocks that are neighbours in a row of blocks have neighbouring places. Neighbouring texels are therefore neighbours
/// in memory, as in a level of a texture without blocks.
///
/// A block has one place. The rows of blocks begin at places far apart, by the golden section (Knuth, "The Art of
/// Computer Programming", volume 3 (1998), 6.4), so that a walk in any direction of a level uses all its places. Levels
/// alternate between the halves of the cache, so that two adjacent levels of a lookup do not evict each other.
#pragma once

#include "core/cache_pool.h"
#include "texture/store/bc/levels.h"
#include "texture/stream.h"
#include "texture/texture.h"

namespace shd::texture {

struct BcCache {
  static constexpr uint32_t kMaxPlaces = 4096;
  static constexpr uint32_t kSpare = 4 * 256;  // texels of a stream
  static constexpr uint32_t kMargin = 16;      // texels; rows a power of two apart would alias in the first-level cache
  static constexpr uint32_t kRowStep = 2531;   // places between rows of blocks: kMaxPlaces times the golden section
  static constexpr uint32_t kUnused = 0xffffffff;
  static constexpr uint32_t kAfter = 16;  // entries after those of the places: vectors may read and rewrite them

  uint8_t* texels;
  uint32_t* block;  // block at each place, or kUnused
  uint32_t* turn;   // latest stream that reads the place
  uint32_t places;  // power of two
  uint32_t pitch;   // texels between rows
  uint32_t spare;   // first of kSpare texels outside of the places
  uint32_t now;     // number of the stream that is placed

  /// Returns 0 or 1, in turn for the levels of a texture of this width [texels].
  static uint32_t parity_of(uint32_t width) { return static_cast<uint32_t>(31 - __builtin_clz(width)) & 1; }

  /// Returns the place of block (0, 0) of a level with its first block and its width in texels.
  uint32_t zeroth_place(uint32_t first, uint32_t width) const {
    const uint32_t half = places / 2;
    return ((first * 0x9e3779b1u >> 20) & (half - 1)) + parity_of(width) * half;
  }
  /// Returns the place of the block in column x and row y of a level.
  uint32_t place_of(uint32_t x, uint32_t y, uint32_t zeroth) const {
    const uint32_t half = places / 2;
    return ((x + y * kRowStep + zeroth) & (half - 1)) + (zeroth & half);
  }
};

/// The cache of one call: memory of the context's pool, or few places on the stack if the pool has none.
class CacheLease {
 public:
  explicit CacheLease(const Texture& texture);
  ~CacheLease();
  CacheLease(const CacheLease&) = delete;
  CacheLease& operator=(const CacheLease&) = delete;

  BcCache* cache() const { return cache_; }
  const Texture& texture() const { return texture_; }
  StreamPlaces* places() { return &places_; }

 private:
  static constexpr uint32_t kFewPlaces = 16, kLargestTexel = 8;
  static constexpr size_t kFewBytes =
      (4 * (4 * kFewPlaces + BcCache::kMargin) + BcCache::kSpare) * kLargestTexel + SHD_TEXTURE_PADDING;

  const Texture& texture_;
  StreamPlaces places_;
  core::CachePool* const pool_;
  core::CachePool::Lease lease_;
  BcCache* cache_;
  BcCache few_;
  uint32_t few_block_[kFewPlaces + BcCache::kAfter], few_turn_[kFewPlaces + BcCache::kAfter];
  alignas(64) uint8_t few_texels_[kFewBytes];
};

}  // namespace shd::texture
