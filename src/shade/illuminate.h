// SPDX-License-Identifier: MIT
#pragma once

#include "core/simd_target.h"
#include "material/material.h"
#include "raster/fragments.h"
#include "shade/columns.h"
#include "shade/light_table.h"

namespace shd::shade {

/// Diffuse and, for Blinn-Phong, specular lobes of every row under every light, summed in table order.
/// Relative error against the exact formula <= 2e-6 + exponent * 1e-6 of the largest term (the cosine's rounding,
/// raised to the exponent); tested.
void illuminate(const core::SimdTarget& simd, const material::Material& material, const LightTable& lights,
                const raster::Fragments& rows, Lobes* out);

}  // namespace shd::shade
