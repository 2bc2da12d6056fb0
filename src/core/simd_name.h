// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <hwy/targets.h>

namespace shd::core {

/// Name of a Highway target, as in shd_context_simd_target(). Highway names AVX-512 by its number of operands. Static.
inline const char* simd_target_name(int64_t bit) {
  return bit == HWY_AVX3 ? "AVX512" : hwy::TargetName(bit);
}

/// Row of Highway's dispatch tables, if more than one target is compiled.
inline size_t simd_target_index(int64_t bit) {
  hwy::ChosenTarget chosen;
  chosen.Update(bit);
  return chosen.GetIndex();
}

}  // namespace shd::core
