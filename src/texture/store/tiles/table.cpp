// SPDX-License-Identifier: MIT
#include "texture/store/tiles/table.h"

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

void TileTable::insert(TileKey key, uint32_t slot) {
  uint32_t i = first_entry(key);
  while (entries_[i].key.load(std::memory_order_relaxed) != 0) i = (i + 1) & mask_;
  entries_[i].slot.store(slot, std::memory_order_relaxed);
  entries_[i].key.store(key, std::memory_order_release);
}

void TileTable::remove(TileKey key) {
  uint32_t hole = first_entry(key);
  for (TileKey found; (found = entries_[hole].key.load(std::memory_order_relaxed)) != key; hole = (hole + 1) & mask_) {
    if (found == 0) return;
  }
  // Later keys of the run move into the hole if it is not before their first entry.
  for (uint32_t i = hole;;) {
    i = (i + 1) & mask_;
    const TileKey next = entries_[i].key.load(std::memory_order_relaxed);
    if (next == 0) break;
    if (((i - first_entry(next)) & mask_) < ((i - hole) & mask_)) continue;
    entries_[hole].slot.store(entries_[i].slot.load(std::memory_order_relaxed), std::memory_order_relaxed);
    entries_[hole].key.store(next, std::memory_order_release);
    hole = i;
  }
  entries_[hole].key.store(0, std::memory_order_release);
}

}  // namespace shd::texture
