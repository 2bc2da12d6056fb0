// SPDX-License-Identifier: MIT
#pragma once

#include "texture/oracle/bounds/footprint.h"
#include "texture/oracle/bounds/place.h"

namespace shd::texture {

/// The places of a direction with the derivatives of its points: one on each face of a cube, or on each side of a fold,
/// that it may belong to. None if the direction may be at any point.
struct DirectionPlaces {
  int count;
  Place place[4];
  Steps steps[4];
};

/// Returns the places of a finite direction other than 0, with its derivatives, which may be infinite. The projection
/// is not LAT_LONG. `layer` has no effect on a cube.
DirectionPlaces places_of(const BoundsCall& call, const double (&direction)[3], const double (&dx)[3],
                          const double (&dy)[3], uint32_t layer);

}  // namespace shd::texture
