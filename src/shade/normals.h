// SPDX-License-Identifier: MIT
#pragma once

#include "core/simd_target.h"
#include "material/material.h"
#include "raster/fragments.h"
#include "shade/columns.h"

namespace shd::shade {

/// Turns the rows' normals by values of a normal map, [4] columns: through the rows' tangents t and bitangents tw (n x
/// t), or any frame around n where t is 0, within 1e-4 of n's line, or its square not finite. Writes what the map lost
/// to `variance`, scaled as its slopes and at most 1e30, where its encoding tells. A normal stays where the turned one
/// would be 0 or is not finite. |error| <= 6e-7 |m| / |turned m| for texels m, of XY over z.
void map_normals(const core::SimdTarget& simd, const material::Material& material, const float* const map[4],
                 raster::Fragments* rows, float* variance);

/// Turns them by a map's tilt alone: (x, y, 1) through the tangents.
void tilt_normals(const core::SimdTarget& simd, const float* const tilt[2], raster::Fragments* rows);

/// Turns them by the gradient of a height: tilt holds its derivatives in u and v, frame dp/du and dp/dv
/// (Mikkelsen, "Bump Mapping Unparametrized Surfaces on the GPU", 2010). A normal stays where frame spans no area, or
/// one below 1.2e-38, and where the turned one is not finite. |error| <= 1e-6 over the cosine of the frame's skew and
/// tilt.
void bump_normals(const core::SimdTarget& simd, const float* const tilt[2], const float* const frame[6],
                  raster::Fragments* rows);

/// Exponents and roughness of rows, from their slots and what normal maps lost (null = nothing), where there is any of
/// that: 1 / p' = 1 / p + variance, with the gain (1 + p') / (1 + p) that keeps the light of lobes without factor
/// (Toksvig, "Mipmapping Normal Maps", 2005); alpha^2 + 2 variance, at most 1.
Shape shape_lobes(const core::SimdTarget& simd, const material::Material& material, const Parameters& parameters,
                  const float* variance, size_t count, Columns* columns);

}  // namespace shd::shade
