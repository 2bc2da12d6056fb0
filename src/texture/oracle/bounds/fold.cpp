// SPDX-License-Identifier: MIT
#include "texture/oracle/bounds/fold.h"

#include <algorithm>
#include <cmath>

#include "core/status.h"
#include "texture/oracle/bounds/cube.h"

namespace shd::texture {
namespace {

bool is_inside(int64_t i, int64_t size) {
  return i >= 0 && i < size;
}

/// The texel beside an edge of a face, on the adjacent face. Centres are odd or even numbers 1 - n..n - 1 on a cube of
/// half width n; a texel beyond an edge is the first one beside the edge.
Color beside_edge(const Plane& plane, int64_t i, int64_t j) {
  const int64_t n = plane.size[0], s = 2 * i + 1 - n, t = 2 * j + 1 - n;
  const CubeFace& from = kCubeFaces[plane.layer];
  const bool across = s < -n || s > n;
  int64_t vector[3];
  set_component(from.axis, n - 1, vector);
  set_component(from.right, across ? (s < 0 ? -n : n) : s, vector);
  set_component(from.down, across ? t : (t < 0 ? -n : n), vector);
  const int side = across ? (s < 0 ? -from.right : from.right) : (t < 0 ? -from.down : from.down);
  const uint32_t face = face_at(side);
  const int64_t x = (component(vector, kCubeFaces[face].right) + n - 1) / 2;
  const int64_t y = (component(vector, kCubeFaces[face].down) + n - 1) / 2;
  return stored_range(plane, face, x, y);
}

/// The missing texel beyond a corner: the average of the three texels around it.
Color beyond_corner(const Plane& plane, int64_t i, int64_t j) {
  const int64_t x = i < 0 ? 0 : plane.size[0] - 1, y = j < 0 ? 0 : plane.size[1] - 1;
  const Color three[3] = {stored_range(plane, plane.layer, x, y), beside_edge(plane, i, y), beside_edge(plane, x, j)};
  Color average;
  for (int c = 0; c < 4; ++c) {
    Range& to = average.channel[c] = {0.0, 0.0};
    for (const Color& color : three) to.low += color.channel[c].low / 3.0, to.high += color.channel[c].high / 3.0;
  }
  return average;
}

Color on_cube(const Plane& plane, int64_t i, int64_t j) {
  const bool across = !is_inside(i, plane.size[0]), down = !is_inside(j, plane.size[1]);
  if (across && down) return beyond_corner(plane, i, j);
  return across || down ? beside_edge(plane, i, j) : stored_range(plane, plane.layer, i, j);
}

/// Turns by half a circle about the middle of an edge lead inside.
Color on_octahedron(const Plane& plane, int64_t i, int64_t j) {
  const int64_t n = plane.size[0];
  const auto turned = [&](int64_t beyond) { return beyond < 0 ? -1 - beyond : 2 * n - 1 - beyond; };
  while (!is_inside(i, n) || !is_inside(j, n)) {
    if (!is_inside(i, n)) {
      i = turned(i);
      j = n - 1 - j;
    } else {
      j = turned(j);
      i = n - 1 - i;
    }
  }
  return stored_range(plane, plane.layer, i, j);
}

/// The texels that contain a coordinate, or lie within `error` of it.
void add_near(const Plane& plane, double x, double y, double error, Color* out) {
  const double last = static_cast<double>(plane.size[0] - 1);
  const auto index = [&](double at) { return static_cast<int64_t>(std::min(std::max(std::floor(at), 0.0), last)); };
  for (int64_t j = index(y - error); j <= index(y + error); ++j) {
    for (int64_t i = index(x - error); i <= index(x + error); ++i) out->add(stored_range(plane, plane.layer, i, j));
  }
}

/// Centres are (p, q) in half texels from the centre of a disc of radius n. For centres on the rim and points on
/// borders of texels, single precision may decide for either side.
Color on_disc(const Plane& plane, int64_t i, int64_t j) {
  constexpr double kError = 1e-6;
  const auto n = static_cast<double>(plane.size[0]);
  const double p = static_cast<double>(2 * i + 1) - n, q = static_cast<double>(2 * j + 1) - n;
  const double r = std::sqrt(p * p + q * q);
  const bool stored = is_inside(i, plane.size[0]) && is_inside(j, plane.size[1]);
  if (r <= n * (1.0 - kError) && stored) return stored_range(plane, plane.layer, i, j);
  Color out;
  if (r <= n * (1.0 + kError) && stored) out.add(stored_range(plane, plane.layer, i, j));
  const double inner = std::max(std::min(2.0 * n - r, n - 1.4142135623730951), 0.0);
  add_near(plane, 0.5 * (n - p * inner / r), 0.5 * (n - q * inner / r), n * kError, &out);
  return out;
}

}  // namespace

Color folded_range(const Plane& plane, int64_t i, int64_t j) {
  switch (plane.call->texture.projection) {
    case SHD_PROJECTION_CUBE: return on_cube(plane, i, j);
    case SHD_PROJECTION_OCTAHEDRAL: return on_octahedron(plane, i, j);
    case SHD_PROJECTION_MIRROR_BALL:
    case SHD_PROJECTION_ANGULAR: return on_disc(plane, i, j);
    case SHD_PROJECTION_LAT_LONG:
    case SHD_PROJECTION_NONE:
    case SHD_PROJECTION_MAX_ENUM: break;
  }
  SHD_UNREACHABLE();
}

bool folds_far(shd_projection projection) {
  switch (projection) {
    case SHD_PROJECTION_OCTAHEDRAL: return true;
    case SHD_PROJECTION_NONE:
    case SHD_PROJECTION_LAT_LONG:
    case SHD_PROJECTION_MIRROR_BALL:
    case SHD_PROJECTION_ANGULAR:
    case SHD_PROJECTION_CUBE:
    case SHD_PROJECTION_MAX_ENUM: break;
  }
  return false;
}

const char* bounds_refusal_of(shd_projection projection) {
  switch (projection) {
    case SHD_PROJECTION_LAT_LONG: return "LAT_LONG has no bounds: no standard defines its lookups along parallels";
    case SHD_PROJECTION_NONE:
    case SHD_PROJECTION_MIRROR_BALL:
    case SHD_PROJECTION_ANGULAR:
    case SHD_PROJECTION_CUBE:
    case SHD_PROJECTION_OCTAHEDRAL:
    case SHD_PROJECTION_MAX_ENUM: break;
  }
  return nullptr;
}

}  // namespace shd::texture
