// SPDX-License-Identifier: MIT
#include "material/projected.h"

#include <cmath>

#include "material/places.h"

namespace shd::material {
namespace {

/// Rows of the numerators of u and v, and of their denominator.
struct ProjectedMap {
  float u[4], v[4], w[4];
};

ProjectedMap projected_map(const Slot& slot, const float object_to_world[16]) {
  double m[16];
  find_place_matrix(slot, object_to_world, m);
  const float* const t = slot.uv_transform;
  ProjectedMap map;
  for (int c = 0; c < 4; ++c) {
    const double x = m[4 * c], y = m[4 * c + 1], w = m[4 * c + 3];
    map.u[c] = static_cast<float>(double{t[0]} * x + double{t[1]} * y + double{t[2]} * w);
    map.v[c] = static_cast<float>(double{t[3]} * x + double{t[4]} * y + double{t[5]} * w);
    map.w[c] = static_cast<float>(w);
  }
  return map;
}

/// The derivatives of the quotients u and v by a step of the position: (dx - u dw) / w.
void find_steps(const ProjectedMap& map, float factor, const raster::Fragments& points, const float* const (&step)[3],
                const float* w, float* const uv[2], float* const out[2]) {
  for (int k = 0; k < 2; ++k) {
    const float *const m = k ? map.v : map.u, *const n = map.w, *const at = uv[k];
    const float *x = step[0], *y = step[1], *z = step[2];
    for (size_t i = 0; i < points.count; ++i) {
      const float over = m[0] * x[i] + m[1] * y[i] + m[2] * z[i];
      const float under = n[0] * x[i] + n[1] * y[i] + n[2] * z[i];
      out[k][i] = factor * ((over - at[i] * under) / w[i]);
    }
  }
}

}  // namespace

texture::Lookups projected_lookups(const Slot& slot, const raster::Fragments& points, const float object_to_world[16],
                                   bool has_footprint, float* const* scratch) {
  const ProjectedMap map = projected_map(slot, object_to_world);
  const auto row = [&](const float(&m)[4], size_t i) {
    return m[0] * points.px[i] + m[1] * points.py[i] + m[2] * points.pz[i] + m[3];
  };
  float *const u = scratch[0], *const v = scratch[1], *const w = scratch[6];
  for (size_t i = 0; i < points.count; ++i) {
    w[i] = row(map.w, i);
    u[i] = row(map.u, i) / w[i];
    v[i] = row(map.v, i) / w[i];
  }
  texture::Lookups lookups = {};
  lookups.count = points.count;
  lookups.u = u;
  lookups.v = v;
  if (has_footprint) {
    find_steps(map, slot.place_width, points, points.dpdx, w, scratch, scratch + 2);
    find_steps(map, slot.place_width, points, points.dpdy, w, scratch, scratch + 4);
    lookups.dudx = scratch[2];
    lookups.dvdx = scratch[3];
    lookups.dudy = scratch[4];
    lookups.dvdy = scratch[5];
  }
  for (size_t i = 0; i < points.count; ++i) {
    if (w[i] > 0.0f && std::isfinite(u[i]) && std::isfinite(v[i])) continue;
    u[i] = v[i] = -1.0f;
    for (int k = 2; k < 6 && has_footprint; ++k) scratch[k][i] = 0.0f;
  }
  return lookups;
}

}  // namespace shd::material
