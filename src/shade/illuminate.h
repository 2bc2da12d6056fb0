// SPDX-License-Identifier: MIT
#pragma once

#include "core/simd_target.h"
#include "material/material.h"
#include "raster/fragments.h"
#include "shade/columns.h"
#include "shade/light_table.h"

namespace shd::shade {

/// Diffuse and, for Blinn-Phong, specular lobes of every row under every light, summed in table order.
/// Against the exact formula each light adds an error of at most 2e-6 E to a diffuse lobe (measured 3.7e-7 E), and of
/// (2e-6 + 2.5e-7 p (1 + 2 / |wo + l|)) E to a specular one with exponent p: the cosine's rounding, raised to the
/// exponent, and magnified where wo and l nearly cancel (measured 1.9e-7 (2 + p) E where |wo + l| > 1/2). E is what
/// arrives at normal incidence. Where n.l is within its rounding of 0, a gated specular lobe may be kept or dropped.
void illuminate(const core::SimdTarget& simd, const material::Material& material, const LightTable& lights,
                const raster::Fragments& rows, Lobes* out);

}  // namespace shd::shade
