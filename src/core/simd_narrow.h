// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <hwy/targets.h>

#include "core/simd_target.h"

namespace shd::core {

/// Lanes of the targets without wide vectors. Kernels that load texels lane by lane spend time on unused lanes: four
/// trilinear lookups take 155 ns with AVX-512, 135 ns with AVX2 and 120 ns with SSE4.
constexpr size_t kNarrowLanes = 4;

/// Row of Highway's dispatch tables for up to kNarrowLanes elements, on machines that run `target`. All targets give
/// the same bits.
inline size_t narrow_index(const SimdTarget& target) {
#if (HWY_TARGETS & HWY_SSE4) && (HWY_TARGETS & (HWY_AVX2 | HWY_AVX3))
  // The entries of a table follow one for generic code in the order of the targets' bits (hwy/targets.h).
  constexpr auto kRow = static_cast<size_t>(__builtin_ctzll(HWY_CHOSEN_TARGET_SHIFT(HWY_SSE4)));
  return target.index < kRow ? kRow : target.index;  // wider targets come first
#else
  return target.index;
#endif
}

}  // namespace shd::core
