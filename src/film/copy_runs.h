// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "core/simd_target.h"
#include "film/tile_planes.h"
#include "raster/fragments.h"

namespace shd::film {

/// Copies consecutive elements of four columns to the pixels of some runs. Writes no other pixels.
/// @param column  from the element of the first pixel of the first run on
void copy_runs(const core::SimdTarget& simd, const raster::PixelRun* runs, size_t count, const float* const column[4],
               const TilePlanes& planes);

}  // namespace shd::film
