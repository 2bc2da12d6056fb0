// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "texture/oracle/bounds/filters.h"

namespace shd::texture {
namespace {

constexpr double kPiece = 0.5;       // longest piece of a line [texels]
constexpr double kMostPieces = 256;  // half a line of 128 texels

/// Points t d for t in a range, or -t d, with the error of the direction.
Reach points_of(const Vector2& d, const Range& t, double sign, double slop_u, double slop_v) {
  Reach reach;
  for (const double at : {t.low, t.high}) {
    reach.u.add(sign * at * d.u);
    reach.v.add(sign * at * d.v);
  }
  return {widened(reach.u, slop_u), widened(reach.v, slop_v)};
}

void add_average(const Color& a, const Color& b, Color* out) {
  out->add(mix(a, b, 0.5));
}

/// The line is cut into pieces. Both probes of a pair lie on pieces of one number, whose values are bounded apart.
void add_line(const Plane& plane, const Place& place, const Vector2& d, double reach, Color* out) {
  const auto width = static_cast<double>(plane.width), height = static_cast<double>(plane.height);
  const double texels = reach * std::max(std::fabs(d.u) * width, std::fabs(d.v) * height);
  const double pieces = std::max(std::ceil(texels / kPiece), 1.0);
  if (!(pieces <= kMostPieces)) return add_everywhere(plane, out);
  const double slop = 1e-4 * std::max(1.0, texels / 16.0);
  const auto count = static_cast<int>(pieces);
  for (int k = 0; k < count; ++k) {
    const Range t = {reach * k / count, reach * (k + 1) / count};
    Color ahead, behind;
    add_bilinear_at(plane, place, points_of(d, t, 1.0, slop / width, slop / height), &ahead);
    add_bilinear_at(plane, place, points_of(d, t, -1.0, slop / width, slop / height), &behind);
    add_average(ahead, behind, out);
  }
}

/// Both probes of a pair lie anywhere in a square about the place.
void add_disc(const Plane& plane, const Place& place, const Texture& texture, const Vector2& d, double reach,
              Color* out) {
  const double u = d.u * texture.width, v = d.v * texture.height, radius = reach * std::sqrt(u * u + v * v);
  const Range across = {-radius / texture.width, radius / texture.width};
  const Range down = {-radius / texture.height, radius / texture.height};
  add_bilinear_at(plane, place, {across, down}, out);
}

}  // namespace

void add_probes(const BoundsCall& call, uint32_t level, const Place& place, const BoundsFootprint& footprint,
                Color* out) {
  const Plane plane = plane_of(call.texture, call.sampler, call.model, call.reference, place.layer, level);
  if (footprint.everywhere) return add_everywhere(plane, out);
  if (footprint.reach == 0.0 || footprint.axis_count == 0) {
    return add_bilinear_at(plane, place, {{0.0, 0.0}, {0.0, 0.0}}, out);
  }
  for (int k = 0; k < footprint.axis_count; ++k) {
    add_line(plane, place, footprint.axis[k], footprint.reach, out);
  }
  if (footprint.round) add_disc(plane, place, call.texture, footprint.axis[0], footprint.reach, out);
}

}  // namespace shd::texture
