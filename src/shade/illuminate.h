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
/// Against the exact formulas each light adds at most, with E what arrives at normal incidence: 2e-6 E to a diffuse
/// lobe (measured 3.7e-7 E); (2e-6 + 2.5e-7 p (1 + 2 / |wo + l|)) E to a specular one of exponent p: the cosine's
/// rounding, raised to the exponent, and magnified where wo and l nearly cancel (measured 1.9e-7 (2 + p) E where |wo +
/// l| > 1/2). Where n.l is within its rounding of 0, a gated specular lobe may be kept or dropped, and where a cosine
/// is within it of a step of SHD_MODEL_TOON, the next may come.
void illuminate(const core::SimdTarget& simd, const material::Material& material, const Shape& shape,
                const ActiveLight* lights, size_t count, const raster::Fragments& rows, LightGroup group, Lobes* out);

}  // namespace shd::shade
