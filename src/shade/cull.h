// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/simd_target.h"
#include "raster/fragments.h"
#include "shade/light_table.h"

namespace shd::shade {

/// Indices of the lights of a table whose range reaches the box around the rows' positions, in order; all without a
/// range. What is left out gives nothing: no bit depends on which rows come together. Returns how many there are.
/// @param out  [data::padded(lights.count)]
size_t cull_lights(const core::SimdTarget& simd, const LightTable& lights, const raster::Fragments& rows,
                   uint32_t* out);

}  // namespace shd::shade
