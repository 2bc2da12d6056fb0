// SPDX-License-Identifier: MIT
// A TileCache in the child of a fork: the threads that loaded, read and waited do not exist there. fork() holds the
// mutex. The only thread is in no function of the cache, but it may be in callbacks: it forked in one of them.
#include "texture/store/tiles/cache.h"
#include "texture/store/tiles/lease.h"

namespace shd::texture {
namespace {

/// Whether the only thread is in a callback.
bool is_alive(const TileLoad& load) {
  const TileLoad* around = TileLoad::innermost();
  while (around && around != &load) around = around->around;
  return around != nullptr;
}

}  // namespace

void TileCache::repair_loads() noexcept {
  callbacks_ = stuck_ = outermost_ = 0;
  alone_ = nullptr;
  for (TileLoad** at = &running_; *at;) {
    TileLoad& load = **at;
    load.blocked = 0;
    if (is_alive(load)) {
      ++callbacks_;
      if (!load.around) outermost_ += load.count;
      at = &load.next;
      continue;
    }
    *at = load.next;
    for (uint32_t i = 0; i < load.count; ++i) end_load(load.slot[i], false);
  }
}

void TileCache::repair_readers() noexcept {
  for (uint32_t i = 0; i < budget_.slots; ++i) {
    if (slots_[i].readers.load(std::memory_order_relaxed) != 0) slots_[i].readers.store(0, std::memory_order_relaxed);
  }
  uint32_t kept = 0;
  for (uint32_t i = 0; i < budget_.leases; ++i) {
    TileLease& lease = leases_[i];
    const bool lost = lease.used.load(std::memory_order_relaxed);
    if (lost) {
      lease.number = lease.kept = 0;
      lease.last_number.store(0, std::memory_order_relaxed);
    }
    for (uint32_t e = 0; e < TileLease::kKept; ++e) {
      if (lease.tile[e] == TileLease::kNoTile) continue;
      if (lost) {
        lease.tile[e] = TileLease::kNoTile;
      } else {
        slots_[static_cast<uint32_t>(lease.first[e]) / lease.tile_texels].readers.fetch_add(1);
      }
    }
    kept += lease.kept;
    lease.used.store(false, std::memory_order_relaxed);
  }
  kept_.store(kept, std::memory_order_relaxed);
  waiting_for_lease_.store(0, std::memory_order_relaxed);
}

void TileCache::repair_in_child(void* body) noexcept {
  auto& cache = *static_cast<TileCache*>(body);
  cache.changed_.renew();
  cache.lease_free_.renew();
  cache.repair_loads();
  cache.repair_readers();
}

}  // namespace shd::texture
