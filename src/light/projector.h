// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "core/simd_target.h"
#include "light/light.h"

namespace shd::light {

/// Where points, columns of `count`, lie in the texture of a light, a directional one or a spot: (0, 0) at its top left
/// corner seen from the light. (-1, -1) behind a spot and where that has no finite place. |error| <= 1e-6 and what
/// moving the point by 2e-7 of its coordinates and the light's makes. Whole vectors are read and written past count.
void project(const core::SimdTarget& simd, const Light& light, size_t count, const float* const p[3], float* u,
             float* v);

}  // namespace shd::light
