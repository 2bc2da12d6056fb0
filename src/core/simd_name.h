// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include <hwy/targets.h>

#include "core/simd_target.h"

namespace shd::core {

/// Name of a Highway target, as in shd_context_get_simd_target(). Highway names AVX-512 by its number of operands.
/// Static.
inline const char* simd_target_name(int64_t bit) {
  return bit == HWY_AVX3 ? "AVX512" : hwy::TargetName(bit);
}

/// Row of Highway's dispatch tables, if more than one target is compiled.
inline size_t simd_target_index(int64_t bit) {
  hwy::ChosenTarget chosen;
  chosen.Update(bit);
  return chosen.GetIndex();
}

/// The target of this build whose name shd_context_get_simd_target() gave; the baseline for any other name.
inline SimdTarget find_simd_target(const char* name) {
#if (HWY_TARGETS & (HWY_TARGETS - 1)) != 0
  for (int64_t rest = HWY_TARGETS; rest != 0; rest &= rest - 1) {
    const int64_t bit = rest & -rest;
    if (std::strcmp(simd_target_name(bit), name) == 0) return {simd_target_index(bit), simd_target_name(bit)};
  }
  return {simd_target_index(HWY_STATIC_TARGET), simd_target_name(HWY_STATIC_TARGET)};
#else
  (void)name;
  return {0, simd_target_name(HWY_STATIC_TARGET)};
#endif
}

}  // namespace shd::core
