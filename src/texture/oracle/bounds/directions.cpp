// SPDX-License-Identifier: MIT
#include "texture/oracle/bounds/directions.h"

#include <algorithm>
#include <cmath>

#include "core/status.h"
#include "data/trig.h"
#include "texture/oracle/bounds/cube.h"

namespace shd::texture {
namespace {

/// Directions this near to an edge or a fold may be on either side.
constexpr double kTie = 0x1p-20;

using Direction = double[3];

bool is_infinite(const Direction& d) {
  return std::isinf(d[0]) || std::isinf(d[1]) || std::isinf(d[2]);
}
double sum_of_parts(const Direction& d) {
  return std::fabs(d[0]) + std::fabs(d[1]) + std::fabs(d[2]);
}

/// Adds a place. step(d) is the derivative of the point with a change d of the direction. A direction with an infinite
/// change has infinite derivatives. An error of arithmetic changes the parts of step(d) by `growth` |d| times the error
/// of coordinates.
template <class Step>
void add_place(const BoundsCall& call, double u, double v, uint32_t layer, const Direction& dx, const Direction& dy,
               double growth, const Step& step, DirectionPlaces* out) {
  const auto unit = [](double x) { return std::min(std::max(x, 0.0), 1.0); };
  const auto any_step = [&](const Direction& d) {
    return is_infinite(d) ? Vector{{HUGE_VAL, HUGE_VAL, 0.0}} : step(d);
  };
  const double error = call.model.coordinate_error;
  out->place[out->count] = {{unit(u), unit(v), 0.0}, {error, error, 0.0}, layer};
  out->steps[out->count++] = {any_step(dx), any_step(dy), error * growth * sum_of_parts(dx),
                              error * growth * sum_of_parts(dy)};
}

/// Derivatives of a point on a face: with s = p / r, ds = (dp r - p dr) / r^2 (Vulkan 1.3, "Cube Map Derivative
/// Transformation"). Products of floats are exact in double.
void add_cube(const BoundsCall& call, const Direction& n, const Direction& dx, const Direction& dy,
              DirectionPlaces* out) {
  const double largest = std::max(std::max(std::fabs(n[0]), std::fabs(n[1])), std::fabs(n[2]));
  for (uint32_t f = 0; f < 6 && out->count < 3; ++f) {
    const CubeFace& face = kCubeFaces[f];
    const double r = component(n, face.axis);
    if (r < largest * (1.0 - kTie)) continue;
    const auto step = [&](const Direction& d) {
      const double dr = component(d, face.axis);
      const auto part = [&](int axis) { return 0.5 * (component(d, axis) * r - component(n, axis) * dr) / (r * r); };
      return Vector{{part(face.right), part(face.down), 0.0}};
    };
    const auto at = [&](int axis) { return 0.5 * (component(n, axis) / r + 1.0); };
    add_place(call, at(face.right), at(face.down), f, dx, dy, 0.0, step, out);
  }
}

/// One octant of an octahedron (Cigolle et al., "A Survey of Efficient Representations for Independent Unit Vectors",
/// 2014).
void add_octant(const BoundsCall& call, const Direction& n, const double (&sign)[3], const Direction& dx,
                const Direction& dy, uint32_t layer, DirectionPlaces* out) {
  const double sum = sum_of_parts(n), p = n[0] / sum, q = n[1] / sum;
  const bool behind = sign[2] < 0.0;
  const double a = behind ? sign[0] * (1.0 - std::fabs(q)) : p, b = behind ? sign[1] * (1.0 - std::fabs(p)) : q;
  const auto step = [&](const Direction& d) {
    const double dsum = sign[0] * d[0] + sign[1] * d[1] + sign[2] * d[2];
    const double dp = (d[0] - p * dsum) / sum, dq = (d[1] - q * dsum) / sum, both = sign[0] * sign[1];
    return Vector{{0.5 * (behind ? -both * dq : dp), -0.5 * (behind ? -both * dp : dq), 0.0}};
  };
  add_place(call, 0.5 + 0.5 * a, 0.5 - 0.5 * b, layer, dx, dy, 1.0 / sum, step, out);
}

void add_octahedron(const BoundsCall& call, const Direction& n, const Direction& dx, const Direction& dy,
                    uint32_t layer, DirectionPlaces* out) {
  const double tie = kTie * sum_of_parts(n);
  for (int octant = 0; octant < 8; ++octant) {
    double sign[3];
    bool possible = true;
    for (int c = 0; c < 3; ++c) {
      sign[c] = octant >> c & 1 ? -1.0 : 1.0;
      possible = possible && sign[c] * n[c] >= -tie;
    }
    if (possible) add_octant(call, n, sign, dx, dy, layer, out);
  }
}

/// The distance f of a direction from the centre of a disc of radius 1, its derivative with the angle from +Z, and f
/// divided by the distance rho of the direction from the Z axis. f is sin(a / 2) of MIRROR_BALL and a / pi of ANGULAR.
struct Radius {
  double f, slope, per_rho;
};

Radius radius_of(const BoundsCall& call, double rho, double z, double length) {
  if (call.texture.projection == SHD_PROJECTION_ANGULAR) {
    const double f = data::angle_of(rho, z) / data::kPi;
    return {f, 1.0 / data::kPi, rho > 0.0 ? f / rho : 1.0 / (data::kPi * z)};
  }
  // The larger one of sin(a / 2) and cos(a / 2) has no cancellation, and gives the other one.
  const double large = std::sqrt(0.5 * (length + std::fabs(z)) / length), small = 0.5 * rho / (length * large);
  if (z < 0.0) return {large, 0.5 * small, large / rho};
  return {small, 0.5 * large, 0.5 / (length * large)};
}

void add_disc(const BoundsCall& call, const Direction& n, const Direction& dx, const Direction& dy, uint32_t layer,
              DirectionPlaces* out) {
  const double rho = std::sqrt(n[0] * n[0] + n[1] * n[1]), length = std::sqrt(rho * rho + n[2] * n[2]);
  if (n[2] < 0.0 && rho <= kTie * length) return;  // -Z is every point of the rim
  const double x = rho > 0.0 ? n[0] / rho : 1.0, y = rho > 0.0 ? n[1] / rho : 0.0;
  const Radius radius = radius_of(call, rho, n[2], length);
  const auto step = [&](const Direction& d) {
    const double outwards = x * d[0] + y * d[1], around = x * d[1] - y * d[0];
    const double along = 0.5 * radius.slope * (n[2] * outwards - rho * d[2]) / (length * length);
    const double across = 0.5 * radius.per_rho * around;
    return Vector{{along * x - across * y, -(along * y + across * x), 0.0}};
  };
  add_place(call, 0.5 + 0.5 * radius.f * x, 0.5 - 0.5 * radius.f * y, layer, dx, dy,
            radius.slope / length + radius.per_rho, step, out);
}

}  // namespace

DirectionPlaces places_of(const BoundsCall& call, const double (&direction)[3], const double (&dx)[3],
                          const double (&dy)[3], uint32_t layer) {
  DirectionPlaces out = {};
  switch (call.texture.projection) {
    case SHD_PROJECTION_CUBE: add_cube(call, direction, dx, dy, &out); return out;
    case SHD_PROJECTION_OCTAHEDRAL: add_octahedron(call, direction, dx, dy, layer, &out); return out;
    case SHD_PROJECTION_MIRROR_BALL:
    case SHD_PROJECTION_ANGULAR: add_disc(call, direction, dx, dy, layer, &out); return out;
    case SHD_PROJECTION_LAT_LONG:
    case SHD_PROJECTION_NONE:
    case SHD_PROJECTION_MAX_ENUM: break;
  }
  SHD_UNREACHABLE();
}

}  // namespace shd::texture
