// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "texture/store/tiles/table.h"

namespace shd::texture {

/// Sizes of the parts of a cache, which share one block of memory. All parts together are within the budget.
struct TileBudget {
  uint32_t slots;
  uint32_t leases;        // lookups at once, beside those that load
  uint32_t load_batch;    // most tiles that one call of a callback fills
  uint32_t kept_limit;    // slots that leases may keep from eviction, over all leases
  uint32_t pinned_limit;  // slots that hosts may pin
  uint32_t requests;      // a power of two
  uint32_t table_entries;
  size_t bytes;
};

/// Smallest budget with tiles of a size [bytes].
uint64_t smallest_tile_budget(uint32_t tile_bytes);

/// Divides a budget, which is at least the smallest one. One slot in two can be pinned. Leases keep about one in four.
/// The rest, at least two slots, can always be evicted and loaded.
TileBudget divide_tile_budget(uint64_t budget, uint32_t tile_bytes);

}  // namespace shd::texture
