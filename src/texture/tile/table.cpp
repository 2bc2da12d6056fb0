// SPDX-License-Identifier: MIT
#include "texture/tile/table.h"

namespace shd::texture {

uint32_t TileTable::capacity_for(uint32_t slots) {
  uint32_t capacity = 16;
  while (capacity < 2 * slots) capacity *= 2;
  return capacity;
}

void TileTable::attach(Entry* entries, uint32_t capacity) {
  entries_ = entries;
  mask_ = capacity - 1;
}

uint32_t TileTable::first_entry(TileKey key) const {
  const uint64_t mixed = (key ^ key >> 29) * 0x9e3779b97f4a7c15u;
  return static_cast<uint32_t>(mixed >> 32) & mask_;
}

uint32_t TileTable::find(TileKey key) const {
  uint32_t i = first_entry(key);
  for (uint32_t probes = 0; probes <= mask_; ++probes, i = (i + 1) & mask_) {
    const TileKey found = entries_[i].key.load(std::memory_order_acquire);
    if (found == key) return entries_[i].slot.load(std::memory_order_relaxed);
    if (found == 0) return kNone;
  }
  return kNone;
}

void TileTable::put(TileKey key, uint32_t slot) {
  uint32_t i = first_entry(key);
  for (;; i = (i + 1) & mask_) {
    const TileKey found = entries_[i].key.load(std::memory_order_relaxed);
    if (found == 0) ++used_;
    if (found == 0 || found == kRemoved) break;
  }
  entries_[i].slot.store(slot, std::memory_order_relaxed);
  entries_[i].key.store(key, std::memory_order_release);
}

void TileTable::insert(TileKey key, uint32_t slot) {
  if (used_ > mask_ / 4 * 3) rebuild();
  put(key, slot);
}

void TileTable::remove(TileKey key) {
  uint32_t i = first_entry(key);
  for (;; i = (i + 1) & mask_) {
    const TileKey found = entries_[i].key.load(std::memory_order_relaxed);
    if (found == 0) return;
    if (found == key) break;
  }
  entries_[i].key.store(kRemoved, std::memory_order_release);
}

void TileTable::rebuild() {
  // Entries are reinserted one run after another, behind the first empty entry. Half of the entries hold keys at most.
  const uint32_t capacity = mask_ + 1;
  for (uint32_t i = 0; i < capacity; ++i) {
    if (entries_[i].key.load(std::memory_order_relaxed) == kRemoved) {
      entries_[i].key.store(0, std::memory_order_release);
    }
  }
  used_ = 0;
  for (uint32_t i = 0; i < capacity; ++i) used_ += entries_[i].key.load(std::memory_order_relaxed) != 0;
  // A key may now lie behind a gap of its run. Each pass moves such keys forward; keys only move towards their first
  // entry, so the passes end.
  for (bool moved = true; moved;) {
    moved = false;
    for (uint32_t i = 0; i < capacity; ++i) {
      const TileKey key = entries_[i].key.load(std::memory_order_relaxed);
      if (key == 0 || find(key) != kNone) continue;
      const uint32_t slot = entries_[i].slot.load(std::memory_order_relaxed);
      entries_[i].key.store(0, std::memory_order_release);
      --used_;
      put(key, slot);
      moved = true;
    }
  }
}

}  // namespace shd::texture
