// SPDX-License-Identifier: MIT
// Loads of a TileCache: which tiles a thread loads, the call of the callback, and what becomes of failures.
#include <algorithm>
#include <cstring>

#include "core/status.h"
#include "texture/store/storage.h"
#include "texture/tile/cache.h"
#include "texture/tile/lease.h"

namespace shd::texture {
namespace {

/// The cache whose callback runs on this thread.
thread_local const TileCache* calling = nullptr;

class CallScope {
 public:
  explicit CallScope(const TileCache* cache) : before_(calling) { calling = cache; }
  ~CallScope() { calling = before_; }
  CallScope(const CallScope&) = delete;
  CallScope& operator=(const CallScope&) = delete;

 private:
  const TileCache* const before_;
};

[[noreturn]] void refuse_nested(const Texture& texture, uint32_t tile) {
  const shd_tile at = tile_at(texture, tile);
  core::refuse(SHD_ERROR_CALLBACK,
               "texture.tiles.load: it looks up the tile that it loads, level %u, layer %u, column %u, row %u",
               at.level, at.layer, at.x, at.y);
}

}  // namespace

void TileCache::find_missing(const TileSet& set, const uint32_t* tiles, size_t count, Batch* batch) {
  for (size_t i = 0; i < count; ++i) {
    const uint32_t found = table_.find(set.key_of(tiles[i]));
    if (found == TileTable::kNone) {
      batch->slot[batch->count] = claim(set.key_of(tiles[i]));
      batch->tile[batch->count++] = tiles[i];
    } else if (slots_[found].state.load(std::memory_order_relaxed) == kSlotLoading) {
      if (slots_[found].loader != std::this_thread::get_id()) {
        batch->other[batch->others++] = tiles[i];
      } else if (std::find(batch->tile, batch->tile + batch->count, tiles[i]) == batch->tile + batch->count) {
        refuse_nested(*set.texture, tiles[i]);
      }
    }
  }
}

shd_result TileCache::fill(const TileSet& set, const Batch& batch) const {
  shd_tile tiles[kMaxBatch];
  const size_t pitch = texel_size(*set.texture) << set.shape.shift_x;
  for (uint32_t i = 0; i < batch.count; ++i) {
    tiles[i] = tile_at(*set.texture, batch.tile[i]);
    tiles[i].texels = tile_memory(batch.slot[i]);
    tiles[i].row_stride = pitch;
  }
  const CallScope scope(this);
  char before[core::kErrorTextSize];
  std::memcpy(before, core::last_error(), std::strlen(core::last_error()) + 1);
  const shd_result result = set.source.load(set.source.user_data, tiles, batch.count);
  if (result == SHD_OK) return SHD_OK;
  char cause[core::kErrorTextSize];
  std::memcpy(cause, core::last_error(), std::strlen(core::last_error()) + 1);
  const bool has_cause = std::strcmp(before, cause) != 0;
  return core::fail(
      result == SHD_ERROR_CANCELLED ? result : SHD_ERROR_CALLBACK,
      "texture.tiles.load returned %s for %u tiles, the first at level %u, layer %u, column %u, row %u%s%s",
      shd_result_name(result), batch.count, tiles[0].level, tiles[0].layer, tiles[0].x, tiles[0].y,
      has_cause ? ": " : "", has_cause ? cause : "");
}

void TileCache::publish(shd_result result, const Batch& batch, uint32_t* read_slot) {
  for (uint32_t i = 0; i < batch.count; ++i) {
    TileSlot& slot = slots_[batch.slot[i]];
    if (result == SHD_OK) {
      ++loaded_;
    } else {
      ++failed_;
    }
    if (result != SHD_OK || slot.stale) {
      table_.remove(slot.key.load(std::memory_order_relaxed));
      free(batch.slot[i]);
      continue;
    }
    ++resident_;
    requests_.remove(slot.key.load(std::memory_order_relaxed));
    slot.recent.store(1, std::memory_order_relaxed);
    if (read_slot) {
      slot.readers.fetch_add(1, std::memory_order_relaxed);
      *read_slot = batch.slot[i];
    }
    slot.state.store(kSlotReady, std::memory_order_seq_cst);
  }
  if (batch.count) changed_.notify_all();
}

uint32_t TileCache::load_some(const TileSet& set, const uint32_t* tiles, size_t count, uint32_t* read_slot) {
  Batch batch;
  shd_result result = SHD_OK;
  std::unique_lock<std::mutex> lock(mutex_);
  try {
    find_missing(set, tiles, count, &batch);
    if (batch.count) {
      ++loads_;
      lock.unlock();
      result = fill(set, batch);
      lock.lock();
    }
  } catch (...) {  // a nested lookup, too many tiles in use, or an exception of the callback
    if (!lock.owns_lock()) lock.lock();
    publish(SHD_ERROR_CALLBACK, batch, nullptr);
    throw;
  }
  publish(result, batch, read_slot);
  if (result != SHD_OK) throw core::Failure(result, core::last_error());
  for (uint32_t i = 0; i < batch.others; ++i) {
    ++waits_;
    changed_.wait(lock, [&] {
      const uint32_t slot = table_.find(set.key_of(batch.other[i]));
      return slot == TileTable::kNone || slots_[slot].state.load(std::memory_order_relaxed) != kSlotLoading;
    });
  }
  return batch.count;
}

uint32_t TileCache::load(const TileSet& set, const uint32_t* tiles, size_t count) {
  uint32_t loaded = 0;
  for (size_t first = 0; first < count; first += budget_.load_batch) {
    loaded += load_some(set, tiles + first, std::min<size_t>(budget_.load_batch, count - first), nullptr);
  }
  return loaded;
}

TileSet* TileCache::find_set(uint32_t number) {
  TileSet* set = sets_;
  while (set && set->number != number) set = set->next;
  return set;
}

uint32_t TileCache::load_requested(uint32_t max) {
  uint32_t loaded = 0;
  for (uint32_t taken = 0; max == 0 || taken < max;) {
    uint32_t tiles[kMaxBatch], count = 0;
    TileSet* set = nullptr;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      const TileKey latest = requests_.take_latest(0);
      if (latest == 0) break;
      const auto number = static_cast<uint32_t>(latest >> 32);
      set = find_set(number);
      for (TileKey key = latest; key; key = requests_.take_latest(number)) {
        tiles[count++] = static_cast<uint32_t>(key);
        if (++taken == max || count == kMaxBatch) break;
      }
      ++set->loading;
    }
    // The texture stays until `loading` is 0.
    struct Scope {
      TileCache& cache;
      TileSet& set;
      ~Scope() {
        const std::lock_guard<std::mutex> lock(cache.mutex_);
        --set.loading;
        cache.changed_.notify_all();
      }
    } const scope{*this, *set};
    const TileLeaseScope lease(*set->texture);
    loaded += load(*set, tiles, count);
  }
  return loaded;
}

TileLease* TileCache::try_lease(uint32_t number) {
  for (const uint32_t wanted : {number, 0u, TileLease::kNoTile}) {
    for (uint32_t i = 0; i < budget_.leases; ++i) {
      TileLease& lease = leases_[i];
      if (wanted != TileLease::kNoTile && lease.last_number.load(std::memory_order_relaxed) != wanted) continue;
      if (!lease.used.load(std::memory_order_relaxed) && !lease.used.exchange(true, std::memory_order_seq_cst)) {
        return &lease;
      }
    }
  }
  return nullptr;
}

TileLease* TileCache::take_lease(const Texture& texture) {
  const uint32_t number = texture.tiles->number;
  TileLease* lease = try_lease(number);
  if (!lease) {
    if (calling == this) {
      core::refuse(SHD_ERROR_LIMIT, "texture.tiles.load: it looks up a texture of its own cache while %u calls use it",
                   budget_.leases);
    }
    std::unique_lock<std::mutex> lock(mutex_);
    waiting_for_lease_.fetch_add(1, std::memory_order_seq_cst);
    changed_.wait(lock, [&] { return (lease = try_lease(number)) != nullptr; });
    waiting_for_lease_.fetch_sub(1, std::memory_order_relaxed);
  }
  const uint32_t drops = this->drops();
  if (lease->number != number || lease->version != drops) lease->clear();
  const size_t size = texel_size(texture);
  lease->number = number;
  lease->last_number.store(number, std::memory_order_relaxed);
  lease->version = drops;
  lease->texture = &texture;
  lease->origin = tiles_;
  lease->tile_texels = static_cast<uint32_t>(tile_bytes_ / size);
  lease->spare = static_cast<int32_t>(lease->spare_offset / size);
  lease->lookup = 0;
  lease->needed = nullptr;
  return lease;
}

void TileCache::put_lease(TileLease* lease) noexcept {
  lease->used.store(false, std::memory_order_seq_cst);
  if (waiting_for_lease_.load(std::memory_order_seq_cst) == 0) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  changed_.notify_all();
}

bool TileCache::add_pins(const TileSet& set, uint32_t tile, uint32_t pins, uint32_t limit) {
  for (;;) {
    const uint32_t found = read_or_load(set, tile);
    const std::lock_guard<std::mutex> lock(mutex_);
    stop_reading(found);
    TileSlot& slot = slots_[found];
    const bool dropped = slot.state.load(std::memory_order_relaxed) == kSlotDropped;
    if (dropped || slot.key.load(std::memory_order_relaxed) != set.key_of(tile)) continue;
    if (slot.pins == 0) {
      if (pinned_ >= limit) return false;
      ++pinned_;
    }
    slot.pins += pins;
    return true;
  }
}

bool TileCache::pin(const TileSet& set, uint32_t tile) {
  return add_pins(set, tile, 1, budget_.pinned_limit);
}

bool TileCache::is_pinned(const TileSet& set, uint32_t tile) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const uint32_t found = table_.find(set.key_of(tile));
  return found != TileTable::kNone && slots_[found].pins != 0;
}

void TileCache::unpin(const TileSet& set, uint32_t tile) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const uint32_t found = table_.find(set.key_of(tile));
  if (found == TileTable::kNone || slots_[found].pins == 0) return;
  if (--slots_[found].pins == 0) --pinned_;
}

void TileCache::drop_slot(const TileSet& set, uint32_t found, TileKey key, uint32_t version) {
  TileSlot& slot = slots_[found];
  const auto tile = static_cast<uint32_t>(key);
  uint32_t pins = 0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (slot.key.load(std::memory_order_relaxed) != key || slot.version >= version) return;
    if (slot.state.load(std::memory_order_relaxed) == kSlotLoading) slot.stale = true;
    if (slot.state.load(std::memory_order_relaxed) != kSlotReady) return;
    pins = slot.pins;
    if (pins) --pinned_;
    slot.pins = 0;
    table_.remove(key);
    --resident_;
    slot.key.store(0, std::memory_order_relaxed);
    slot.state.store(kSlotDropped, std::memory_order_seq_cst);
  }
  if (pins != 0) add_pins(set, tile, pins, budget_.slots);
}

}  // namespace shd::texture
