// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "core/simd_target.h"
#include "material/material.h"
#include "shade/columns.h"
#include "shade/light_table.h"

namespace shd::shade {

/// L = k_a I_a + k_d t D + k_s S for `count` rows, with D and S the lobes and t the texture (null = 1); k_d t without
/// lobes. Where the
/// material has_opacity(), a is that times t, and L times a unless its blend takes them apart; else 1.
void combine(const core::SimdTarget& simd, const material::Material& material, const LightTable& lights,
             const Lobes* lobes, const float* const texture[4], size_t count, Radiance* out);

/// out[i] = b0 in[row] + b1 in[row + 1] + b2 in[row + 2] with row = rows[i] and the barycentrics of row i.
void spread_corners(const core::SimdTarget& simd, const raster::Fragments& fragments, const uint32_t* rows,
                    const float* in, float* out);

/// out[i] = in[rows[i]].
void spread_centroids(const uint32_t* rows, size_t count, const float* in, float* out);

}  // namespace shd::shade
