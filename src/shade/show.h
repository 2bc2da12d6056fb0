// SPDX-License-Identifier: MIT
#pragma once

#include <shd/view.h>

#include "core/simd_target.h"
#include "material/material.h"
#include "raster/fragments.h"
#include "shade/columns.h"

namespace shd::shade {

/// What models without lights show of fragments. Those that look up textures write columns->lobes.lobe[0].

/// (n + 1) / 2.
void show_normals(const raster::Fragments& f, float* const out[3]);
/// The fractions of u and v, and 0.
void show_uv(const raster::Fragments& f, float* const out[3]);
void show_barycentrics(const raster::Fragments& f, float* const out[3]);
/// The level of detail of the diffuse texture over its last level: 0 blue, 1/2 green, 1 red. Blue without texture.
void show_levels(const core::SimdTarget& simd, const material::Material& material, const raster::Fragments& f,
                 Columns* columns);
/// The matcap slot by the direction of normals, of any length, in view space: 1 without texture.
void show_matcap(const core::SimdTarget& simd, const material::Material& material, const shd_view& view,
                 const raster::Fragments& f, Columns* columns);

/// Levels of detail of the diffuse slot's texture, after bias and clamps; 0 without. `scratch` holds lookups.
void find_levels(const core::SimdTarget& simd, const material::Material& material, const raster::Fragments& f,
                 float* const scratch[6], float* lod);

}  // namespace shd::shade
