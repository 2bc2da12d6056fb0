// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "texture/oracle/bounds/filters.h"

namespace shd::texture {
namespace {

constexpr double kPiece = 0.5;       // longest piece of a line [texels]
constexpr double kMostPieces = 256;  // half a line of 128 texels

/// Points t d for t in a range, or -t d, with the error of the direction [texels].
Reach points_of(const Plane& plane, const Vector& d, const Range& t, double sign, double slop) {
  Reach reach;
  for (int c = 0; c < 3; ++c) {
    for (const double at : {t.low, t.high}) reach.axis[c].add(sign * at * d.part[c]);
    reach.axis[c] = widened(reach.axis[c], slop / static_cast<double>(plane.size[c]));
  }
  return reach;
}

void add_average(const Color& a, const Color& b, Color* out) {
  out->add(mix(a, b, 0.5));
}

/// Whether the error of the place covers every point of the image, so that all probes have the same values.
bool is_anywhere(const Plane& plane, const Place& place) {
  bool anywhere = true;
  for (int a = 0; a < axes_of(plane.call->texture); ++a) anywhere = anywhere && place.error[a] >= 1.0;
  return anywhere;
}

/// The line is cut into pieces. Both probes of a pair lie on pieces of one number, whose values are bounded apart.
void add_line(const Plane& plane, const Place& place, const Vector& d, double reach, double error, Color* out) {
  double texels = 0.0;
  for (int c = 0; c < 3; ++c) {
    texels = std::max(texels, reach * std::fabs(d.part[c]) * static_cast<double>(plane.size[c]));
  }
  const double pieces = std::max(std::ceil(texels / kPiece), 1.0);
  if (!(pieces <= kMostPieces)) return add_everywhere(plane, out);
  const double slop = 1e-4 * std::max(1.0, texels / 16.0) + reach * error;
  const int count = is_anywhere(plane, place) ? 1 : static_cast<int>(pieces);
  for (int k = 0; k < count; ++k) {
    const Range t = {reach * k / count, reach * (k + 1) / count};
    Color ahead, behind;
    add_linear_at(plane, place, points_of(plane, d, t, 1.0, slop), &ahead);
    add_linear_at(plane, place, points_of(plane, d, t, -1.0, slop), &behind);
    add_average(ahead, behind, out);
  }
}

/// Both probes of a pair lie anywhere in a box about the place.
void add_disc(const Plane& plane, const Place& place, const BoundsFootprint& footprint, Color* out) {
  const Texture& texture = plane.call->texture;
  const double size[3] = {static_cast<double>(texture.width), static_cast<double>(texture.height),
                          static_cast<double>(std::max(texture.depth, 1u))};
  double squares = 0.0;
  for (int c = 0; c < 3; ++c) {
    const double x = footprint.axis[0].part[c] * size[c];
    squares += x * x;
  }
  const double radius = footprint.reach * (std::sqrt(squares) + footprint.slop);
  Reach reach;
  for (int c = 0; c < 3; ++c) reach.axis[c] = {-radius / size[c], radius / size[c]};
  add_linear_at(plane, place, reach, out);
}

}  // namespace

void add_probes(const BoundsCall& call, uint32_t level, const Place& place, const BoundsFootprint& footprint,
                Color* out) {
  const Plane plane = plane_of(call, place.layer, level);
  if (footprint.everywhere) return add_everywhere(plane, out);
  if (footprint.reach == 0.0 || footprint.axis_count == 0) return add_linear_at(plane, place, kHere, out);
  const double error = footprint.slop * static_cast<double>(plane.size[0]) / static_cast<double>(call.texture.width);
  for (int k = 0; k < footprint.axis_count; ++k) {
    add_line(plane, place, footprint.axis[k], footprint.reach, error, out);
  }
  if (footprint.round) add_disc(plane, place, footprint, out);
}

}  // namespace shd::texture
