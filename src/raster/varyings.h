// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <shd/vertices.h>

#include "core/allocator.h"
#include "core/simd_target.h"
#include "geometry/vertex.h"
#include "raster/fragments.h"

namespace shd::raster {

/// Varyings of vertex programs at the rows of a batch: columns of kColumn elements in one block. Empty if no draw of
/// the frame has varyings.
struct Varyings {
  core::Array<float> block;
  float* column[SHD_MAX_VARYINGS] = {};
};

/// Allocates `count` columns. Throws std::bad_alloc.
void allocate(const core::Allocator& allocator, uint32_t count, Varyings* out);

/// Interpolates the varyings of `fragments`, whose barycentrics and triangles must be set. Rows past count up to the
/// next whole vector must repeat the last one. Elements past that vector may change.
///
/// PERSPECTIVE blends by the perspective-correct barycentrics. AFFINE blends by the screen-space barycentrics: the
/// areas between the point (x, y) and the projected vertices (X / W, Y / W) of the unclipped triangle, clamped to it.
/// AFFINE falls back to PERSPECTIVE where a vertex has W < kMinW or |X| or |Y| > 2^60 W, and where the projected
/// triangle has no area. FLAT copies the first vertex. A varying that is equal at all three vertices keeps its bits in
/// every row; finite varyings give finite rows.
/// @param modes  [vertices.varying_count]
void interpolate_varyings(const core::SimdTarget& simd, const geometry::Vertices& vertices,
                          const shd_interpolation* modes, const Fragments& fragments, Varyings* out);

}  // namespace shd::raster
