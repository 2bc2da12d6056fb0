// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>

#include "texture/tile/tile.h"

namespace shd::texture {

/// Slots by key: open addressing with linear probes (Knuth, "The Art of Computer Programming", volume 3 (1998), 6.4,
/// algorithm L). Any thread may search while one thread changes the table. A search may then miss a key, or find a slot
/// that has another tile by now: callers check the slot, and search again under the lock.
class TileTable {
 public:
  static constexpr uint32_t kNone = 0xffffffff;

  struct Entry {
    std::atomic<uint64_t> key{0};
    std::atomic<uint32_t> slot{kNone};
  };

  /// Returns the number of entries for `slots` slots.
  static uint32_t capacity_for(uint32_t slots);

  /// `entries` are default-constructed and outlive the table.
  void attach(Entry* entries, uint32_t capacity);

  uint32_t find(TileKey key) const;
  /// The key is not in the table.
  void insert(TileKey key, uint32_t slot);
  void remove(TileKey key);

 private:
  static constexpr TileKey kRemoved = ~TileKey{0};

  uint32_t first_entry(TileKey key) const;
  void rebuild();
  void put(TileKey key, uint32_t slot);

  Entry* entries_ = nullptr;
  uint32_t mask_ = 0;
  uint32_t used_ = 0;  // entries with a key, or whose key was removed
};

}  // namespace shd::texture
