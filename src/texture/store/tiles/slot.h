// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "texture/store/tiles/sync.h"

namespace shd::texture {

/// States of a slot. A reader is counted in `readers` first; then it checks that the slot is ready and has its key. A
/// thread that takes the slot sets the state first; then it checks that there are no readers. All four accesses are
/// sequentially consistent, so one of the two threads finds the other (Dekker's algorithm).
enum SlotState : uint32_t {
  kSlotFree = 0,
  kSlotLoading = 1,  // a callback writes the tile
  kSlotReady = 2,
  kSlotTaken = 3,    // for a moment: a thread checks whether the slot has readers
  kSlotDropped = 4,  // has no key any more; free when the last reader has gone
  kSlotEmpty = 5,    // has a key and pins, but no valid texels: the next load of the key fills it
};

/// Memory of a tile. Members that are not atomic are guarded by the mutex of the cache.
///
/// The table has one slot of a key: it is ready, empty, or loading. Further slots of the key are loading: several calls
/// of the callback may write the same tile, and the first that ends is the slot of the table. Only the slot of the
/// table has pins.
struct TileSlot {
  TileAtomic<uint64_t> key{0};  // TileKey, or 0
  TileAtomic<uint32_t> state{kSlotFree};
  TileAtomic<uint32_t> readers{0};
  TileAtomic<uint32_t> recent{0};  // used since the last walk of the clock
  uint32_t pins = 0;
  uint32_t version = 0;  // number of drops before the load
  bool stale = false;    // dropped while it was loaded
};

}  // namespace shd::texture
