// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/simd_target.h"
#include "material/material.h"
#include "material/slot_lookup.h"
#include "raster/fragments.h"
#include "raster/varyings.h"
#include "shade/columns.h"
#include "shade/run.h"

namespace shd::shade {

/// The points at which slots are looked up.
struct SlotContext {
  const DrawShading& shading;
  const raster::Fragments& points;
  const raster::Varyings& varyings;
  bool has_footprint;  // otherwise level 0 is used
};

/// Lookups of a slot's texture. They may use columns->uv as storage.
inline texture::Lookups lookups_of(const material::Slot& slot, const SlotContext& context, Columns* columns) {
  return material::lookups_of(slot, context.points, context.shading.object_to_world, context.has_footprint,
                              columns->uv);
}

/// Looks up the values at points of all `slots` (bits) that are set, except height and matcap. The columns are
/// columns->slot, or for vertex attributes the columns of the points. An attribute that the mesh lacks is null, but all
/// channels of normals are columns. The tint is multiplied into the diffuse slot. Slots with
/// equal lookups share them; the bits equal those of separate lookups.
/// Throws Failure if a procedure threw.
void look_up_slots(const core::SimdTarget& simd, const SlotContext& context, uint32_t slots, Columns* columns,
                   material::Parameters* out);

}  // namespace shd::shade
