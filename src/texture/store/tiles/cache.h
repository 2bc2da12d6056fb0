// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>

#include <shd/tile_cache.h>

#include "core/fork.h"
#include "texture/store/tiles/budget.h"
#include "texture/store/tiles/load.h"
#include "texture/store/tiles/requests.h"
#include "texture/store/tiles/slot.h"
#include "texture/store/tiles/sync.h"
#include "texture/store/tiles/table.h"
#include "texture/store/tiles/tile.h"

namespace shd::texture {

struct TileLease;

/// Tiles of textures in memory of a fixed size. Any thread. tile.h has the rules of waiting.
class TileCache {
 public:
  /// Makes a cache of a checked desc, in one block of memory that begins with it. Throws std::bad_alloc.
  static TileCache* create(const core::Allocator& allocator, const shd_tile_cache_desc& desc);
  static void destroy(const core::Allocator& allocator, TileCache* cache) noexcept;

  /// Adds a texture and sets its number; throws Failure if the numbers are used up. It leaves with remove(), when no
  /// call uses it any more.
  void add(TileSet* set);
  void remove(TileSet* set) noexcept;

  /// Counts the caller as a reader of a resident tile and returns its slot; TileTable::kNone if it is not resident.
  uint32_t read(TileKey key);
  void stop_reading(uint32_t slot) { slots_[slot].readers.fetch_sub(1, std::memory_order_release); }

  /// Brings at least one of `count` > 0 different tiles, in ascending order. Returns the number of tiles in `held`, at
  /// most kMaxTileBatch, which the caller reads. Calls callbacks and waits: the caller holds no lease and reads
  /// nothing. Adds the tiles that it loaded to *loaded. Throws Failure if a callback fails.
  uint32_t fetch(const TileSet& set, const uint32_t* tiles, size_t count, TileHold* held, uint32_t* loaded);

  /// Loads those of `count` tiles that are not resident, as fetch(). Returns the number of tiles loaded.
  uint32_t load(const TileSet& set, const uint32_t* tiles, size_t count);

  void request(const TileSet& set, const uint32_t* tiles, size_t count);
  /// Loads tiles that were requested, the latest first; max 0 = all. Returns their number.
  uint32_t load_requested(uint32_t max);

  /// A host's pins, which belong to the key. pin() loads the tile. It returns false if too many tiles are pinned, or
  /// throws Failure; the tile is then not pinned by it.
  bool pin(const TileSet& set, uint32_t tile);
  bool is_pinned(const TileSet& set, uint32_t tile);
  void unpin(const TileSet& set, uint32_t tile);

  /// Drops the tiles for which matches(tile) is true, then loads those that are pinned. Throws Failure if a load fails;
  /// the tile stays pinned, and the next call that needs it loads it.
  template <class Matches>
  void drop(const TileSet& set, Matches&& matches) {
    const uint32_t version = drops_.fetch_add(1, std::memory_order_acq_rel) + 1;
    for_each_slot(set, matches, [&](uint32_t slot, TileKey key) { drop_slot(slot, key, version); });
    for_each_slot(set, matches, [&](uint32_t slot, TileKey key) {
      const auto tile = static_cast<uint32_t>(key);
      if (slots_[slot].state.load(std::memory_order_relaxed) == kSlotEmpty) load(set, &tile, 1);
    });
  }

  void get_stats(shd_tile_cache_stats* out);

  /// Lets a lease keep one more tile. Returns false if all leases keep enough.
  bool may_keep();
  void give_up(uint32_t tiles) { kept_.fetch_sub(tiles, std::memory_order_relaxed); }

  /// Returns a lease for a texture, as its latest call left it if that is free. Waits while all are in use.
  TileLease* take_lease(const Texture& texture);
  void put_lease(TileLease* lease) noexcept;

  uint32_t drops() const { return drops_.load(std::memory_order_acquire); }
  uint8_t* tile_memory(uint32_t slot) const { return tiles_ + size_t{slot} * tile_bytes_; }
  uint8_t* tiles() const { return tiles_; }
  uint32_t tile_bytes() const { return tile_bytes_; }

 private:
  TileCache(const TileBudget& budget, const shd_tile_cache_desc& desc);
  ~TileCache() = default;

  using Lock = std::unique_lock<TileMutex>;

  template <class Matches, class Body>
  void for_each_slot(const TileSet& set, Matches& matches, Body&& body) {
    for (uint32_t slot = 0; slot < budget_.slots; ++slot) {
      const TileKey key = slots_[slot].key.load(std::memory_order_relaxed);
      if (key >> 32 == set.number && matches(static_cast<uint32_t>(key))) body(slot, key);
    }
  }

  // load.cpp
  uint32_t fetch_or_pin(const TileSet& set, const uint32_t* tiles, size_t count, TileHold* held, uint32_t* loaded,
                        bool* to_pin);
  uint32_t hold_ready(const TileSet& set, const uint32_t* tiles, size_t count, TileHold* held);
  void choose(const uint32_t* tiles, size_t count, bool again, TileLoad* load);
  void choose_again(const uint32_t* tiles, size_t count, TileLoad* load);
  bool take_slots(Lock* lock, TileWait* wait, TileLoad* load);
  bool is_admitted(const TileWait& wait, TileLoad* load);
  bool run(Lock* lock, TileWait* wait, TileLoad* load);
  shd_result call(TileLoad* load) const;
  void wait_for_change(TileWait* wait, const TileLoad& load);
  void wait_in_callback(TileWait* wait, const TileLoad& load);
  [[noreturn]] void refuse_full(const TileLoad& load) const;
  TileSet* find_set(uint32_t number);

  // slots.cpp, under the mutex
  template <class Change>
  void update(uint32_t slot, Change&& change);
  uint32_t claim(TileWait* wait);
  bool begin_load(TileKey key, TileWait* wait, uint32_t* slot);
  void end_load(uint32_t slot, bool succeeded);
  void let_go(uint32_t slot);
  void add_pin(uint32_t slot, bool* to_pin);
  void move_pins(uint32_t from, uint32_t to);
  void drop_slot(uint32_t slot, TileKey key, uint32_t version);

  TileLease* try_lease(uint32_t number);
  void clear_leases(uint32_t number);

  // fork.cpp
  static void repair_in_child(void* cache) noexcept;
  void repair_loads() noexcept;
  void repair_readers() noexcept;

  /// Slots that loads can have: neither pinned, nor kept by leases.
  uint32_t room() const { return budget_.slots - pinned_ - budget_.kept_limit; }
  SlotState state_of(uint32_t slot) const {
    return static_cast<SlotState>(slots_[slot].state.load(std::memory_order_relaxed));
  }

  const TileBudget budget_;
  const uint64_t budget_bytes_;
  const uint32_t tile_bytes_;
  uint8_t* tiles_;
  TileSlot* slots_;
  TileLease* leases_;
  TileTable table_;

  TileMutex mutex_;
  core::ForkHook fork_hook_;
  TileCondition changed_;     // a load or a pin ended
  TileCondition lease_free_;  // a lease became free
  TileRequests requests_;
  TileSet* sets_ = nullptr;
  uint32_t last_number_ = 0;
  uint32_t hand_ = 0;  // next slot of the clock
  uint32_t resident_ = 0, pinned_ = 0;
  uint32_t loading_ = 0;             // slots that are loading and not pinned
  TileLoad* running_ = nullptr;      // callbacks that run
  uint32_t callbacks_ = 0;           // their number
  uint32_t stuck_ = 0;               // callbacks with a call inside them that waits for a slot
  uint32_t outermost_ = 0;           // tiles of the callbacks that run in no other callback
  const TileWait* alone_ = nullptr;  // the call that lets no other outermost callback run
  uint64_t loads_ = 0, ended_ = 0, loaded_ = 0, failed_ = 0, evicted_ = 0, waits_ = 0;

  TileAtomic<uint32_t> waiting_for_lease_{0};
  TileAtomic<uint32_t> kept_{0};
  TileAtomic<uint32_t> drops_{0};
};

}  // namespace shd::texture
