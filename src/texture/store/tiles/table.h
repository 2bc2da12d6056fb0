// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "texture/store/tiles/sync.h"
#include "texture/store/tiles/tile.h"

namespace shd::texture {

/// Slots by key: open addressing with linear probes (Knuth, "The Art of Computer Programming", volume 3 (1998), 6.4,
/// algorithms L and R). Removal moves the later keys of a run, so the table is never rebuilt. Any thread may search
/// while one thread changes the table. A search may then miss a key, or find a slot that has another tile by now:
/// callers check the slot, and search again under the lock.
class TileTable {
 public:
  static constexpr uint32_t kNone = 0xffffffff;

  struct Entry {
    TileAtomic<uint64_t> key{0};
    TileAtomic<uint32_t> slot{kNone};
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
  uint32_t first_entry(TileKey key) const;

  Entry* entries_ = nullptr;
  uint32_t mask_ = 0;
};

}  // namespace shd::texture
