// SPDX-License-Identifier: MIT
#include "texture/oracle/bounds/place.h"

#include <algorithm>
#include <cmath>

#include "texture/oracle/bounds/cube.h"

namespace shd::texture {
namespace {

/// A coordinate with the same texels, at the place and at every probe about it. 2 is a period of REPEAT and MIRROR.
/// Other wraps are constant beyond [-2, 3]. Lines of probes reach at most 128 texels, so at most 128 images.
double reduced(shd_wrap wrap, double u) {
  constexpr double kFar = 256.0;
  if (wrap == SHD_WRAP_REPEAT || wrap == SHD_WRAP_MIRROR) return std::fmod(u, 2.0);
  return std::min(std::max(u, -kFar), kFar);
}

bool is_cube(const Plane& plane) {
  return plane.texture->projection == SHD_PROJECTION_CUBE;
}

/// Points u + reach on an axis of n texels, before they are rounded to a grid.
Range texels_at(double u, const Range& reach, double n, double error) {
  return {(u + reach.low) * n - error, (u + reach.high) * n + error};
}

double down_to_grid(double x, double step) {
  return std::floor(x / step) * step;
}
double up_to_grid(double x, double step) {
  return std::ceil(x / step) * step;
}

/// Points from which lookups may filter: rounding in either direction ends at most at the next points of the grid.
Range on_grid(const Range& range, double step) {
  return {down_to_grid(range.low, step), up_to_grid(range.high, step)};
}

Range within_face(const Range& range, double n) {
  const auto clamp = [&](double x) { return std::min(std::max(x, 0.0), n); };
  return {clamp(range.low), clamp(range.high)};
}

void add_on_face(const Plane& plane, const Place& place, const Reach& reach, Color* out) {
  const auto width = static_cast<double>(plane.width), height = static_cast<double>(plane.height);
  const double step = plane.model->subtexel;
  Rect rect = {on_grid(texels_at(place.u, reach.u, width, place.error_u * width), step),
               on_grid(texels_at(place.v, reach.v, height, place.error_v * height), step)};
  if (is_cube(plane)) rect = {within_face(rect.x, width), within_face(rect.y, height)};
  add_bilinear(plane, rect, out);
}

/// The part of [-1, 1] x [-1, 1] of an adjacent face onto which a rectangle of the plane of a face projects. Each
/// coordinate of the projection is a quotient, which is monotone in both of its arguments.
struct Projected {
  uint32_t face;
  Range s, t;
};

Projected project_beyond(const CubeFace& from, int side, const Range& s, const Range& t) {
  Projected out = {face_at(side), {}, {}};
  const CubeFace& to = kCubeFaces[out.face];
  for (const double p : {s.low, s.high}) {
    for (const double q : {t.low, t.high}) {
      double vector[3];
      set_component(from.axis, 1.0, vector);
      set_component(from.right, p, vector);
      set_component(from.down, q, vector);
      const double length = component(vector, side);
      out.s.add(component(vector, to.right) / length);
      out.t.add(component(vector, to.down) / length);
    }
  }
  return out;
}

void add_projected(const Plane& plane, const Place& place, const Projected& part, Color* out) {
  const auto unit = [](double x) { return 0.5 * (std::min(std::max(x, -1.0), 1.0) + 1.0); };
  Plane other = plane;
  other.layer = part.face;
  const Place there = {0.0, 0.0, place.error_u, place.error_v, part.face};
  add_on_face(other, there, {{unit(part.s.low), unit(part.s.high)}, {unit(part.t.low), unit(part.t.high)}}, out);
}

/// Adds the parts of a rectangle beyond the four edges of a face.
void add_beyond_edges(const Plane& plane, const Place& place, const Reach& reach, Color* out) {
  const auto plane_of = [](double u, const Range& r) {
    return Range{2.0 * (u + r.low) - 1.0, 2.0 * (u + r.high) - 1.0};
  };
  const Range s = plane_of(place.u, reach.u), t = plane_of(place.v, reach.v);
  const CubeFace& face = kCubeFaces[place.layer];
  const auto beyond = [&](int side, const Range& p, const Range& q) {
    add_projected(plane, place, project_beyond(face, side, p, q), out);
  };
  if (s.high > 1.0) beyond(face.right, {std::max(s.low, 1.0), s.high}, t);
  if (s.low < -1.0) beyond(-face.right, {s.low, std::min(s.high, -1.0)}, t);
  if (t.high > 1.0) beyond(face.down, s, {std::max(t.low, 1.0), t.high});
  if (t.low < -1.0) beyond(-face.down, s, {t.low, std::min(t.high, -1.0)});
}

bool touches_face(const Place& place, const Reach& reach) {
  return place.u + reach.u.high >= 0.0 && place.u + reach.u.low <= 1.0 && place.v + reach.v.high >= 0.0 &&
         place.v + reach.v.low <= 1.0;
}

/// Derivatives of a point on a face: with s = p / r, ds = (dp r - p dr) / r^2 (Vulkan 1.3, "Cube Map Derivative
/// Transformation"). Products of floats are exact in double. A direction with an infinite change has infinite
/// derivatives.
Vector2 step_on_face(const CubeFace& face, const double (&n)[3], const double (&d)[3]) {
  for (const double change : d) {
    if (std::isinf(change)) return {HUGE_VAL, HUGE_VAL};
  }
  const double r = component(n, face.axis), dr = component(d, face.axis);
  const auto step = [&](int axis) { return 0.5 * (component(d, axis) * r - component(n, axis) * dr) / (r * r); };
  return {step(face.right), step(face.down)};
}

}  // namespace

Place place_of(const Sampler& sampler, const BoundsModel& model, double u, double v, uint32_t layer) {
  return {reduced(sampler.wrap_u, u), reduced(sampler.wrap_v, v), model.coordinate_error * std::max(1.0, std::fabs(u)),
          model.coordinate_error * std::max(1.0, std::fabs(v)), layer};
}

void add_bilinear_at(const Plane& plane, const Place& place, const Reach& reach, Color* out) {
  if (!is_cube(plane)) return add_on_face(plane, place, reach, out);
  if (touches_face(place, reach)) add_on_face(plane, place, reach, out);
  add_beyond_edges(plane, place, reach, out);
}

void add_nearest_at(const Plane& plane, const Place& place, Color* out) {
  const auto width = static_cast<double>(plane.width), height = static_cast<double>(plane.height);
  const double step = plane.model->subtexel;
  const Range here = {0.0, 0.0};
  Rect rect = {texels_at(place.u, here, width, place.error_u * width),
               texels_at(place.v, here, height, place.error_v * height)};
  rect.x.high = up_to_grid(rect.x.high, step);
  rect.y.high = up_to_grid(rect.y.high, step);
  add_nearest(plane, rect, out);
}

CubePlaces cube_places(const BoundsModel& model, const double (&direction)[3], const double (&dx)[3],
                       const double (&dy)[3]) {
  constexpr double kTie = 1.0 - 0x1p-20;
  double largest = 0.0;
  for (const double x : direction) largest = std::max(largest, std::fabs(x));
  CubePlaces out = {};
  for (uint32_t f = 0; f < 6 && out.count < 3; ++f) {
    const CubeFace& face = kCubeFaces[f];
    const double r = component(direction, face.axis);
    if (r < largest * kTie) continue;
    Place& place = out.place[out.count];
    const auto unit = [&](int axis) {
      return std::min(std::max(0.5 * (component(direction, axis) / r + 1.0), 0.0), 1.0);
    };
    place = {unit(face.right), unit(face.down), model.coordinate_error, model.coordinate_error, f};
    out.steps[out.count++] = {step_on_face(face, direction, dx), step_on_face(face, direction, dy)};
  }
  return out;
}

}  // namespace shd::texture
