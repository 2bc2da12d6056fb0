// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>

#include <shd/tile_cache.h>

#include "texture/tile/budget.h"
#include "texture/tile/requests.h"
#include "texture/tile/slot.h"
#include "texture/tile/table.h"
#include "texture/tile/tile.h"

namespace shd::texture {

struct TileLease;

/// Tiles of textures in memory of a fixed size. Any thread.
class TileCache {
 public:
  static constexpr uint32_t kMaxBatch = 16;

  /// Makes a cache of a checked desc, in one block of memory that begins with it. Throws std::bad_alloc.
  static TileCache* create(const core::Allocator& allocator, const shd_tile_cache_desc& desc);
  static void destroy(const core::Allocator& allocator, TileCache* cache) noexcept;

  /// Adds a texture and sets its number; throws Failure if the numbers are used up. It leaves with remove(), which
  /// waits for loads of its tiles.
  void add(TileSet* set);
  void remove(TileSet* set) noexcept;

  /// Counts the caller as a reader of a resident tile and returns its slot; TileTable::kNone if it is not resident.
  uint32_t read(TileKey key);
  void stop_reading(uint32_t slot) { slots_[slot].readers.fetch_sub(1, std::memory_order_release); }

  /// read(); loads the tile if it is not resident. Throws Failure.
  uint32_t read_or_load(const TileSet& set, uint32_t tile);

  /// Loads those of `count` tiles that are neither resident nor being loaded, and waits for those that are being
  /// loaded. Returns the number of tiles loaded. Throws Failure if a callback fails.
  uint32_t load(const TileSet& set, const uint32_t* tiles, size_t count);

  void request(const TileSet& set, const uint32_t* tiles, size_t count);
  /// Loads tiles that were requested, the latest first; max 0 = all. Returns their number.
  uint32_t load_requested(uint32_t max);

  /// A host's pins. pin() returns false if too many tiles are pinned; the tile is then not pinned.
  bool pin(const TileSet& set, uint32_t tile);
  bool is_pinned(const TileSet& set, uint32_t tile);
  void unpin(const TileSet& set, uint32_t tile);

  /// Drops the tiles for which matches(tile) is true, and loads those again that are pinned. Throws Failure if that
  /// fails; tiles that were not loaded again are not pinned any more.
  template <class Matches>
  void drop(const TileSet& set, Matches&& matches) {
    const uint32_t version = drops_.fetch_add(1, std::memory_order_acq_rel) + 1;
    for (uint32_t slot = 0; slot < budget_.slots; ++slot) {
      const TileKey key = slots_[slot].key.load(std::memory_order_relaxed);
      if (key >> 32 == set.number && matches(static_cast<uint32_t>(key))) drop_slot(set, slot, key, version);
    }
  }

  void get_stats(shd_tile_cache_stats* out);

  /// Lets a lease keep one more tile. Returns false if all leases keep enough.
  bool may_keep();
  void give_up(uint32_t tiles) { kept_.fetch_sub(tiles, std::memory_order_relaxed); }

  /// Returns a lease for a texture, as its latest call left it if that is free.
  TileLease* take_lease(const Texture& texture);
  void put_lease(TileLease* lease) noexcept;

  uint32_t drops() const { return drops_.load(std::memory_order_acquire); }
  uint8_t* tile_memory(uint32_t slot) const { return tiles_ + size_t{slot} * tile_bytes_; }
  uint8_t* tiles() const { return tiles_; }
  uint32_t tile_bytes() const { return tile_bytes_; }

 private:
  TileCache(const TileBudget& budget, const shd_tile_cache_desc& desc);
  ~TileCache() = default;

  /// Tiles that one call of a callback fills, and tiles that other threads load.
  struct Batch {
    uint32_t count = 0, others = 0;
    uint32_t tile[kMaxBatch], slot[kMaxBatch], other[kMaxBatch];
  };

  uint32_t load_some(const TileSet& set, const uint32_t* tiles, size_t count, uint32_t* read_slot);
  void find_missing(const TileSet& set, const uint32_t* tiles, size_t count, Batch* batch);
  shd_result fill(const TileSet& set, const Batch& batch) const;
  void publish(shd_result result, const Batch& batch, uint32_t* read_slot);
  TileSet* find_set(uint32_t number);
  bool add_pins(const TileSet& set, uint32_t tile, uint32_t pins, uint32_t limit);
  uint32_t claim(TileKey key);
  bool take(TileSlot* slot);
  void free(uint32_t slot);
  void drop_slot(const TileSet& set, uint32_t slot, TileKey key, uint32_t version);
  TileLease* try_lease(uint32_t number);

  const TileBudget budget_;
  const uint64_t budget_bytes_;
  const uint32_t tile_bytes_;
  uint8_t* tiles_;
  TileSlot* slots_;
  TileLease* leases_;
  TileTable table_;

  std::mutex mutex_;
  std::condition_variable changed_;  // a load ended, a lease became free, or a texture may leave
  TileRequests requests_;
  TileSet* sets_ = nullptr;
  uint32_t last_number_ = 0;
  uint32_t hand_ = 0;  // next slot of the clock
  uint32_t resident_ = 0, pinned_ = 0;
  uint64_t loads_ = 0, loaded_ = 0, failed_ = 0, evicted_ = 0, waits_ = 0;

  std::atomic<uint32_t> waiting_for_lease_{0};
  std::atomic<uint32_t> kept_{0};
  std::atomic<uint32_t> drops_{0};
};

}  // namespace shd::texture
