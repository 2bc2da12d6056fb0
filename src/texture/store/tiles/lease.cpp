// SPDX-License-Identifier: MIT
#include "texture/store/tiles/lease.h"

#include <algorithm>

#include "texture/store/storage.h"
#include "texture/store/tiles/cache.h"

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

TileCall::TileCall(const Texture& of) : texture(of), cache(*of.tiles->cache), origin(cache.tiles()) {
  take_lease();
}

TileCall::~TileCall() {
  if (lease) give_lease();
}

void TileCall::take_lease() {
  lease = cache.take_lease(texture);
}

void TileCall::give_lease() {
  cache.put_lease(lease);
  lease = nullptr;
}

TileLease* TileCache::try_lease(uint32_t number) {
  for (const uint32_t wanted : {number, 0u, TileLease::kNoTile}) {
    for (uint32_t i = 0; i < budget_.leases; ++i) {
      TileLease& lease = leases_[i];
      if (wanted != TileLease::kNoTile && lease.last_number.load(std::memory_order_relaxed) != wanted) continue;
      if (!lease.used.load(std::memory_order_seq_cst) && !lease.used.exchange(true, std::memory_order_seq_cst)) {
        return &lease;
      }
    }
  }
  return nullptr;
}

TileLease* TileCache::take_lease(const Texture& texture) {
  const uint32_t number = texture.tiles->number;
  TileLease* lease = try_lease(number);
  if (!lease) {  // calls have leases for the time of lookups, and not while they load or wait for others
    const std::lock_guard<TileMutex> lock(mutex_);
    waiting_for_lease_.fetch_add(1, std::memory_order_seq_cst);
    while ((lease = try_lease(number)) == nullptr) lease_free_.wait(mutex_);
    waiting_for_lease_.fetch_sub(1, std::memory_order_relaxed);
  }
  const uint32_t drops = this->drops();
  if (lease->number != number || lease->version != drops) lease->clear();
  const size_t size = texel_size(texture);
  lease->number = number;
  lease->last_number.store(number, std::memory_order_relaxed);
  lease->version = drops;
  lease->texture = &texture;
  lease->tile_texels = static_cast<uint32_t>(tile_bytes_ / size);
  lease->spare = static_cast<int32_t>(lease->spare_offset / size);
  return lease;
}

void TileCache::put_lease(TileLease* lease) noexcept {
  lease->used.store(false, std::memory_order_seq_cst);
  if (waiting_for_lease_.load(std::memory_order_seq_cst) == 0) return;
  const std::lock_guard<TileMutex> lock(mutex_);
  lease_free_.notify_all();
}

void TileCache::clear_leases(uint32_t number) {
  const std::lock_guard<TileMutex> lock(mutex_);
  for (uint32_t i = 0; i < budget_.leases; ++i) {
    TileLease& lease = leases_[i];
    if (lease.last_number.load(std::memory_order_relaxed) != number) continue;
    // Nobody looks the texture up any more. If the lease is in use, its call has another texture, and has let go.
    if (lease.used.exchange(true, std::memory_order_acquire)) continue;
    if (lease.number == number) lease.clear();
    lease.used.store(false, std::memory_order_seq_cst);
  }
}

}  // namespace shd::texture
