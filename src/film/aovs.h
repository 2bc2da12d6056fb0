// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/simd_target.h"
#include "film/framebuffer.h"
#include "film/tile_area.h"
#include "material/material.h"
#include "raster/fragments.h"

namespace shd::film {

/// Scratch of one batch, used by frames with AOVs.
struct AovScratch {
  uint16_t row[raster::kBatch];  // fragments visible at the first sample of their pixel, in order
  size_t row_count;
  float lod[raster::kBatch];
  uint32_t level[raster::kBatch];
  uint32_t draw[raster::kBatch];
};

/// The columns, as raster::Interpolated bits, from which the planes of shd_aov bits are written.
uint32_t columns_of(uint32_t aovs);

/// Lists the fragments that are visible at the first sample of their pixel.
void find_rows(const raster::Fragments& fragments, AovScratch* scratch);

/// The draw of a batch.
struct AovDraw {
  const material::Material& material;
  const float* object_to_world;  // [16]
  uint32_t index;                // in the frame
};

/// Writes every AOV except overdraw, for the listed rows of a shaded batch of one draw. `scratch_uv` has
/// material::kLookupScratch columns.
void write_aovs(const core::SimdTarget& simd, const TileArea& area, const AovDraw& draw,
                const raster::Fragments& fragments, float* const* scratch_uv, AovScratch* scratch,
                Framebuffer* framebuffer);

/// Adds one to the overdraw count of a pixel; the framebuffer must have SHD_PLANE_OVERDRAW.
void count_overdraw(const TileArea& area, uint32_t pixel, Framebuffer* framebuffer);

}  // namespace shd::film
