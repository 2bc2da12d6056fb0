// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/simd_target.h"
#include "raster/fragments.h"
#include "shade/light_table.h"

namespace shd::shade {

/// Finds the lights of a table whose range reaches the bounds of the points' positions. Writes their indices in order
/// and returns the count. Lights without a range are always kept. A culled light would add 0, so that no bit depends on
/// the other points of a batch.
/// @param out  [data::padded(lights.count)]
size_t cull_lights(const core::SimdTarget& simd, const LightTable& lights, const raster::Fragments& points,
                   uint32_t* out);

}  // namespace shd::shade
