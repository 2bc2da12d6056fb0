// SPDX-License-Identifier: MIT
// In double: products of four floats neither overflow nor underflow there, so nothing has to be scaled.
#include "texture/footprint/ray_footprint.h"

#include <cmath>
#include <limits>

namespace shd::texture {
namespace {

Triple operator+(const Triple& a, const Triple& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Triple operator-(const Triple& a, const Triple& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Triple operator*(double s, const Triple& a) {
  return {s * a.x, s * a.y, s * a.z};
}
double dot(const Triple& a, const Triple& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
Triple cross(const Triple& a, const Triple& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Triple normalized(const Triple& a) {
  return (1.0 / std::sqrt(dot(a, a))) * a;
}

/// Whether a float can hold it.
bool is_representable(double value) {
  return std::fabs(value) <= static_cast<double>(std::numeric_limits<float>::max());
}

/// A vector in the surface as a combination of dp/du and dp/dv, by the normal equations.
Step in_surface(const Surface& surface, const Triple& change) {
  const double uu = dot(surface.dpdu, surface.dpdu), uv = dot(surface.dpdu, surface.dpdv);
  const double vv = dot(surface.dpdv, surface.dpdv);
  const double u = dot(surface.dpdu, change), v = dot(surface.dpdv, change);
  const Triple normal = cross(surface.dpdu, surface.dpdv);
  const double area = dot(normal, normal);  // uu vv - uv^2 without its cancellation
  const double du = (vv * u - uv * v) / area, dv = (uu * v - uv * u) / area;
  if (!is_representable(du) || !is_representable(dv)) return {0.0f, 0.0f};
  return {static_cast<float>(du), static_cast<float>(dv)};
}

}  // namespace

Step step_of_differential(const Surface& surface, const Triple& direction, double distance, const Triple& origin,
                          const Triple& direction_step) {
  const Triple normal = cross(surface.dpdu, surface.dpdv);
  const Triple moved = origin + distance * direction_step;
  const double back = dot(moved, normal) / dot(direction, normal);
  return in_surface(surface, moved - back * direction);
}

ConeSteps steps_of_cone(const Surface& surface, const Triple& direction, double width) {
  constexpr double kLeastCosine = 0x1p-10;
  const Triple normal = normalized(cross(surface.dpdu, surface.dpdv)), ray = normalized(direction);
  const double cosine = dot(ray, normal);
  const Triple projected = ray - cosine * normal;
  const double sine = dot(projected, projected);
  // A cone that meets the surface head on cuts out a circle: any direction will do.
  const Triple along = normalized(sine > 0.0 ? projected : surface.dpdu);
  const double slant = std::fabs(cosine) > kLeastCosine ? std::fabs(cosine) : kLeastCosine;
  // A ray that is not finite has no cosine: let it give no footprint.
  const double length = cosine == cosine ? width / slant : cosine;
  return {in_surface(surface, length * along), in_surface(surface, width * cross(normal, along))};
}

}  // namespace shd::texture
