// SPDX-License-Identifier: MIT
// Visible triangles after painting, and pairs in the wrong order, by examining every sample and every pair.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "raster_ref.h"

namespace shd::ref {

constexpr size_t kNothing = ~size_t{0};

/// The last triangle that covers the centre of a pixel.
inline size_t painted_last(const geometry::ScreenTriangle* triangles, size_t count, int x, int y) {
  for (size_t i = count; i-- > 0;) {
    if (covers(triangles[i], x, y)) return i;
  }
  return kNothing;
}

/// The nearest triangle at the centre of a pixel; `sign` is -1 if depth decreases with the distance.
inline size_t nearest(const geometry::ScreenTriangle* triangles, size_t count, int x, int y, double sign = 1.0) {
  size_t found = kNothing;
  double best = 0.0;
  for (size_t i = 0; i < count; ++i) {
    if (!covers(triangles[i], x, y)) continue;
    const double distance = sign * depth_at(triangles[i], x, y).value;
    if (found == kNothing || distance < best) best = distance;
    if (best == distance) found = i;
  }
  return found;
}

/// The plane of depth through three vertices.
struct DepthPlane {
  Real x0, y0, z0, dx, dy;
};
inline DepthPlane plane_of(const geometry::ScreenTriangle& t) {
  const Real x1 = t.x[1] - t.x[0], y1 = t.y[1] - t.y[0], x2 = t.x[2] - t.x[0], y2 = t.y[2] - t.y[0];
  const Real z0 = t.z[0], z1 = t.z[1] - z0, z2 = t.z[2] - z0, area = x1 * y2 - x2 * y1;
  return {Real(t.x[0]), Real(t.y[0]), z0, (z1 * y2 - z2 * y1) / area, (z2 * x1 - z1 * x2) / area};
}
inline Real depth_on(const DepthPlane& p, Real x, Real y) {
  return p.z0 + p.dx * (x - p.x0) + p.dy * (y - p.y0);
}

/// Largest distance by which `a` is nearer than `b` in their overlap, minus one grid step and 2^-23; -inf if they do
/// not overlap. The corners of the overlap are vertices of one triangle inside the other, and crossings of edges.
inline double nearer_by(const geometry::ScreenTriangle& a, const geometry::ScreenTriangle& b) {
  const DepthPlane pa = plane_of(a), pb = plane_of(b);
  double found = -HUGE_VAL;
  Real low_x = 0, low_y = 0, high_x = 0, high_y = 0;
  bool any = false;
  const auto take = [&](Real x, Real y) {
    found = std::max(found, static_cast<double>(depth_on(pb, x, y) - depth_on(pa, x, y)));
    low_x = any ? std::min(low_x, x) : x;
    high_x = any ? std::max(high_x, x) : x;
    low_y = any ? std::min(low_y, y) : y;
    high_y = any ? std::max(high_y, y) : y;
    any = true;
  };
  const auto cross = [](const geometry::ScreenTriangle& t, int k, Real x, Real y) {
    const int n = (k + 1) % 3;
    return Real(t.x[n] - t.x[k]) * (y - t.y[k]) - Real(t.y[n] - t.y[k]) * (x - t.x[k]);
  };
  const auto inside = [&](const geometry::ScreenTriangle& t, Real x, Real y) {
    return cross(t, 0, x, y) >= 0 && cross(t, 1, x, y) >= 0 && cross(t, 2, x, y) >= 0;
  };
  for (int k = 0; k < 3; ++k) {
    if (inside(b, a.x[k], a.y[k])) take(a.x[k], a.y[k]);
    if (inside(a, b.x[k], b.y[k])) take(b.x[k], b.y[k]);
    for (int i = 0; i < 3; ++i) {
      const int n = (i + 1) % 3, m = (k + 1) % 3;
      const Real s0 = cross(a, k, b.x[i], b.y[i]), s1 = cross(a, k, b.x[n], b.y[n]);
      const Real r0 = cross(b, i, a.x[k], a.y[k]), r1 = cross(b, i, a.x[m], a.y[m]);
      if ((s0 < 0) == (s1 < 0) || (r0 < 0) == (r1 < 0)) continue;
      const Real s = s0 / (s0 - s1);
      take(b.x[i] + s * (b.x[n] - b.x[i]), b.y[i] + s * (b.y[n] - b.y[i]));
    }
  }
  if (!any || low_x == high_x || low_y == high_y) return -HUGE_VAL;
  return found - static_cast<double>(magnitude(pa.dx - pb.dx) + magnitude(pa.dy - pb.dy)) - 0x1p-23;
}

}  // namespace shd::ref
