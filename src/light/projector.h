// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "core/simd_target.h"
#include "light/light.h"

namespace shd::light {

/// Coordinates of `count` points (columns p) in the cookie of a directional light or a spot. (0, 0) is the top left
/// corner as seen from the light. The result is (-1, -1) behind a spot and where the coordinates are not finite.
/// |error| <= 1e-6, plus the change when the point moves by 2e-7 of the coordinates of the point and of the light.
/// Reads and writes whole vectors past count.
void project(const core::SimdTarget& simd, const Light& light, size_t count, const float* const p[3], float* u,
             float* v);

}  // namespace shd::light
