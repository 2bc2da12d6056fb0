// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "core/simd_target.h"
#include "raster/fragments.h"
#include "shade/columns.h"
#include "shade/light_table.h"

namespace shd::shade {

/// Whether a cookie or a shadow modulates a light.
inline bool is_modulated(const light::Light& light, const light::Shadow* shadow) {
  return light.cookie || shadow;
}

/// Copies the points' normals to columns->shadow_normal, because shadows use the surface without normal maps and bumps.
void keep_shadow_normals(const raster::Fragments& points, Columns* columns);

/// Computes the factors of a light's cookie and shadow (null = none) at points, in columns->factor[k], and returns the
/// light with these factors. Overwrites columns->uv and columns->visibility.
ActiveLight modulate(const core::SimdTarget& simd, const light::Light& light, const light::Shadow* shadow,
                     const raster::Fragments& points, size_t k, Columns* columns);

}  // namespace shd::shade
