// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/simd_target.h"
#include "raster/fragments.h"

namespace shd::raster {

/// Appends a row for each pixel of some runs of one triangle: sets pixel, mask, triangle, x and y, at the centre of the
/// pixel. The table must have room for these rows; up to 15 rows past them may change.
void append_rows(const core::SimdTarget& simd, const PixelRun* runs, size_t count, uint32_t triangle, Fragments* f);

}  // namespace shd::raster
