// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/simd_target.h"
#include "raster/tile.h"

namespace shd::raster {

/// Sets bit i of `bits` if values[i] differs from values[i - 1]; bit 0 is 1.
/// @param count  a multiple of 64
/// @param bits   [count / 64]
void find_changes(const core::SimdTarget& simd, const uint32_t* values, size_t count, uint64_t* bits);

/// Clears the slots of a tile to kNoSlot.
void clear_slots(const core::SimdTarget& simd, Tile* tile);

/// Sets all depths of a tile.
void fill_depth(const core::SimdTarget& simd, float depth, Tile* tile);

}  // namespace shd::raster
