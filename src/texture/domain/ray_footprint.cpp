// SPDX-License-Identifier: MIT
// Arithmetic is in double, where products of four floats neither overflow nor underflow, so no scaling is needed.
#include "texture/domain/ray_footprint.h"

#include <cmath>
#include <limits>

namespace shd::texture {
namespace {

using data::Vec3d;

/// Returns a / |a|, by the reciprocal of the length. Unlike data::normalized(), the result is not finite if `a` is 0;
/// the footprint is then 0.
Vec3d unit_of(const Vec3d& a) {
  return (1.0 / std::sqrt(dot(a, a))) * a;
}

/// Returns whether the value is in the range of float.
bool is_representable(double value) {
  return std::fabs(value) <= static_cast<double>(std::numeric_limits<float>::max());
}

/// Expresses a vector in the surface as a combination of dp/du and dp/dv, by the normal equations.
Step in_surface(const Surface& surface, const Vec3d& change) {
  const double uu = dot(surface.dpdu, surface.dpdu), uv = dot(surface.dpdu, surface.dpdv);
  const double vv = dot(surface.dpdv, surface.dpdv);
  const double u = dot(surface.dpdu, change), v = dot(surface.dpdv, change);
  const Vec3d normal = cross(surface.dpdu, surface.dpdv);
  const double area = dot(normal, normal);  // uu vv - uv^2 without its cancellation
  const double du = (vv * u - uv * v) / area, dv = (uu * v - uv * u) / area;
  if (!is_representable(du) || !is_representable(dv)) return {0.0f, 0.0f};
  return {static_cast<float>(du), static_cast<float>(dv)};
}

}  // namespace

Step step_of_differential(const Surface& surface, const Vec3d& direction, double distance, const Vec3d& origin,
                          const Vec3d& direction_step) {
  const Vec3d normal = cross(surface.dpdu, surface.dpdv);
  const Vec3d moved = origin + distance * direction_step;
  const double back = dot(moved, normal) / dot(direction, normal);
  return in_surface(surface, moved - back * direction);
}

ConeSteps steps_of_cone(const Surface& surface, const Vec3d& direction, double width) {
  constexpr double kMinCosine = 0x1p-10;
  const Vec3d normal = unit_of(cross(surface.dpdu, surface.dpdv)), ray = unit_of(direction);
  const double cosine = dot(ray, normal);
  const Vec3d projected = ray - cosine * normal;
  const double sine = dot(projected, projected);
  // A cone perpendicular to the surface cuts out a circle: every direction is an axis.
  const Vec3d along = unit_of(sine > 0.0 ? projected : surface.dpdu);
  const double slant = std::fabs(cosine) > kMinCosine ? std::fabs(cosine) : kMinCosine;
  // The cosine of a ray that is not finite is NaN; pass it on, so that the footprint is 0.
  const double length = cosine == cosine ? width / slant : cosine;
  return {in_surface(surface, length * along), in_surface(surface, width * cross(normal, along))};
}

}  // namespace shd::texture
