// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "core/simd_target.h"
#include "material/material.h"
#include "raster/fragments.h"
#include "shade/columns.h"
#include "shade/light_table.h"

namespace shd::shade {

/// Lobes of the model at points in the light of an environment. The model reflects environments. If `parameters` is not
/// null, points are fragments: the lobes times the occlusion of the material are added to `out`. `widening` is a
/// variance of slopes that is added to the lobes, null = 0.
void surround(const core::SimdTarget& simd, const material::Material& material, const LobeShape& shape,
              const EnvironmentLight& environment, const raster::Fragments& points,
              const material::Parameters* parameters, const float* widening, material::Lobes* out);

/// Adds the environment's part of lobes, times the occlusion of the material.
void add_surroundings(const core::SimdTarget& simd, const material::Material& material,
                      const material::Parameters& parameters, const material::Lobes& environment, size_t count,
                      material::Lobes* lobes);

}  // namespace shd::shade
