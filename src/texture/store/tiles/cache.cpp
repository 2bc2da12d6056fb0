// SPDX-License-Identifier: MIT
#include "texture/store/tiles/cache.h"

#include <new>

#include "texture/store/storage.h"
#include "texture/store/tiles/lease.h"

namespace shd::texture {
namespace {

/// Takes parts of a block of memory, one after another.
class Parts {
 public:
  explicit Parts(void* memory) : next_(static_cast<uint8_t*>(memory)) {}

  template <class T>
  T* take(size_t count) {
    T* const part = reinterpret_cast<T*>(next_);
    next_ += (count * sizeof(T) + core::kAlignment - 1) / core::kAlignment * core::kAlignment;
    return part;
  }
  template <class T>
  T* make(size_t count) {
    T* const part = take<T>(count);
    for (size_t i = 0; i < count; ++i) new (part + i) T();
    return part;
  }

 private:
  uint8_t* next_;
};

}  // namespace

TileCache* TileCache::create(const core::Allocator& allocator, const shd_tile_cache_desc& desc) {
  const TileBudget budget = divide_tile_budget(desc.budget_bytes, desc.tile_bytes);
  void* const memory = allocator.allocate(budget.bytes);
  try {
    return new (memory) TileCache(budget, desc);
  } catch (...) {
    allocator.free(memory, budget.bytes);
    throw;
  }
}

void TileCache::destroy(const core::Allocator& allocator, TileCache* cache) noexcept {
  const size_t bytes = cache->budget_.bytes;
  cache->~TileCache();
  allocator.free(cache, bytes);
}

TileCache::TileCache(const TileBudget& budget, const shd_tile_cache_desc& desc)
    : budget_(budget), budget_bytes_(desc.budget_bytes), tile_bytes_(desc.tile_bytes) {
  mutex_.attach();
  Parts parts(this);
  parts.take<TileCache>(1);
  slots_ = parts.make<TileSlot>(budget.slots);
  table_.attach(parts.make<TileTable::Entry>(budget.table_entries), budget.table_entries);
  requests_.attach(parts.make<TileRequest>(budget.requests), budget.requests);
  leases_ = parts.make<TileLease>(budget.leases);
  tiles_ = parts.take<uint8_t>(size_t{budget.slots} * tile_bytes_);
  for (uint32_t i = 0; i < budget.leases; ++i) {
    TileLease& lease = leases_[i];
    lease.cache = this;
    lease.spare_bytes = parts.take<uint8_t>(TileLease::kSpareBytes);
    lease.spare_offset = static_cast<uint32_t>(lease.spare_bytes - tiles_);
    lease.number = lease.kept = lease.now = 0;
    for (uint32_t e = 0; e < TileLease::kKept; ++e) {
      lease.tile[e] = TileLease::kNoTile;
      lease.turn[e] = 0;
    }
  }
  fork_hook_.attach(repair_in_child, this);  // the last step, because it reads slots and leases
}

void TileCache::add(TileSet* set) {
  const std::lock_guard<TileMutex> lock(mutex_);
  if (last_number_ == 0xfffffffe) core::refuse(SHD_ERROR_LIMIT, "texture.tiles.cache: it has had 2^32 textures");
  set->number = ++last_number_;
  set->next = sets_;
  sets_ = set;
}

uint32_t TileCache::read(TileKey key) {
  const uint32_t found = table_.find(key);
  if (found == TileTable::kNone) return found;
  TileSlot& slot = slots_[found];
  slot.readers.fetch_add(1, std::memory_order_seq_cst);
  if (slot.state.load(std::memory_order_seq_cst) == kSlotReady && slot.key.load(std::memory_order_relaxed) == key) {
    slot.recent.store(1, std::memory_order_relaxed);
    return found;
  }
  slot.readers.fetch_sub(1, std::memory_order_release);
  return TileTable::kNone;
}

bool TileCache::may_keep() {
  if (kept_.fetch_add(1, std::memory_order_relaxed) < budget_.kept_limit) return true;
  kept_.fetch_sub(1, std::memory_order_relaxed);
  return false;
}

void TileCache::request(const TileSet& set, const uint32_t* tiles, size_t count) {
  const std::lock_guard<TileMutex> lock(mutex_);
  for (size_t i = 0; i < count; ++i) requests_.add(set.key_of(tiles[i]));
}

void TileCache::get_stats(shd_tile_cache_stats* out) {
  const std::lock_guard<TileMutex> lock(mutex_);
  out->tile_bytes = tile_bytes_;
  out->budget_bytes = budget_bytes_;
  out->allocated_bytes = budget_.bytes;
  out->tile_count = budget_.slots;
  out->resident_tile_count = resident_;
  out->pinned_tile_count = pinned_;
  out->requested_tile_count = requests_.size();
  out->load_count = loads_;
  out->loaded_tile_count = loaded_;
  out->failed_tile_count = failed_;
  out->evicted_tile_count = evicted_;
  out->wait_count = waits_;
}

}  // namespace shd::texture
