// SPDX-License-Identifier: MIT
#include "texture/oracle/bounds/place.h"

#include <algorithm>
#include <cmath>

#include "core/status.h"
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

double down_to_grid(double x, double step) {
  return std::floor(x / step) * step;
}
double up_to_grid(double x, double step) {
  return std::ceil(x / step) * step;
}

Range clamped(const Range& range, double low, double high) {
  const auto clamp = [&](double x) { return std::min(std::max(x, low), high); };
  return {clamp(range.low), clamp(range.high)};
}

/// Points of a level, before they are rounded to a grid.
PointBox texels_at(const Plane& plane, const Place& place, const Reach& reach) {
  PointBox box = {};
  for (int a = 0; a < axes_of(plane.call->texture); ++a) {
    const auto n = static_cast<double>(plane.size[a]);
    const double error = place.error[a] * n;
    box.axis[a] = {(place.at[a] + reach.axis[a].low) * n - error, (place.at[a] + reach.axis[a].high) * n + error};
  }
  return box;
}

/// Adds lookups about all points of an image: rounding in either direction ends at most at the next points of the
/// grid. Images of directions end at `edge` images beyond their edges.
void add_on_image(const Plane& plane, PointBox box, double edge, Color* out) {
  const double step = plane.call->model.subtexel;
  for (int a = 0; a < axes_of(plane.call->texture); ++a) {
    Range& range = box.axis[a];
    range = {down_to_grid(range.low, step), up_to_grid(range.high, step)};
    const auto n = static_cast<double>(plane.size[a]);
    if (plane.call->texture.projection != SHD_PROJECTION_NONE) range = clamped(range, -edge * n, n + edge * n);
  }
  add_linear(plane, box, out);
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
  const auto unit = [](const Range& x) {
    const Range inside = clamped(x, -1.0, 1.0);
    return Range{0.5 * (inside.low + 1.0), 0.5 * (inside.high + 1.0)};
  };
  Plane other = plane;
  other.layer = part.face;
  const Place there = {{0.0, 0.0, 0.0}, {place.error[0], place.error[1], 0.0}, part.face};
  add_on_image(other, texels_at(other, there, {{unit(part.s), unit(part.t), {}}}), 0.0, out);
}

/// Points of the plane of an image, whose image is [-1, 1].
Range plane_range(const Place& place, const Reach& reach, int axis) {
  return {2.0 * (place.at[axis] + reach.axis[axis].low) - 1.0, 2.0 * (place.at[axis] + reach.axis[axis].high) - 1.0};
}

/// Adds the parts of a rectangle on a face and beyond its four edges.
void add_on_cube(const Plane& plane, const Place& place, const Reach& reach, Color* out) {
  const Range s = plane_range(place, reach, 0), t = plane_range(place, reach, 1);
  const auto touches = [](const Range& range) { return range.high >= -1.0 && range.low <= 1.0; };
  if (touches(s) && touches(t)) add_on_image(plane, texels_at(plane, place, reach), 0.0, out);
  const CubeFace& face = kCubeFaces[place.layer];
  const auto beyond = [&](int side, const Range& p, const Range& q) {
    add_projected(plane, place, project_beyond(face, side, p, q), out);
  };
  if (s.high > 1.0) beyond(face.right, {std::max(s.low, 1.0), s.high}, t);
  if (s.low < -1.0) beyond(-face.right, {s.low, std::min(s.high, -1.0)}, t);
  if (t.high > 1.0) beyond(face.down, s, {std::max(t.low, 1.0), t.high});
  if (t.low < -1.0) beyond(-face.down, s, {t.low, std::min(t.high, -1.0)});
}

/// The range of p / |(p, q)| over a rectangle: it is monotone in p and, on each side of 0, in q.
Range cosines(const Range& p, const Range& q) {
  const bool crosses = q.low <= 0.0 && q.high >= 0.0;
  if (crosses && p.low <= 0.0 && p.high >= 0.0) return {-1.0, 1.0};
  Range out;
  for (const double x : {p.low, p.high}) {
    for (const double y : {q.low, q.high}) out.add(x / std::sqrt(x * x + y * y));
    if (crosses) out.add(x < 0.0 ? -1.0 : 1.0);
  }
  return out;
}

/// The points at 2 - r on the other side of the disc: -(2 - r) times the unit vector.
Range folded(const Range& cosine, const Range& distance) {
  Range out;
  for (const double d : {distance.low, distance.high}) out.add(Range{-cosine.high * d, -cosine.low * d});
  return out;
}

/// Adds the parts of a rectangle inside and outside of a disc.
void add_on_disc(const Plane& plane, const Place& place, const Reach& reach, Color* out) {
  const auto wide = [&](int axis) { return widened(plane_range(place, reach, axis), 2.0 * place.error[axis]); };
  const Range p = wide(0), q = wide(1);
  const auto nearest = [](const Range& x) { return std::max(std::max(x.low, -x.high), 0.0); };
  const auto farthest = [](const Range& x) { return std::max(std::fabs(x.low), std::fabs(x.high)); };
  const auto length = [](double x, double y) { return std::sqrt(x * x + y * y); };
  const Range r = {length(nearest(p), nearest(q)), length(farthest(p), farthest(q))};
  if (r.low <= 1.0) add_on_image(plane, texels_at(plane, place, reach), 0.0, out);
  if (!(r.high > 1.0)) return;
  const Range distance = {std::max(2.0 - r.high, 0.0), std::max(2.0 - std::max(r.low, 1.0), 0.0)};
  const auto unit = [](const Range& x) { return Range{0.5 * (x.low + 1.0), 0.5 * (x.high + 1.0)}; };
  const Place centre = {{0.0, 0.0, 0.0}, {place.error[0], place.error[1], 0.0}, place.layer};
  const Reach there = {{unit(folded(cosines(p, q), distance)), unit(folded(cosines(q, p), distance)), {}}};
  add_on_image(plane, texels_at(plane, centre, there), 0.0, out);
}

}  // namespace

Place place_of(const BoundsCall& call, const double (&point)[3], uint32_t layer) {
  Place place = {{}, {}, layer};
  for (int a = 0; a < axes_of(call.texture); ++a) {
    place.at[a] = reduced(wrap_of(call, a), point[a]);
    place.error[a] = call.model.coordinate_error * std::max(1.0, std::fabs(point[a]));
  }
  return place;
}

void add_linear_at(const Plane& plane, const Place& place, const Reach& reach, Color* out) {
  switch (plane.call->texture.projection) {
    case SHD_PROJECTION_CUBE: return add_on_cube(plane, place, reach, out);
    case SHD_PROJECTION_MIRROR_BALL:
    case SHD_PROJECTION_ANGULAR: return add_on_disc(plane, place, reach, out);
    case SHD_PROJECTION_NONE:
    case SHD_PROJECTION_OCTAHEDRAL: return add_on_image(plane, texels_at(plane, place, reach), 1.0, out);
    case SHD_PROJECTION_LAT_LONG:
    case SHD_PROJECTION_MAX_ENUM: break;
  }
  SHD_UNREACHABLE();
}

void add_nearest_at(const Plane& plane, const Place& place, Color* out) {
  PointBox box = texels_at(plane, place, kHere);
  for (Range& range : box.axis) range.high = up_to_grid(range.high, plane.call->model.subtexel);
  add_nearest(plane, box, out);
}

}  // namespace shd::texture
