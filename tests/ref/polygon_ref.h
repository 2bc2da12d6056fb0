// SPDX-License-Identifier: MIT
// Oracle of the generalised barycentric coordinates: angles and areas as in the definitions, in double.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include <shd/polygon.h>

namespace ref {

struct PolygonPoint {
  double x, y;
};

/// Signed area of a triangle.
inline double polygon_area(PolygonPoint a, PolygonPoint b, PolygonPoint c) {
  return ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
}

/// Signed angle at `at` from `from` to `to`, in -pi..pi.
inline double polygon_angle(PolygonPoint at, PolygonPoint from, PolygonPoint to) {
  const double angle = std::atan2(to.y - at.y, to.x - at.x) - std::atan2(from.y - at.y, from.x - at.x);
  const double pi = 3.14159265358979324;
  return angle > pi ? angle - 2 * pi : angle < -pi ? angle + 2 * pi : angle;
}

/// Coordinates of a point inside a polygon that runs counter-clockwise.
inline std::vector<double> polygon_weights(shd_barycentric kind, const std::vector<PolygonPoint>& v, PolygonPoint x) {
  const size_t n = v.size();
  std::vector<double> w(n);
  double sum = 0;
  for (size_t i = 0; i < n; ++i) {
    const PolygonPoint before = v[(i + n - 1) % n], here = v[i], after = v[(i + 1) % n];
    if (kind == SHD_BARYCENTRIC_WACHSPRESS) {
      w[i] = polygon_area(before, here, after) / (polygon_area(x, before, here) * polygon_area(x, here, after));
    } else if (kind == SHD_BARYCENTRIC_MEAN_VALUE) {
      const double r = std::hypot(here.x - x.x, here.y - x.y);
      w[i] = (std::tan(polygon_angle(x, before, here) / 2) + std::tan(polygon_angle(x, here, after) / 2)) / r;
    } else {
      w[i] = 1 / std::tan(polygon_angle(before, here, x)) + 1 / std::tan(polygon_angle(after, x, here));
    }
    sum += w[i];
  }
  for (double& weight : w) weight /= sum;
  return w;
}

}  // namespace ref
