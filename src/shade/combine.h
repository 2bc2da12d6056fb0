// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "core/simd_target.h"
#include "material/material.h"
#include "shade/columns.h"
#include "shade/light_table.h"

namespace shd::shade {

/// Radiance of `count` points towards the eye, including emission, from the lobes of the material's model and the
/// values of its slots. A model without lobes provides its colour in lobe 0. a is the opacity times its slots if the
/// material has_opacity(), otherwise 1. L is multiplied by a unless the blend mode is opaque or straight. |error| <= 12
/// half ulps of the sum of the terms' magnitudes. Returns count_nonfinite().
size_t combine(const core::SimdTarget& simd, const material::Material& material, const LightTable& lights,
               const material::Lobes& lobes, const material::Parameters& parameters, size_t count, Radiance* out);

/// Returns the number of rows whose colour has a channel that is not finite.
size_t count_nonfinite(const core::SimdTarget& simd, const Radiance& radiance, size_t count);

/// out[i] = b0 in[k] + b1 in[k + 1] + b2 in[k + 2] with k = points[i] and the barycentrics of fragment i.
void spread_corners(const core::SimdTarget& simd, const raster::Fragments& fragments, const uint32_t* points,
                    const float* in, float* out);

/// out[i] = in[points[i]].
void spread_centroids(const uint32_t* points, size_t count, const float* in, float* out);

}  // namespace shd::shade
