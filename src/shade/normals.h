// SPDX-License-Identifier: MIT
#pragma once

#include "core/simd_target.h"
#include "material/material.h"
#include "raster/fragments.h"
#include "shade/columns.h"

namespace shd::shade {

/// Replaces the points' normals by the values of a normal map, [4] columns, in the frame of tangent t and bitangent
/// tw (n x t); any frame around n where t is 0, within 1e-4 of the line of n, or its square is not finite. Writes the
/// variance of slopes that the map has lost to `variance`, scaled like its slopes, at most 1e30; 0 unless its encoding
/// holds it. Normals that would become 0 or not finite stay. |error| <= 6e-7 |m| / |result| for texels m, with XY
/// over z.
void map_normals(const core::SimdTarget& simd, const material::Material& material, const float* const map[4],
                 raster::Fragments* points, float* variance);

/// Replaces the points' normals by (tilt[0], tilt[1], 1) in the same frame.
void tilt_normals(const core::SimdTarget& simd, const float* const tilt[2], raster::Fragments* points);

/// Tilts the points' normals by the gradient of a height: `tilt` holds its derivatives in u and v, `tangent_frame`
/// dp/du and dp/dv (Mikkelsen, "Bump Mapping Unparametrized Surfaces on the GPU", 2010). Normals stay where the frame
/// spans an area below 1.2e-38, and where the result is not finite. |error| <= 1e-6 over the cosine of the frame's skew
/// and of the tilt.
void bump_normals(const core::SimdTarget& simd, const float* const tilt[2], const float* const tangent_frame[6],
                  raster::Fragments* points);

}  // namespace shd::shade
