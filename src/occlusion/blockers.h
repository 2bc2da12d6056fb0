// SPDX-License-Identifier: MIT
#pragma once

#include "core/simd_target.h"
#include "light/shadow.h"

namespace shd::occlusion {

/// 1 for points at which the HARD filter of a shadow finds light, or whose blocker is farther than `reach`, otherwise
/// 0.
void find_open(const core::SimdTarget& simd, const light::Shadow& shadow, float reach, const light::ShadowLookups& in,
               float* open);

}  // namespace shd::occlusion
