// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>

#include "core/call.h"
#include "texture/store/tiles/sync.h"
#include "texture/store/tiles/tile.h"

namespace shd::texture {

constexpr uint32_t kMaxTileBatch = 16;

/// A call of a callback: tiles of one level of a layer, and their slots. It is the callback of the calls that the host
/// makes inside it. Everything but `starved` stays as it is while the callback runs, or is guarded by the cache.
struct TileLoad : core::Callback {
  TileLoad(TileCache* of, const TileSet& tiles) : cache(of), set(&tiles), around(innermost()) { loads_tiles = true; }

  /// Returns the innermost callback of this thread that loads tiles, or null.
  static const TileLoad* innermost() {
    const core::Callback* callback = core::t_call.callback;
    while (callback && !callback->loads_tiles) callback = callback->outer;
    return static_cast<const TileLoad*>(callback);
  }

  bool has(const TileLoad& load, uint32_t of_tile) const {
    if (cache != load.cache || set != load.set) return false;
    for (uint32_t i = 0; i < count; ++i) {
      if (tile[i] == of_tile) return true;
    }
    return false;
  }

  TileCache* const cache;  // null if the tiles are for no cache
  const TileSet* const set;
  const TileLoad* const around;  // the callback that this one runs in, of any cache, or null
  uint32_t count = 0;
  uint32_t tile[kMaxTileBatch], slot[kMaxTileBatch];
  mutable uint32_t blocked = 0;             // calls inside it that wait for a slot of its cache
  mutable TileAtomic<bool> starved{false};  // a call inside it got no slot
  TileLoad* next = nullptr;                 // in the list of the cache
};

/// Calls the callback of a texture for tiles that have memory. Returns SHD_OK, or the result of the lookup, whose text
/// is stored.
shd_result call_source(TileLoad* load, const shd_tile* tiles);

/// The waits of a call.
struct TileWait {
  using Clock = std::chrono::steady_clock;

  bool began = false;
  bool impatient = false;  // has waited for a second: loads tiles that others load, and takes any slot
  bool alone = false;      // no other outermost callback may run, because this one got no slot inside it
  uint64_t ended = 0;      // loads of the cache that had ended
  uint64_t scanned = 0;    // slots that were not free
  Clock::time_point patience, end;
};

/// A tile that its holder reads.
struct TileHold {
  uint32_t tile, slot;
};

}  // namespace shd::texture
