// SPDX-License-Identifier: MIT
// Loads of a TileCache: which tiles a call loads, what it waits for, the callback, and what becomes of failures.
#include "texture/store/tiles/load.h"

#include <algorithm>
#include <cstring>

#include "core/status.h"
#include "texture/store/storage.h"
#include "texture/store/tiles/cache.h"

namespace shd::texture {
namespace {

using std::chrono::seconds;

constexpr seconds kPatience{1};      // until a call does itself what it waits for
constexpr seconds kLongestWait{60};  // without an end of a load

/// The innermost callback around a load that fills a tile, or null.
const TileLoad* filler_of(const TileLoad& load, uint32_t tile) {
  const TileLoad* around = load.around;
  while (around && !around->has(load, tile)) around = around->around;
  return around;
}

[[noreturn]] void refuse_cycle(const Texture& texture, uint32_t tile) {
  const shd_tile at = tile_at(texture, tile);
  core::refuse(SHD_ERROR_CALLBACK,
               "texture.tiles.load: it looks up the tile that it loads, level %u, layer %u, column %u, row %u",
               at.level, at.layer, at.area.x, at.area.y);
}

}  // namespace

void TileCache::refuse_full(const TileLoad& load) const {
  const TileLoad* outermost = &load;
  while (outermost->around) outermost = outermost->around;
  outermost->starved.store(true, std::memory_order_relaxed);
  core::refuse(SHD_ERROR_LIMIT,
               "tile_cache.budget_bytes: %llu is too small: callbacks, and those that they call, use %u of %u tiles",
               static_cast<unsigned long long>(budget_bytes_), loading_, budget_.slots);
}

uint32_t TileCache::hold_ready(const TileSet& set, const uint32_t* tiles, size_t count, TileHold* held) {
  uint32_t ready = 0;
  for (size_t i = 0; i < count && ready < kMaxTileBatch; ++i) {
    const uint32_t found = table_.find(set.key_of(tiles[i]));
    if (found == TileTable::kNone || state_of(found) != kSlotReady) continue;
    slots_[found].readers.fetch_add(1, std::memory_order_seq_cst);
    slots_[found].recent.store(1, std::memory_order_relaxed);
    held[ready++] = {tiles[i], found};
  }
  return ready;
}

/// Chooses tiles of one level that nobody loads; none if there are none. `again`: otherwise, a tile that others load.
void TileCache::choose(const uint32_t* tiles, size_t count, bool again, TileLoad* load) {
  const Texture& texture = *load->set->texture;
  load->count = 0;
  for (size_t i = 0; i < count && load->count < budget_.load_batch; ++i) {
    const uint32_t found = table_.find(load->set->key_of(tiles[i]));
    if (found != TileTable::kNone && state_of(found) == kSlotLoading) continue;
    if (filler_of(*load, tiles[i])) continue;
    if (load->count != 0 && !is_same_level(texture, load->tile[0], tiles[i])) break;
    load->tile[load->count++] = tiles[i];
  }
  if (load->count != 0 || !again) return;
  // A tile that the callbacks around this call fill together with others is loaded alone, so that tiles may depend on
  // others of their batch. A tile that one of them fills alone depends on itself.
  const TileLoad* const filler = filler_of(*load, tiles[0]);
  for (const TileLoad* around = filler; around; around = around->around) {
    if (around->count == 1 && around->has(*load, tiles[0])) refuse_cycle(texture, tiles[0]);
  }
  load->tile[load->count++] = tiles[0];
}

void TileCache::wait_for_change(TileWait* wait, const TileLoad& load) {
  const auto now = TileWait::Clock::now();
  if (!wait->began) wait->patience = now + kPatience;
  if (!wait->began || wait->ended != ended_) wait->end = now + kLongestWait;
  wait->began = true;
  wait->ended = ended_;
  if (changed_.wait_until(mutex_, wait->impatient ? wait->end : wait->patience)) return;
  if (wait->impatient && wait->ended == ended_) refuse_full(load);
  wait->impatient = true;
}

/// Waits for a slot inside a callback, unless every callback that could free one waits as well.
void TileCache::wait_in_callback(TileWait* wait, const TileLoad& load) {
  struct Scope {
    TileCache& cache;
    const TileLoad& load;
    bool others = false;  // callbacks of other caches, whose waits are not known here

    Scope(TileCache* of, const TileLoad& inner) : cache(*of), load(inner) {
      for (const TileLoad* around = load.around; around; around = around->around) {
        if (around->cache != of) {
          others = true;
        } else if (around->blocked++ == 0) {
          ++cache.stuck_;
        }
      }
    }
    ~Scope() {
      for (const TileLoad* around = load.around; around; around = around->around) {
        if (around->cache == &cache && --around->blocked == 0) --cache.stuck_;
      }
    }
  } const scope(this, load);
  if (stuck_ == callbacks_ || (scope.others && wait->impatient)) refuse_full(load);
  wait_for_change(wait, load);
}

/// Limits the number of tiles of a load. Returns false if it may not begin now.
bool TileCache::is_admitted(const TileWait& wait, TileLoad* load) {
  uint32_t most = 1;
  if (load->around) {
    if (room() / 2 > loading_) most = room() / 2 - loading_;
  } else if (wait.alone) {
    if (alone_ != &wait || outermost_ != 0) return false;
  } else {
    // Callbacks may need further slots for the lookups inside them.
    const uint32_t all = room() - std::max(room() / 4, 1u);
    const bool fits = outermost_ < all;
    if (alone_ || (!fits && !wait.impatient)) return false;
    if (fits) most = all - outermost_;
  }
  load->count = std::min(load->count, most);
  return true;
}

/// Takes slots for the tiles of a load, perhaps fewer than are wanted. Returns false if it has waited instead.
bool TileCache::take_slots(Lock* lock, TileWait* wait, TileLoad* load) {
  if (wait->alone && !alone_) alone_ = wait;
  if (!is_admitted(*wait, load)) {
    wait_for_change(wait, *load);
    return false;
  }
  const uint32_t wanted = load->count;
  load->count = 0;
  while (load->count < wanted &&
         begin_load(load->set->key_of(load->tile[load->count]), wait, &load->slot[load->count])) {
    ++load->count;
  }
  if (load->count != 0) return true;
  if (wait->scanned < 2 * budget_.slots || loading_ < room()) {  // some slots are read for a moment
    lock->unlock();
    yield_tile_thread();
    lock->lock();
  } else if (load->around) {
    wait_in_callback(wait, *load);
  } else {
    wait_for_change(wait, *load);
  }
  return false;
}

namespace {

constexpr size_t kMaxTileBlocks = 256;  // in a row: 2^20 bytes of texels of 2 bytes

/// Decodes a tile of blocks, which are at the end of its memory. Texels never reach blocks that are not decoded yet: a
/// row of blocks is copied, and the blocks take less memory than their texels.
void decode_tile(const TileSet& set, const shd_tile& tile, uint8_t* texels) {
  const size_t size = texel_size(*set.texture), pitch = size << set.texture->layout.unit.shift_x;
  const uint32_t across = units_along(tile.area.width, 2);
  uint8_t blocks[kMaxTileBlocks * 16];
  for (uint32_t y = 0; y < units_along(tile.area.height, 2); ++y) {
    std::memcpy(blocks, static_cast<const uint8_t*>(tile.texels) + y * tile.row_stride, across * set.block_size);
    for (uint32_t x = 0; x < across; ++x) {
      set.decode(blocks + x * set.block_size, texels + 4 * (y * pitch + x * size), pitch);
    }
  }
}

/// Writes where the callback puts texels or blocks of tiles.
void give_memory(const TileSet& set, uint8_t* memory, size_t bytes, shd_tile* tile) {
  const UnitShape unit = set.texture->layout.unit;
  tile->texels = set.decode ? memory + bytes - (row_of_blocks(set) << unit.shift_y) / 4 : memory;
  tile->row_stride = set.decode ? row_of_blocks(set) : texel_size(*set.texture) << unit.shift_x;
}

}  // namespace

shd_result call_source(TileLoad* load, const shd_tile* tiles) {
  const core::CallbackScope scope(load);
  char before[core::kErrorTextSize];
  std::memcpy(before, core::last_error(), std::strlen(core::last_error()) + 1);
  const shd_tile_source& source = load->set->source;
  const shd_result result = source.load(tiles, load->count, source.user_data);
  if (result == SHD_OK) return SHD_OK;
  char cause[core::kErrorTextSize];
  std::memcpy(cause, core::last_error(), std::strlen(core::last_error()) + 1);
  const bool has_cause = std::strcmp(before, cause) != 0;
  return core::fail(
      result == SHD_ERROR_CANCELLED ? result : SHD_ERROR_CALLBACK,
      "texture.tiles.load returned %s for %u tiles, the first at level %u, layer %u, column %u, row %u%s%s",
      shd_result_name(result), load->count, tiles[0].level, tiles[0].layer, tiles[0].area.x, tiles[0].area.y,
      has_cause ? ": " : "", has_cause ? cause : "");
}

shd_result TileCache::call(TileLoad* load) const {
  const TileSet& set = *load->set;
  shd_tile tiles[kMaxTileBatch];
  for (uint32_t i = 0; i < load->count; ++i) {
    tiles[i] = tile_at(*set.texture, load->tile[i]);
    give_memory(set, tile_memory(load->slot[i]), tile_bytes_, &tiles[i]);
  }
  const shd_result result = call_source(load, tiles);
  for (uint32_t i = 0; set.decode && result == SHD_OK && i < load->count; ++i) {
    decode_tile(set, tiles[i], tile_memory(load->slot[i]));
  }
  return result;
}

/// Calls the callback without the lock. Returns true if the tiles are loaded, and false if the call must be repeated
/// alone. Throws Failure if it failed.
bool TileCache::run(Lock* lock, TileWait* wait, TileLoad* load) {
  load->next = running_;
  running_ = load;
  ++callbacks_;
  ++loads_;
  if (!load->around) outermost_ += load->count;
  lock->unlock();
  shd_result result = SHD_ERROR_CALLBACK;
  const auto end = [&] {
    lock->lock();
    TileLoad** at = &running_;
    while (*at != load) at = &(*at)->next;
    *at = load->next;
    --callbacks_;
    ++ended_;
    if (!load->around) outermost_ -= load->count;
    for (uint32_t i = 0; i < load->count; ++i) end_load(load->slot[i], result == SHD_OK);
    (result == SHD_OK ? loaded_ : failed_) += load->count;
    changed_.notify_all();
  };
  try {
    result = call(load);
  } catch (...) {
    end();
    throw;
  }
  end();
  if (result == SHD_OK) return true;
  // Its calls got no slot because of other callbacks: without them they get it.
  if (!load->starved.exchange(false, std::memory_order_relaxed) || load->around || wait->alone) {
    throw core::Failure(result, core::last_error());
  }
  wait->alone = true;
  return false;
}

/// fetch(), or pin() of one tile: *to_pin becomes false when it is pinned.
uint32_t TileCache::fetch_or_pin(const TileSet& set, const uint32_t* tiles, size_t count, TileHold* held,
                                 uint32_t* loaded, bool* to_pin) {
  TileLoad load(this, set);
  TileWait wait;
  Lock lock(mutex_);
  struct Scope {
    TileCache& cache;
    TileWait& wait;
    ~Scope() {  // under the lock
      if (cache.alone_ != &wait) return;
      cache.alone_ = nullptr;
      cache.changed_.notify_all();
    }
  } const scope{*this, wait};
  for (;;) {
    if (to_pin && *to_pin) {
      const uint32_t found = table_.find(set.key_of(tiles[0]));
      if ((found == TileTable::kNone || slots_[found].pins == 0) && pinned_ >= budget_.pinned_limit) return 0;
      if (found != TileTable::kNone) add_pin(found, to_pin);
    }
    if (const uint32_t ready = hold_ready(set, tiles, count, held)) return ready;
    choose(tiles, count, load.around || wait.impatient, &load);
    if (load.count == 0) {
      ++waits_;
      wait_for_change(&wait, load);
      continue;
    }
    if (!take_slots(&lock, &wait, &load)) continue;
    if (to_pin && *to_pin) add_pin(load.slot[0], to_pin);
    if (!run(&lock, &wait, &load)) continue;
    *loaded += load.count;
    for (uint32_t i = 0; i < load.count; ++i) held[i] = {load.tile[i], load.slot[i]};
    return load.count;
  }
}

uint32_t TileCache::fetch(const TileSet& set, const uint32_t* tiles, size_t count, TileHold* held, uint32_t* loaded) {
  return fetch_or_pin(set, tiles, count, held, loaded, nullptr);
}

uint32_t TileCache::load(const TileSet& set, const uint32_t* tiles, size_t count) {
  uint32_t loaded = 0;
  uint32_t left[kMaxTileBatch];
  TileHold held[kMaxTileBatch];
  for (size_t first = 0; first < count; first += kMaxTileBatch) {
    size_t rest = std::min<size_t>(kMaxTileBatch, count - first);
    std::copy_n(tiles + first, rest, left);
    while (rest != 0) {
      const uint32_t got = fetch(set, left, rest, held, &loaded);
      for (uint32_t i = 0; i < got; ++i) {
        stop_reading(held[i].slot);
        rest = static_cast<size_t>(std::remove(left, left + rest, held[i].tile) - left);
      }
    }
  }
  return loaded;
}

bool TileCache::pin(const TileSet& set, uint32_t tile) {
  bool to_pin = true;
  TileHold held[kMaxTileBatch];
  uint32_t loaded = 0;
  try {
    if (fetch_or_pin(set, &tile, 1, held, &loaded, &to_pin) == 0) return false;
  } catch (...) {
    if (!to_pin) unpin(set, tile);
    throw;
  }
  stop_reading(held[0].slot);
  return true;
}

TileSet* TileCache::find_set(uint32_t number) {
  TileSet* set = sets_;
  while (set && set->number != number) set = set->next;
  return set;
}

uint32_t TileCache::load_requested(uint32_t max) {
  constexpr auto kType = static_cast<uint32_t>(core::ObjectType::kTexture);
  uint32_t loaded = 0;
  for (uint32_t taken = 0; max == 0 || taken < max;) {
    uint32_t tiles[kMaxTileBatch], count = 0;
    TileSet* set = nullptr;
    core::Object* texture = nullptr;
    {
      const std::lock_guard<TileMutex> lock(mutex_);
      const TileKey latest = requests_.take_latest(0);
      if (latest == 0) break;
      const auto number = static_cast<uint32_t>(latest >> 32);
      set = find_set(number);
      for (TileKey key = latest; key; key = requests_.take_latest(number)) {
        tiles[count++] = static_cast<uint32_t>(key);
        if (++taken == max || count == kMaxTileBatch) break;
      }
      // Another thread may be about to remove the texture.
      if (set && core::retain(set->handle, kType)) texture = set->handle;
    }
    if (!texture) continue;
    struct Scope {
      core::Object* texture;
      ~Scope() { core::release(texture, kType); }
    } const scope{texture};
    std::sort(tiles, tiles + count);
    loaded += load(*set, tiles, count);
  }
  return loaded;
}

}  // namespace shd::texture
