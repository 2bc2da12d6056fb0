// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/simd_target.h"
#include "raster/fragments.h"
#include "raster/planes.h"

namespace shd::raster {

/// Runs of pixels of one triangle in one cell, which are the rows of a table in their order.
struct TrianglePixels {
  TrianglePlanes planes;  // planes of the triangle in the cell, with the first uv set
  int32_t left, top;      // first pixel of the tile in the picture
  const PixelRun* run;    // [run_count]
  size_t run_count;
};

/// Fills texture coordinates and their derivatives at the pixels' centres, with the bits of interpolate(). At most
/// kBatch rows; elements of the columns past the last row may change.
void interpolate_texture(const core::SimdTarget& simd, const TrianglePixels& pixels, Fragments* out);

}  // namespace shd::raster
