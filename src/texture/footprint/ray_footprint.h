// SPDX-License-Identifier: MIT
#pragma once

#include "data/vec3.h"

namespace shd::texture {

/// Change of (u, v) along one pixel step.
struct Step {
  float du, dv;
};

/// The surface around a hit.
struct Surface {
  data::Vec3d dpdu, dpdv;
};

/// Change of the hit point of a ray whose origin and direction change by `origin` and `direction_step` per pixel
/// step, in coordinates of the surface. 0 where it is not finite or the surface has no area.
Step step_of_differential(const Surface& surface, const data::Vec3d& direction, double distance,
                          const data::Vec3d& origin, const data::Vec3d& direction_step);

/// Axes of the ellipse that a cone of a width cuts out of the surface, in its coordinates.
struct ConeSteps {
  Step along, across;
};
ConeSteps steps_of_cone(const Surface& surface, const data::Vec3d& direction, double width);

}  // namespace shd::texture
