// SPDX-License-Identifier: MIT
#include "texture/store/tiles/budget.h"

#include <algorithm>

#include "texture/store/storage.h"
#include "texture/store/tiles/cache.h"
#include "texture/store/tiles/lease.h"
#include "texture/store/tiles/requests.h"
#include "texture/store/tiles/slot.h"

namespace shd::texture {
namespace {

constexpr uint32_t kMaxLeases = 64, kMaxRoom = 2048;

/// Rounds up to the alignment of the parts.
constexpr size_t rounded(size_t size) {
  return (size + core::kAlignment - 1) / core::kAlignment * core::kAlignment;
}

size_t bytes_of(const TileBudget& budget, uint32_t tile_bytes) {
  const size_t tiles = size_t{budget.slots} * tile_bytes;
  const size_t leases = budget.leases * (rounded(TileLease::kSpareBytes) + rounded(sizeof(TileLease)));
  return tiles + leases + rounded(kPadding) + rounded(budget.slots * sizeof(TileSlot)) +
         rounded(budget.table_entries * sizeof(TileTable::Entry)) + rounded(budget.requests * sizeof(TileRequest)) +
         rounded(sizeof(TileCache));
}

/// Sets everything that follows from the number of slots.
void complete(uint32_t tile_bytes, TileBudget* budget) {
  const uint32_t slots = budget->slots;
  budget->leases = std::min(budget->leases, std::max(slots / 8, 1u));
  budget->pinned_limit = slots / 2;
  const uint32_t room = std::clamp(slots / 4, 2u, kMaxRoom);
  budget->load_batch = std::clamp(room / 2, 1u, kMaxTileBatch);
  budget->kept_limit = slots - budget->pinned_limit - room;
  budget->requests = 16;
  while (budget->requests < 4096 && budget->requests < slots) budget->requests *= 2;
  budget->table_entries = TileTable::capacity_for(slots);
  budget->bytes = bytes_of(*budget, tile_bytes);
}

}  // namespace

uint64_t smallest_tile_budget(uint32_t tile_bytes) {
  return uint64_t{4} * tile_bytes + (uint64_t{1} << 16);
}

TileBudget divide_tile_budget(uint64_t budget, uint32_t tile_bytes) {
  TileBudget parts = {};
  parts.leases = static_cast<uint32_t>(std::clamp<uint64_t>(budget >> 20, 1, kMaxLeases));
  parts.slots = static_cast<uint32_t>(budget / tile_bytes);
  complete(tile_bytes, &parts);
  while (parts.bytes > budget) {
    const size_t excess = (parts.bytes - budget) / (tile_bytes + sizeof(TileSlot) + 1);
    parts.slots -= static_cast<uint32_t>(excess ? excess : 1);
    complete(tile_bytes, &parts);
  }
  return parts;
}

}  // namespace shd::texture
