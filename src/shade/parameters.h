// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/simd_target.h"
#include "material/material.h"
#include "raster/fragments.h"
#include "raster/varyings.h"
#include "shade/columns.h"
#include "shade/run.h"

namespace shd::shade {

/// Rows whose slots are looked up.
struct SlotRows {
  const DrawShading& shading;
  const raster::Fragments& rows;
  const raster::Varyings& varyings;
  bool has_footprint;  // else level 0
};

/// Where a slot's texture is looked up at rows, in its uv set through its transform. `scratch` is part of the answer.
texture::Lookups lookups_of(const material::Slot& slot, const raster::Fragments& rows, bool has_footprint,
                            float* const scratch[6]);
inline texture::Lookups lookups_of(const material::Slot& slot, const SlotRows& where, Columns* columns) {
  return lookups_of(slot, where.rows, where.has_footprint, columns->uv);
}

/// Values at rows of those `slots` (bits) that are set, but for height and matcap: in columns->slot, or of vertices
/// where they are; null where the mesh lacks the attribute, but of normals, whose channels are all there. Slots that
/// read the same texels share their lookups, which have the bits of lookups of their own. Throws Failure if a procedure
/// threw.
void look_up_slots(const core::SimdTarget& simd, const SlotRows& where, uint32_t slots, Columns* columns,
                   Parameters* out);

}  // namespace shd::shade
