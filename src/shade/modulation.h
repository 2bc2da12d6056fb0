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

/// Copies the points' normals to columns->shadow_normal: shadows use the surface without maps and bumps.
void keep_shadow_normals(const raster::Fragments& points, Columns* columns);

/// A light with the factors that its cookie and its shadow (null = none) have at points, in columns->factor[k].
/// Overwrites columns->uv and columns->visibility.
ActiveLight modulate(const core::SimdTarget& simd, const light::Light& light, const light::Shadow* shadow,
                     const raster::Fragments& points, size_t k, Columns* columns);

}  // namespace shd::shade
