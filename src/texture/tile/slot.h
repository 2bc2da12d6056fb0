// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <thread>

namespace shd::texture {

/// States of a slot. A reader is counted in `readers` first; then it checks that the slot is ready and has its key. A
/// thread that takes the slot sets the state first; then it checks that there are no readers. All four accesses are
/// sequentially consistent, so one of the two threads finds the other (Dekker's algorithm).
enum SlotState : uint32_t {
  kSlotFree = 0,
  kSlotLoading = 1,  // a callback writes the tile; readers wait
  kSlotReady = 2,
  kSlotTaken = 3,    // for a moment: a thread checks whether the slot has readers
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
