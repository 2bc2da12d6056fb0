// SPDX-License-Identifier: MIT
/// @file
/// Points of lookups on levels: of a 2D image, or of a face of a cube. A rectangle of points that leaves a face
/// continues on the adjacent faces.
#pragma once

#include "texture/oracle/bounds/cells.h"
#include "texture/oracle/bounds/footprint.h"

namespace shd::texture {

/// A point of an image, normalised and reduced to two images at most, and the largest error of its coordinates.
struct Place {
  double u, v;
  double error_u, error_v;  // largest errors; they grow with the coordinate that was reduced
  uint32_t layer;           // or the face
};

/// Returns the point of finite coordinates of a 2D texture.
Place place_of(const Sampler& sampler, const BoundsModel& model, double u, double v, uint32_t layer);

/// Points of an image within a rectangle about a place.
struct Reach {
  Range u, v;  // normalised, relative to the place
};

/// Adds the values of bilinear lookups of a level.
void add_bilinear_at(const Plane& plane, const Place& place, const Reach& reach, Color* out);
/// Adds the texels of a level that nearest lookups read.
void add_nearest_at(const Plane& plane, const Place& place, Color* out);

/// The places of a direction: one on each face that it may belong to.
struct CubePlaces {
  int count;
  Place place[3];
  Steps steps[3];
};

/// Returns the places of a finite direction other than 0, with its derivatives, which may be infinite.
CubePlaces cube_places(const BoundsModel& model, const double (&direction)[3], const double (&dx)[3],
                       const double (&dy)[3]);

}  // namespace shd::texture
