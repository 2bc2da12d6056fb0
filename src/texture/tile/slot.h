// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <thread>

namespace shd::texture {

/// States of a slot. A reader counts itself in `readers` first and then looks whether the slot is ready with the key
/// that it wants; whoever takes the slot sets the state first and then looks for readers. All four accesses are
/// sequentially consistent, so one of the two sees the other (Dekker's algorithm).
enum SlotState : uint32_t {
  kSlotFree = 0,
  kSlotLoading = 1,  // a callback writes the tile; readers wait
  kSlotReady = 2,
  kSlotTaken = 3,    // for a moment: somebody looks whether the slot has readers
  kSlotDropped = 4,  // its source has changed; free when the last reader has gone
};

/// Memory of a tile. Members without std::atomic are guarded by the mutex of the cache.
struct TileSlot {
  std::atomic<uint64_t> key{0};  // TileKey, or 0
  std::atomic<uint32_t> state{kSlotFree};
  std::atomic<uint32_t> readers{0};
  std::atomic<uint32_t> recent{0};  // used since the last walk of the clock
  uint32_t pins = 0;
  uint32_t version = 0;  // number of drops before the load
  bool stale = false;    // dropped while it was loaded
  std::thread::id loader;
};

}  // namespace shd::texture
