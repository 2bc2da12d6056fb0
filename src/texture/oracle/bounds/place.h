// SPDX-License-Identifier: MIT
/// @file
/// Points of lookups on levels: of an image, or of a face of a cube. A box of points that leaves an image of directions
/// continues where the directions do (fold.h).
#pragma once

#include "texture/oracle/bounds/cells.h"

namespace shd::texture {

/// A point of an image, normalised and reduced to two images at most, and the largest error of its coordinates. The
/// third axis is that of 3D textures.
struct Place {
  double at[3];
  double error[3];  // they grow with the coordinate that was reduced
  uint32_t layer;   // or the face
};

/// Returns the point of finite coordinates of a texture without a projection.
Place place_of(const BoundsCall& call, const double (&point)[3], uint32_t layer);

/// Points of an image within a box about a place.
struct Reach {
  Range axis[3];  // normalised, relative to the place
};

/// The place alone.
constexpr Reach kHere = {{{0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}}};

/// Adds the values of linear lookups of a level.
void add_linear_at(const Plane& plane, const Place& place, const Reach& reach, Color* out);
/// Adds the texels of a level that nearest lookups read.
void add_nearest_at(const Plane& plane, const Place& place, Color* out);

}  // namespace shd::texture
