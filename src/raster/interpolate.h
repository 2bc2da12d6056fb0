// SPDX-License-Identifier: MIT
#pragma once

#include "core/simd_target.h"
#include "geometry/vertex.h"
#include "raster/fragments.h"

namespace shd::raster {

/// Fills position, normal, wo, uv, derivatives and barycentrics of `fragments` from x, y and the three vertices.
/// Rows past count up to the next whole vector must repeat the last row.
///
/// Barycentrics of the pixel centre come from the unclipped vertices in homogeneous raster coordinates (Olano and
/// Greer, "Triangle Scan Conversion Using 2D Homogeneous Coordinates", 1997), so clipping does not touch attributes;
/// they are clamped to the triangle. Derivatives are the exact ones of that quotient; 0 where they leave the range of
/// float. Finite vertices give finite rows. The error is that of the cross products: a pixel position rounded to 2^-24
/// of its value, over the triangle's size. Largest |error| of a barycentric coordinate measured in a frame of 2048^2:
/// 5e-5 for triangles of 1 to 300 pixels, 4e-3 for 0.1 pixel.
void interpolate(const core::SimdTarget& simd, const geometry::Vertices& vertices, const float eye[3],
                 Fragments* fragments);

}  // namespace shd::raster
