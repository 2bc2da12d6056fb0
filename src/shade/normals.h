// SPDX-License-Identifier: MIT
#pragma once

#include "core/simd_target.h"
#include "material/material.h"
#include "raster/fragments.h"
#include "shade/columns.h"

namespace shd::shade {

/// Replaces the points' normals by the values of a normal map without moments, [4] columns, in the frame of tangent t
/// and bitangent tw (n x t). Where t is 0, within 1e-4 of the line of n, or has a non-finite square, any frame around n
/// is used. Writes to `variance` the variance of slopes removed by filtering the map, scaled like its slopes, at most
/// 1e30; it is 0 unless the encoding contains it. A normal is not replaced by a zero or non-finite result.
/// |error| <= 6e-7 |m| / |result| for texels m; for SHD_NORMAL_ENCODING_XY also divided by z.
void map_normals(const core::SimdTarget& simd, const material::Material& material, const float* const map[4],
                 raster::Fragments* points, float* variance);

/// As map_normals() for SHD_NORMAL_ENCODING_MOMENTS, with the mixed moments, or null for slopes without covariance.
/// Writes the covariance of slopes removed by filtering the map, scaled like its slopes, to `spread` as
/// LobeShape::spread. Variances are at most 1e9; values that are not finite give 0.
void map_moments(const core::SimdTarget& simd, const material::Material& material, const float* const map[4],
                 const float* mixed, raster::Fragments* points, float* const spread[6]);

/// Replaces the points' normals by (tilt[0], tilt[1], 1) in the frame of map_normals().
void tilt_normals(const core::SimdTarget& simd, const float* const tilt[2], raster::Fragments* points);

/// Tilts the points' normals by the gradient of a height: `tilt` contains its derivatives in u and v, `tangent_frame`
/// contains dp/du and dp/dv (Mikkelsen, "Bump Mapping Unparametrized Surfaces on the GPU", 2010). A normal is left
/// unchanged where the frame spans an area below 1.2e-38, and where the result is not finite. |error| <= 1e-6 over the
/// cosine of the frame's skew and of the tilt.
void bump_normals(const core::SimdTarget& simd, const float* const tilt[2], const float* const tangent_frame[6],
                  raster::Fragments* points);

}  // namespace shd::shade
