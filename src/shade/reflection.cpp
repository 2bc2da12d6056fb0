// SPDX-License-Identifier: MIT
#include "shade/reflection.h"

#include <algorithm>
#include <cmath>

#include "data/trig.h"
#include "data/vec3.h"

namespace shd::shade {
namespace {

using data::Vec3d;

Vec3d row(const core::Array<float>& rows, uint32_t vertex) {
  const float* values = &rows[4 * size_t{vertex}];
  return {double{values[0]}, double{values[1]}, double{values[2]}};
}

/// Change per pixel step of a value that is linear in the triangle, from its differences to the first corner.
struct Screen {
  double x1, y1, x2, y2, inverse;  // corners relative to the first one; 1 / determinant

  Vec3d step_x(const Vec3d& d1, const Vec3d& d2) const { return (y2 * inverse) * d1 - (y1 * inverse) * d2; }
  Vec3d step_y(const Vec3d& d1, const Vec3d& d2) const { return (x1 * inverse) * d2 - (x2 * inverse) * d1; }
};

/// Angle by which a reflected ray turns: twice that of the normal, and that of the line of sight.
double turn(const Vec3d& normal_step, const Vec3d& position_step, const Vec3d& to_eye, double distance) {
  const Vec3d across = position_step - data::dot(position_step, to_eye) * to_eye;
  return 2.0 * data::length(normal_step) + data::length(across) / distance;
}

float variance_of(const geometry::Vertices& vertices, const float eye[3], uint32_t triangle) {
  constexpr double kMaxVariance = 0.5;
  uint32_t vertex[3];
  Vec3d p[3], n[3];
  double x[3], y[3];
  for (size_t k = 0; k < 3; ++k) {
    vertex[k] = geometry::row_of(vertices, triangle, k);
    const float* raster = &vertices.raster[4 * size_t{vertex[k]}];
    if (!(raster[3] > 0.0f)) return 0.0f;
    x[k] = double{raster[0]} / double{raster[3]};
    y[k] = double{raster[1]} / double{raster[3]};
    p[k] = row(vertices.world, vertex[k]);
    n[k] = row(vertices.normal, vertex[k]);
  }
  const double x1 = x[1] - x[0], y1 = y[1] - y[0], x2 = x[2] - x[0], y2 = y[2] - y[0], area = x1 * y2 - x2 * y1;
  if (!(std::fabs(area) > 0.0)) return 0.0f;
  const Screen screen = {x1, y1, x2, y2, 1.0 / area};
  const Vec3d centre = (1.0 / 3.0) * (p[0] + p[1] + p[2]);
  const Vec3d away = Vec3d{double{eye[0]}, double{eye[1]}, double{eye[2]}} - centre, to_eye = data::normalized(away);
  const double distance = std::max(data::length(away), 1e-30);
  const Vec3d n1 = n[1] - n[0], n2 = n[2] - n[0], p1 = p[1] - p[0], p2 = p[2] - p[0];
  const double a = turn(screen.step_x(n1, n2), screen.step_x(p1, p2), to_eye, distance);
  const double b = turn(screen.step_y(n1, n2), screen.step_y(p1, p2), to_eye, distance);
  const double variance = 0.5 * (a * a + b * b) / (16.0 * data::kPi);
  return variance < kMaxVariance ? static_cast<float>(variance) : static_cast<float>(kMaxVariance);  // NaN is wide
}

}  // namespace

void find_reflected_variance(const geometry::Vertices& vertices, const float eye[3], const raster::Fragments& f,
                             float* variance) {
  for (size_t i = 0; i < f.count; ++i) {
    variance[i] = i && f.triangle[i] == f.triangle[i - 1] ? variance[i - 1] : variance_of(vertices, eye, f.triangle[i]);
  }
}

}  // namespace shd::shade
