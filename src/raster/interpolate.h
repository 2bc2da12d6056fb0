// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/simd_target.h"
#include "geometry/vertex.h"
#include "raster/fragments.h"

namespace shd::raster {

/// Columns of Fragments that are interpolated from vertices, as bits.
enum Interpolated : uint32_t {
  kPosition = 1,
  kNormal = 2,
  kToEye = 4,
  kTexture = 8,  // uv and its derivatives
  kBarycentrics = 16,
  kTexture1 = 32,  // second uv set and its derivatives
  kTangent = 64,
  kAttributes = 128,
  kInterpolateAll = 255,  // columns that programs read
  kPositionSteps = 256    // derivatives of the position
};

/// Fills the wanted columns (Interpolated bits) of `fragments` from x, y and the three vertices; other columns are left
/// unchanged. Rows past count up to the next whole vector must repeat the last row.
///
/// Barycentrics of the pixel centre are computed from the unclipped vertices in homogeneous raster coordinates (Olano
/// and Greer, "Triangle Scan Conversion Using 2D Homogeneous Coordinates", 1997), so that clipping does not change
/// attributes; they are clamped to the triangle. Triangles whose vertices have one w (2D and parallel projections) have
/// the same derivatives at all pixels. Without a second uv set or tangents in the vertices, these columns are
/// 0; absent attributes are left unchanged. Derivatives are exact derivatives of the quotient, or 0 if they overflow
/// float. Finite vertices give finite rows. The error is that of the cross products: a pixel position rounded to 2^-24
/// of its value, divided by the size of the triangle. Largest |error| of a barycentric coordinate measured in a frame
/// of 2048^2: 5e-5 for triangles of 1 to 300 pixels, 4e-3 for 0.1 pixel.
void interpolate(const core::SimdTarget& simd, const geometry::Vertices& vertices, const float eye[3], uint32_t wanted,
                 Fragments* fragments);

}  // namespace shd::raster
