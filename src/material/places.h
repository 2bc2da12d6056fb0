// SPDX-License-Identifier: MIT
#pragma once

#include "material/slot.h"
#include "raster/fragments.h"

namespace shd::material {

/// Rows of an affine map from world space to the places of a slot.
struct PlaceMap {
  float row[3][4];
};

/// Finds the matrix of a slot that reads places, column-major: its place_transform times the map from world space to
/// its space.
void find_place_matrix(const Slot& slot, const float object_to_world[16], double out[16]);

/// Returns find_place_matrix() of an affine place_transform as a map.
PlaceMap place_map(const Slot& slot, const float object_to_world[16]);

/// Finds the places of points: columns x, y, z.
void find_places(const PlaceMap& map, const raster::Fragments& points, float* const out[3]);

/// Finds `factor` times the width of a pixel: the longer one of the derivatives of the place by pixel steps.
void find_widths(const PlaceMap& map, float factor, const raster::Fragments& points, float* out);

/// Finds `factor` times the derivatives of the place by pixel steps: columns of x, y, z to the right, then down.
void find_steps(const PlaceMap& map, float factor, const raster::Fragments& points, float* const out[6]);

}  // namespace shd::material
