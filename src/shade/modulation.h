// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "core/simd_target.h"
#include "raster/fragments.h"
#include "shade/columns.h"
#include "shade/light_table.h"

namespace shd::shade {

/// Whether something stands between a light and the rows.
inline bool is_modulated(const light::Light& light, const light::Shadow* shadow) {
  return light.texture || shadow;
}

/// Keeps the rows' normals for shadows, which go by the surface without maps and bumps.
void keep_shadow_normals(const raster::Fragments& rows, Columns* columns);

/// What the texture of a light and its shadow, null = none, leave of it at rows, in columns->factor[k]; columns->uv is
/// scratch.
ActiveLight modulate(const core::SimdTarget& simd, const light::Light& light, const light::Shadow* shadow,
                     const raster::Fragments& rows, size_t k, Columns* columns);

}  // namespace shd::shade
