// SPDX-License-Identifier: MIT
// Slots of a TileCache: eviction, the beginning and the end of loads, pins, drops. Everything runs under its mutex.
#include <algorithm>

#include "texture/store/tiles/cache.h"

namespace shd::texture {

/// Changes a slot, and with it the numbers of slots in its state.
template <class Change>
void TileCache::update(uint32_t at, Change&& change) {
  TileSlot& slot = slots_[at];
  const auto add = [&](uint32_t one) {
    if (slot.pins != 0) pinned_ += one;
    if (state_of(at) == kSlotLoading && slot.pins == 0) loading_ += one;
    if (state_of(at) == kSlotReady) resident_ += one;
  };
  add(~uint32_t{0});
  change(slot);
  add(1);
}

uint32_t TileCache::claim(TileWait* wait) {
  // The clock passes over few slots at once, because other calls wait for the mutex. The first half of them get a
  // second chance if they were used lately.
  constexpr uint32_t kMost = 4096;
  const uint32_t steps = std::min(2 * budget_.slots, kMost);
  for (uint32_t step = 0; step < steps; ++step, ++wait->scanned) {
    const uint32_t found = hand_;
    TileSlot& slot = slots_[found];
    hand_ = hand_ + 1 == budget_.slots ? 0 : hand_ + 1;
    const SlotState state = state_of(found);
    if (state == kSlotLoading || slot.pins != 0) continue;
    if (state == kSlotReady && step < steps / 2 && slot.recent.load(std::memory_order_relaxed) != 0) {
      slot.recent.store(0, std::memory_order_relaxed);
      continue;
    }
    if (slot.readers.load(std::memory_order_relaxed) != 0) continue;
    const TileKey key = slot.key.load(std::memory_order_relaxed);
    slot.state.store(kSlotTaken, std::memory_order_seq_cst);
    if (slot.readers.load(std::memory_order_seq_cst) != 0) {
      slot.state.store(state, std::memory_order_release);
      continue;
    }
    if (state == kSlotReady) {
      table_.remove(key);
      ++evicted_;
      --resident_;
    }
    slot.key.store(0, std::memory_order_relaxed);
    return found;
  }
  return TileTable::kNone;
}

void TileCache::add_pin(uint32_t at, bool* to_pin) {
  update(at, [](TileSlot& slot) { ++slot.pins; });
  *to_pin = false;
}

void TileCache::move_pins(uint32_t from, uint32_t to) {
  const uint32_t pins = slots_[from].pins;
  if (pins == 0) return;
  update(from, [&](TileSlot& slot) { slot.pins = 0; });
  update(to, [&](TileSlot& slot) { slot.pins += pins; });
}

/// Takes the key from a slot of the table.
void TileCache::let_go(uint32_t at) {
  table_.remove(slots_[at].key.load(std::memory_order_relaxed));
  update(at, [&](TileSlot& slot) {
    slot.key.store(0, std::memory_order_relaxed);
    slot.state.store(kSlotDropped, std::memory_order_seq_cst);
  });
}

bool TileCache::begin_load(TileKey key, TileWait* wait, uint32_t* out) {
  const uint32_t found = table_.find(key);
  const bool empty = found != TileTable::kNone && state_of(found) == kSlotEmpty;
  // Readers of texels that were dropped may still be in an empty slot.
  const bool in_place = empty && slots_[found].readers.load(std::memory_order_seq_cst) == 0;
  const uint32_t at = in_place ? found : claim(wait);
  if (at == TileTable::kNone) return false;
  update(at, [&](TileSlot& slot) {
    slot.key.store(key, std::memory_order_relaxed);
    slot.version = drops_.load(std::memory_order_relaxed);
    slot.stale = false;
    slot.state.store(kSlotLoading, std::memory_order_seq_cst);
  });
  if (empty && !in_place) {
    move_pins(found, at);
    let_go(found);
  }
  if (found == TileTable::kNone || (empty && !in_place)) table_.insert(key, at);
  *out = at;
  return true;
}

void TileCache::end_load(uint32_t at, bool succeeded) {
  const TileKey key = slots_[at].key.load(std::memory_order_relaxed);
  const uint32_t found = table_.find(key);
  const bool in_table = found == at;
  if (succeeded) slots_[at].readers.fetch_add(1, std::memory_order_seq_cst);  // the thread that loaded it
  const bool first = in_table || found == TileTable::kNone || state_of(found) != kSlotReady;
  if (succeeded && !slots_[at].stale && first) {
    if (!in_table && found != TileTable::kNone) {  // another call loads it too, or it is empty
      move_pins(found, at);
      if (state_of(found) == kSlotEmpty) {
        let_go(found);
      } else {
        table_.remove(key);
      }
    }
    if (!in_table) table_.insert(key, at);
    requests_.remove(key);
    slots_[at].recent.store(1, std::memory_order_relaxed);
    update(at, [](TileSlot& slot) { slot.state.store(kSlotReady, std::memory_order_seq_cst); });
  } else if (in_table && slots_[at].pins != 0) {
    update(at, [](TileSlot& slot) { slot.state.store(kSlotEmpty, std::memory_order_seq_cst); });
  } else if (in_table) {
    let_go(at);
  } else {
    update(at, [](TileSlot& slot) {
      slot.key.store(0, std::memory_order_relaxed);
      slot.state.store(kSlotDropped, std::memory_order_seq_cst);
    });
  }
}

void TileCache::drop_slot(uint32_t at, TileKey key, uint32_t version) {
  const std::lock_guard<TileMutex> lock(mutex_);
  TileSlot& slot = slots_[at];
  if (slot.key.load(std::memory_order_relaxed) != key || slot.version >= version) return;
  if (state_of(at) == kSlotLoading) slot.stale = true;
  if (state_of(at) != kSlotReady) return;
  if (slot.pins == 0) return let_go(at);
  update(at, [](TileSlot& pinned) { pinned.state.store(kSlotEmpty, std::memory_order_seq_cst); });
}

bool TileCache::is_pinned(const TileSet& set, uint32_t tile) {
  const std::lock_guard<TileMutex> lock(mutex_);
  const uint32_t found = table_.find(set.key_of(tile));
  return found != TileTable::kNone && slots_[found].pins != 0;
}

void TileCache::unpin(const TileSet& set, uint32_t tile) {
  const std::lock_guard<TileMutex> lock(mutex_);
  const uint32_t found = table_.find(set.key_of(tile));
  if (found == TileTable::kNone || slots_[found].pins == 0) return;
  update(found, [](TileSlot& slot) { --slot.pins; });
  if (slots_[found].pins != 0) return;
  if (state_of(found) == kSlotEmpty) let_go(found);
  changed_.notify_all();
}

void TileCache::remove(TileSet* set) noexcept {
  {
    const std::lock_guard<TileMutex> lock(mutex_);
    for (TileSet** at = &sets_; *at; at = &(*at)->next) {
      if (*at != set) continue;
      *at = set->next;
      break;
    }
    requests_.remove_texture(set->number);
  }
  clear_leases(set->number);
  constexpr uint32_t kPart = 4096;  // other calls wait for the mutex
  for (uint32_t first = 0; first < budget_.slots; first += kPart) {
    const std::lock_guard<TileMutex> lock(mutex_);
    for (uint32_t at = first; at < std::min(first + kPart, budget_.slots); ++at) {
      if (slots_[at].key.load(std::memory_order_relaxed) >> 32 != set->number) continue;
      update(at, [](TileSlot& slot) { slot.pins = 0; });
      let_go(at);
    }
  }
  const std::lock_guard<TileMutex> lock(mutex_);
  changed_.notify_all();
}

}  // namespace shd::texture
