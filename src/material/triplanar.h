// SPDX-License-Identifier: MIT
#pragma once

#include "material/slot.h"
#include "raster/fragments.h"

namespace shd::material {

/// Maps from world space to the coordinates of the six sides of a box: SHD_SLOT_COORDINATES_TRIPLANAR.
struct TriplanarMap {
  struct Side {
    float u[4], v[4];  // rows of affine maps; the uv transform is a part of them
  };
  Side sides[6];       // in the order of data::kBoxSides
  float normal[3][3];  // rows of the map of normals to the space of places, up to a positive factor
};

TriplanarMap triplanar_map(const Slot& slot, const float object_to_world[16]);

/// Finds the weights of the lookups along x, y and z; their sum is 1. |error| <= 1e-6 * sharpness against the normal.
void find_weights(const TriplanarMap& map, uint32_t sharpness, const raster::Fragments& points, float* const out[3]);

/// Returns the lookups on the sides of an axis that the points face.
/// @param factor   factor of the derivatives; 0 = no derivatives
/// @param scratch  [6] columns for the lookups
texture::Lookups lookups_along(const TriplanarMap& map, int axis, float factor, const raster::Fragments& points,
                               float* const* scratch);

/// sum += weight * value where the weight is above 0.
void add_weighted(size_t count, const float* weight, const float* value, float* sum);

}  // namespace shd::material
