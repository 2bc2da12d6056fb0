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

/// Returns the change of the hit point of a ray in coordinates of the surface. The origin and the direction of the ray
/// change by `origin` and `direction_step` per pixel step. The result is 0 if it is not finite or the surface has no
/// area.
Step step_of_differential(const Surface& surface, const data::Vec3d& direction, double distance,
                          const data::Vec3d& origin, const data::Vec3d& direction_step);

/// Axes of the ellipse that a ray cone cuts out of the surface, in coordinates of the surface.
struct ConeSteps {
  Step along, across;
};

/// Returns the axes of the ellipse of a cone with the given width at the hit point.
ConeSteps steps_of_cone(const Surface& surface, const data::Vec3d& direction, double width);

}  // namespace shd::texture
