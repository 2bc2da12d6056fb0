// SPDX-License-Identifier: MIT
// Locks and atomics of tile caches. A test defines SHD_TEXTURE_TILE_SYNC and supplies its own, which run threads in
// every order (tests/unit/texture/test_tile_orders.cpp).
#pragma once

#ifdef SHD_TEXTURE_TILE_SYNC
#include SHD_TEXTURE_TILE_SYNC
#else

#include <atomic>
#include <thread>

#include "core/fork.h"

namespace shd::texture {

struct TileMutex : core::ForkMutex {
  TileMutex() : core::ForkMutex(core::ForkLevel::kTileCache) {}
};
using TileCondition = core::ForkCondition;
template <class T>
using TileAtomic = std::atomic<T>;

/// Lets other threads run.
inline void yield_tile_thread() {
  std::this_thread::yield();
}

}  // namespace shd::texture

#endif
