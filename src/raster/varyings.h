// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <shd/vertices.h>

#include "core/allocator.h"
#include "core/simd_target.h"
#include "geometry/vertex.h"
#include "raster/fragments.h"

namespace shd::raster {

/// Varyings of vertex programs at the rows of a batch: columns of kBatch elements in one block. Empty if no draw of the
/// frame has varyings.
struct Varyings {
  core::Array<float> block;
  float* column[SHD_MAX_VARYINGS] = {};
};

/// Room for `count` columns. Throws std::bad_alloc.
void allocate(const core::Allocator& allocator, uint32_t count, Varyings* out);

/// Varyings of `fragments`, whose barycentrics and vertices are there; rows past count up to the next whole vector
/// repeat the last one, and rows are sorted by triangle.
///
/// PERSPECTIVE blends by the barycentrics, AFFINE by those on the screen: the areas between the place (x, y) and the
/// projected vertices (X / W, Y / W) of the unclipped triangle, clamped to it. It falls back to PERSPECTIVE where a
/// vertex has W < kMinW or |X| or |Y| > 2^60 W, and where the triangle has no area there. FLAT copies. A varying that
/// is the same at all three vertices is that at every row, to the bit; finite ones give finite rows.
/// @param modes  [vertices.varying_count]
void interpolate_varyings(const core::SimdTarget& simd, const geometry::Vertices& vertices,
                          const shd_interpolation* modes, const Fragments& fragments, Varyings* out);

}  // namespace shd::raster
