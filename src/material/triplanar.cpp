// SPDX-License-Identifier: MIT
#include "material/triplanar.h"

#include <algorithm>
#include <cmath>

#include "data/box_sides.h"
#include "data/vec3.h"
#include "material/places.h"

namespace shd::material {
namespace {

using data::Vec3d;

/// Coordinate 0..1 along a direction on the cube from 0 to 1, as a row in world space.
void find_row(const double m[16], const data::Direction& direction, double out[4]) {
  for (int c = 0; c < 4; ++c) {
    const double at = m[4 * c + direction.axis];
    out[c] = direction.backwards ? (c == 3 ? 1.0 : 0.0) - at : at;
  }
}

TriplanarMap::Side map_side(const double m[16], const data::BoxSide& side, const float* t) {
  double right[4], down[4];
  find_row(m, side.right, right);
  find_row(m, side.down, down);
  TriplanarMap::Side out;
  for (int c = 0; c < 4; ++c) {
    const double u = double{t[0]} * right[c] + double{t[1]} * down[c];
    const double v = double{t[3]} * right[c] + double{t[4]} * down[c];
    out.u[c] = static_cast<float>(c == 3 ? u + double{t[2]} : u);
    out.v[c] = static_cast<float>(c == 3 ? v + double{t[5]} : v);
  }
  return out;
}

/// Cofactors with the sign of the determinant: the inverse transpose up to a positive factor. The largest one is 1 or
/// -1, or all are 0.
void map_normals(const double m[16], float (*out)[3]) {
  const auto row = [&](int r) { return Vec3d{m[r], m[4 + r], m[8 + r]}; };
  const Vec3d cofactors[3] = {cross(row(1), row(2)), cross(row(2), row(0)), cross(row(0), row(1))};
  double largest = 0.0;
  for (const Vec3d& c : cofactors) {
    largest = std::max({largest, std::fabs(c.x), std::fabs(c.y), std::fabs(c.z)});
  }
  const double scale = !(largest > 0.0) ? 0.0 : (dot(row(0), cofactors[0]) < 0.0 ? -1.0 : 1.0) / largest;
  for (int r = 0; r < 3; ++r) {
    out[r][0] = static_cast<float>(scale * cofactors[r].x);
    out[r][1] = static_cast<float>(scale * cofactors[r].y);
    out[r][2] = static_cast<float>(scale * cofactors[r].z);
  }
}

float power(float base, uint32_t exponent) {
  float out = 1.0f;
  for (uint32_t i = 0; i < exponent; ++i) out *= base;
  return out;
}

/// The rows of the side that each point faces, applied to (x, y, z), plus `last` times their constants.
void map_points(const float (&towards)[4], const float (&away)[4], bool is_place, const float* const (&p)[3],
                const raster::Fragments& points, const float (&n)[3], float factor, float* out) {
  const float last = is_place ? 1.0f : 0.0f;
  for (size_t i = 0; i < points.count; ++i) {
    const float facing = n[0] * points.nx[i] + n[1] * points.ny[i] + n[2] * points.nz[i];
    const float a = towards[0] * p[0][i] + towards[1] * p[1][i] + towards[2] * p[2][i] + towards[3] * last;
    const float b = away[0] * p[0][i] + away[1] * p[1][i] + away[2] * p[2][i] + away[3] * last;
    out[i] = factor * (facing < 0.0f ? b : a);
  }
}

}  // namespace

TriplanarMap triplanar_map(const Slot& slot, const float object_to_world[16]) {
  double m[16];
  find_place_matrix(slot, object_to_world, m);
  TriplanarMap map;
  for (int s = 0; s < 6; ++s) map.sides[s] = map_side(m, data::kBoxSides[s], slot.uv_transform);
  map_normals(m, map.normal);
  return map;
}

void find_weights(const TriplanarMap& map, uint32_t sharpness, const raster::Fragments& points, float* const out[3]) {
  for (size_t i = 0; i < points.count; ++i) {
    float size[3];
    for (int k = 0; k < 3; ++k) {
      const float* const n = map.normal[k];
      size[k] = std::fabs(n[0] * points.nx[i] + n[1] * points.ny[i] + n[2] * points.nz[i]);
    }
    const float largest = std::max(size[0], std::max(size[1], size[2]));
    if (!(largest > 0.0f) || !std::isfinite(size[0] + size[1] + size[2])) size[0] = size[1] = 0.0f, size[2] = 1.0f;
    const float unit = std::max(size[0], std::max(size[1], size[2]));
    for (float& s : size) s = power(s / unit, sharpness);
    const float sum = size[0] + size[1] + size[2];
    for (int k = 0; k < 3; ++k) out[k][i] = size[k] / sum;
  }
}

texture::Lookups lookups_along(const TriplanarMap& map, int axis, float factor, const raster::Fragments& points,
                               float* const* scratch) {
  const TriplanarMap::Side &towards = map.sides[2 * axis], &away = map.sides[2 * axis + 1];
  const float* const place[3] = {points.px, points.py, points.pz};
  const auto find = [&](bool is_place, const float* const(&p)[3], float scale, float* const* uv) {
    map_points(towards.u, away.u, is_place, p, points, map.normal[axis], scale, uv[0]);
    map_points(towards.v, away.v, is_place, p, points, map.normal[axis], scale, uv[1]);
  };
  find(true, place, 1.0f, scratch);
  texture::Lookups lookups = {};
  lookups.count = points.count;
  lookups.u = scratch[0];
  lookups.v = scratch[1];
  if (factor == 0.0f) return lookups;
  find(false, points.dpdx, factor, scratch + 2);
  find(false, points.dpdy, factor, scratch + 4);
  lookups.dudx = scratch[2];
  lookups.dvdx = scratch[3];
  lookups.dudy = scratch[4];
  lookups.dvdy = scratch[5];
  return lookups;
}

void add_weighted(size_t count, const float* weight, const float* value, float* sum) {
  for (size_t i = 0; i < count; ++i) sum[i] += weight[i] > 0.0f ? weight[i] * value[i] : 0.0f;
}

}  // namespace shd::material
