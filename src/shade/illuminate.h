// SPDX-License-Identifier: MIT
#pragma once

#include "core/simd_target.h"
#include "material/material.h"
#include "raster/fragments.h"
#include "shade/columns.h"
#include "shade/light_table.h"

namespace shd::shade {

/// Derives the shape parameters of the lobes at `count` points, from their slots and the variance of slopes removed by
/// filtering normal maps (null = 0). Writes columns->shape. All columns of the result are null, that is, constant, if
/// there are neither such slots nor a variance, and for models without a shape.
LobeShape shape_lobes(const core::SimdTarget& simd, const material::Material& material,
                      const material::Parameters& parameters, const float* variance, size_t count, Columns* columns);

/// The lights of a batch may be processed in several groups, one call after the other.
struct LightGroup {
  bool continues;  // adds to the lobes instead of starting from 0
  bool finishes;   // last group: the lobes are normalised
};

/// Computes the lobes of the material's model at every point under `count` lights, summed in the order of the lights.
/// The result is the first info_of().lobes of `out`. Lobe 0 is diffuse and includes E. For models that ignore the
/// irradiance it is the sum of their weights, equal in all channels. Specular lobes include their normalisation and the
/// gain of `shape`.
///
/// Compared with the exact formulas, each light adds at most the following error, with E at normal incidence:
///   diffuse lobes       2e-6 E (measured 5.6e-7 E)
///   max(0, n.h)^p       2e-6 E, plus the change of the power when the cosine is off by d = 2.5e-7 (1 + 2 / |wo + l|),
///                       at most p d E: a short wo + l magnifies its own rounding (measured half of that); times
///                       N (n.l) in the normalised model
///   max(0, v.r)^p       as max(0, n.h)^p with d = 6e-7 (measured half of that)
///                       Both powers are 0 where they are below 2^-96.
///   metallic-roughness  E and the lobe times 6e-6 + 1e-6 (1 + 2 / |wo + l|) / alpha + 4e-7 / n.l + 4e-7 / n.v, plus
///                       1e-6 of the sum of both specular lobes, for narrow highlights and grazing angles (measured
///                       0.4 of that)
///   E itself            1e-6 I / r^2 with a range; for spots, the change of the cone when its cosine is off by 3e-7
///   Gooch               1e-6
/// With shape.spread, lobes are averaged over normals, as SHD_NORMAL_ENCODING_MOMENTS describes. Compared with the same
/// formulas, each light adds at most 2e-6 E, and for specular lobes the lobe times 2e-5 + 4e-6 / the deviation of
/// slopes for which the lobe falls to exp(-1/2) (measured 0.65 of that). Beyond 4 deviations the diffuse lobe may be 0.
/// Where n.l is within 1e-6 of 0, a gated specular lobe may be kept or dropped. Where a cosine is within its rounding
/// of a step of SHD_MODEL_TOON, either step may be taken.
void illuminate(const core::SimdTarget& simd, const material::Material& material, const LobeShape& shape,
                const ActiveLight* lights, size_t count, const raster::Fragments& points, LightGroup group,
                material::Lobes* out);

}  // namespace shd::shade
