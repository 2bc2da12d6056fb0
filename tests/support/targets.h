// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <hwy/highway.h>

#include "core/simd_target.h"

namespace shd::tests {

/// Calls body(target, first) for every SIMD target that is compiled in and runs here; `first` is true once.
template <class Body>
void for_each_target(Body body) {
  bool first = true;
  for (int64_t bit : hwy::SupportedAndGeneratedTargets()) {
    body(core::simd_target_from_bit(bit), first);
    first = false;
  }
}

}  // namespace shd::tests
