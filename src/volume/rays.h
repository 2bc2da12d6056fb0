// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <shd/view.h>

#include "data/vec3.h"

namespace shd::volume {

using data::Vec3d;

/// Rays of the pixels of a picture, in double precision.
struct Lens {
  double clip_to_world[16];  // column-major
  double to_ndc[4];          // pixel centre (x, y) to NDC: x to_ndc[0] + to_ndc[1], y to_ndc[2] + to_ndc[3]
  double near_depth;         // depth at the eye's end of the rays, 0 or 1
  bool is_valid;             // the view can be inverted
};

/// @param viewport    left, top, width and height of the target of NDC -1..1 [pixels]
/// @param depth_falls depth decreases with the distance
Lens make_lens(const shd_view& view, const double (&viewport)[4], bool depth_falls);

/// The part of the line of sight of a pixel between the clip planes.
struct Sight {
  Vec3d origin;     // at the near plane, world space
  Vec3d direction;  // away from the viewer, unit
  double end;       // distance of the far plane, may be infinite
  bool is_valid;
};

Sight sight_of(const Lens& lens, double x, double y);

/// Returns the distance along a sight at which a depth lies.
double distance_of(const Lens& lens, const Sight& sight, double x, double y, double depth);

/// World space to the box of a volume, where it is [0, 1]^3. Row-major 3 x 4.
struct WorldToBox {
  double row[3][4];
};

/// @param object_to_world  column-major, affine
/// Returns false if the matrix cannot be inverted.
bool make_world_to_box(const float (&object_to_world)[16], const double (&box_min)[3], const double (&box_max)[3],
                       WorldToBox* out);

/// A ray through the box of a volume in equal steps. Point t of the ray, in steps, lies at origin + t step in the box,
/// and at world_origin + t world_step.
struct Ray {
  float origin[3], step[3];
  float world_origin[3], world_step[3];
  float dt;        // length of a step [world units]
  float offset;    // the point of step k lies at k + offset, 0..1
  uint32_t count;  // steps
};

/// Cuts a sight by a box and by `end`. Returns false if nothing is left.
bool make_ray(const Sight& sight, const WorldToBox& box, double end, float step, Ray* out);

}  // namespace shd::volume
