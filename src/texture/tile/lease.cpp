// SPDX-License-Identifier: MIT
#include "texture/tile/lease.h"

#include <algorithm>

#include "texture/tile/cache.h"

namespace shd::texture {

void TileLease::begin_stream() {
  if (++now != 0) return;
  std::fill_n(turn, kKept, 0u);
  now = 1;
}

bool TileLease::keep(uint32_t of_tile) {
  const uint32_t entry = entry_of(of_tile);
  if (turn[entry] == now) return tile[entry] == of_tile;
  const uint32_t slot = cache->read(texture->tiles->key_of(of_tile));
  if (slot == TileTable::kNone) return false;
  if (tile[entry] != kNoTile) {
    cache->stop_reading(static_cast<uint32_t>(first[entry]) / tile_texels);
  } else if (cache->may_keep()) {
    ++kept;
  } else {
    cache->stop_reading(slot);
    return false;
  }
  tile[entry] = of_tile;
  first[entry] = static_cast<int32_t>(slot * tile_texels);
  turn[entry] = now;
  return true;
}

void TileLease::clear() {
  for (uint32_t entry = 0; entry < kKept; ++entry) {
    if (tile[entry] == kNoTile) continue;
    cache->stop_reading(static_cast<uint32_t>(first[entry]) / tile_texels);
    tile[entry] = kNoTile;
  }
  cache->give_up(kept);
  kept = 0;
}

TileLeaseScope::TileLeaseScope(const Texture& texture) : lease_(texture.tiles->cache->take_lease(texture)) {}

TileLeaseScope::~TileLeaseScope() {
  lease_->cache->put_lease(lease_);
}

}  // namespace shd::texture
