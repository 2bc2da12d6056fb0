// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/simd_target.h"
#include "raster/fragments.h"
#include "shade/light_table.h"

namespace shd::shade {

/// Indices, in order, of the lights of a table whose range reaches the bounds of the points' positions. Lights without
/// a range are all kept. Culled lights would add 0, so no bit depends on the points of a batch. Returns the count.
/// @param out  [data::padded(lights.count)]
size_t cull_lights(const core::SimdTarget& simd, const LightTable& lights, const raster::Fragments& points,
                   uint32_t* out);

}  // namespace shd::shade
