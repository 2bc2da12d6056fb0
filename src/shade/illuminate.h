// SPDX-License-Identifier: MIT
#pragma once

#include "core/simd_target.h"
#include "material/material.h"
#include "raster/fragments.h"
#include "shade/columns.h"
#include "shade/light_table.h"

namespace shd::shade {

/// Lights may come in groups, one after the other.
struct LightGroup {
  bool continues;  // adds to what there is, instead of starting from 0
  bool finishes;   // the last group: lobes get what is the same for all lights
};

/// Lobes of the material's model at every row under `count` lights, summed in their order: the model's first
/// info_of().lobes. The diffuse lobe comes first, times E; of Gooch's model it is the sum of (1 + n.l) / 2 without E,
/// in all channels alike. Specular lobes have their normalisation and the gain of `shape`.
///
/// Against the exact formulas each light adds at most, with E what arrives at normal incidence:
///   diffuse lobes           2e-6 E (measured 5.6e-7 E)
///   max(0, n.h)^p           2e-6 E and what a cosine off by d = 2.5e-7 (1 + 2 / |wo + l|) makes of the power, at most
///                           p d E: a short wo + l magnifies its own rounding (measured half of that). Times N (n.l) in
///                           the normalised model
///   max(0, v.r)^p           likewise with d = 6e-7 (measured half of that)
///   metallic-roughness      E and the lobe times 6e-6 + 1e-6 (1 + 2 / |wo + l|) / alpha + 4e-7 / n.l + 4e-7 / n.v, and
///                           1e-6 of both lobes' sum: of narrow highlights and grazing angles (measured 0.4 of that)
///   E itself                1e-6 I / r^2 with a range, and of spots what a cosine off by 3e-7 makes of the cone
///   Gooch                   1e-6
/// Where n.l is within 1e-6 of 0, a gated specular lobe may be kept or dropped, and where a cosine is within its
/// rounding of a step of SHD_MODEL_TOON, the next may come.
void illuminate(const core::SimdTarget& simd, const material::Material& material, const Shape& shape,
                const ActiveLight* lights, size_t count, const raster::Fragments& rows, LightGroup group, Lobes* out);

}  // namespace shd::shade
