// SPDX-License-Identifier: MIT
#pragma once

#include "material/slot.h"
#include "raster/fragments.h"

namespace shd::material {

/// Returns the lookups of a texture that a slide projector throws: SHD_SLOT_COORDINATES_PROJECTED. The uv transform is
/// a part of the matrix. |error| of u and v <= 1e-6, plus the change when the point moves by 2e-7 of its coordinates.
/// @param scratch  [7] columns for the lookups and the denominator
texture::Lookups projected_lookups(const Slot& slot, const raster::Fragments& points, const float object_to_world[16],
                                   bool has_footprint, float* const* scratch);

}  // namespace shd::material
