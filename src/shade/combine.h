// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "core/simd_target.h"
#include "material/material.h"
#include "shade/columns.h"
#include "shade/light_table.h"

namespace shd::shade {

/// What `count` rows send to the eye, from the lobes of the material's model (of models without lights the first lobe
/// is what they show) and the values of its slots, with the emission. Where the material has_opacity(), a is opacity
/// times its slots, and L is multiplied by a unless its blend takes them apart; else 1. |error| <= 12 half ulps of the
/// sum of the terms' magnitudes.
void combine(const core::SimdTarget& simd, const material::Material& material, const LightTable& lights,
             const Lobes& lobes, const Parameters& parameters, size_t count, Radiance* out);

/// out[i] = b0 in[row] + b1 in[row + 1] + b2 in[row + 2] with row = rows[i] and the barycentrics of row i.
void spread_corners(const core::SimdTarget& simd, const raster::Fragments& fragments, const uint32_t* rows,
                    const float* in, float* out);

/// out[i] = in[rows[i]].
void spread_centroids(const uint32_t* rows, size_t count, const float* in, float* out);

}  // namespace shd::shade
