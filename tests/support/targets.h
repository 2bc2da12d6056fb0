// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <hwy/highway.h>

#include "core/simd_target.h"

namespace shd::tests
{

/// Highway's bits of the SIMD targets that are compiled in and run here. They are queried once, because the query runs
/// CPUID, which is slow in a virtual machine.
inline const std::vector<int64_t> &target_bits()
{
    static const std::vector<int64_t> bits = hwy::SupportedAndGeneratedTargets();
    return bits;
}

inline core::SimdTarget best_target() { return core::simd_target_from_bit(target_bits().front()); }

/// Calls body(target, first) for every target; `first` is true once.
template <class Body>
void for_each_target(Body body)
{
    bool first = true;
    for (int64_t bit : target_bits()) {
        body(core::simd_target_from_bit(bit), first);
        first = false;
    }
}

}  // namespace shd::tests
