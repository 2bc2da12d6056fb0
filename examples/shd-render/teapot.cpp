// SPDX-License-Identifier: MIT
#include "teapot.h"

#include <cmath>

#include "teapot_data.h"

namespace {

using Vec3 = std::array<double, 3>;

/// A ring of patches that share a texture chart. u runs around, to the right as seen from outside; v runs down.
struct Ring {
  int first, count;        // patches that together form a closed ring
  double u_span;           // repeats of the texture around; whole numbers leave no seam
  double v_first, v_last;  // at the first and last row of control points
};

// One unit of the texture is about a quarter of the body's girth; handle and spout are thinner.
constexpr Ring kRings[] = {
    {0, 4, 4.0, 0.0, 0.07},      // rim
    {4, 4, 4.0, 0.07, 0.57},     // upper body
    {8, 4, 4.0, 0.57, 0.9},      // lower body
    {12, 2, 1.0, 0.0, 1.6},      // handle
    {14, 2, 1.0, 1.6, 3.5},      //
    {16, 2, 1.0, 1.2, 0.35},     // spout: rows go up
    {18, 2, 1.0, 0.35, 0.0},     //
    {20, 4, 4.0, -0.62, -0.38},  // lid
    {24, 4, 4.0, -0.38, 0.0},    //
    {28, 4, 4.0, 1.38, 0.9},     // bottom: rows go up, from the middle outwards
};

/// Bernstein weights and their derivatives at step/steps. Both ends are symmetric in every bit, so that walking an edge
/// backwards gives the same points.
struct Weights {
  double value[4], slope[4];
};

Weights weights_at(int step, int steps) {
  const double t = static_cast<double>(step) / steps;
  const double s = static_cast<double>(steps - step) / steps;
  return {{s * s * s, 3.0 * (s * s * t), 3.0 * (t * t * s), t * t * t},
          {-3.0 * (s * s), 3.0 * (s * s - 2.0 * (s * t)), 3.0 * (2.0 * (s * t) - t * t), 3.0 * (t * t)}};
}

Vec3 blend(const double* weights, const Vec3& p0, const Vec3& p1, const Vec3& p2, const Vec3& p3) {
  Vec3 sum;
  for (int c = 0; c < 3; ++c) {
    sum[c] = (weights[0] * p0[c] + weights[3] * p3[c]) + (weights[1] * p1[c] + weights[2] * p2[c]);
  }
  return sum;
}

/// Point or derivative of a patch, with `down` and `around` as weights of rows and columns.
Vec3 evaluate(int patch, const double* down, const double* around) {
  Vec3 rows[4];
  for (int row = 0; row < 4; ++row) {
    Vec3 points[4];
    for (int column = 0; column < 4; ++column) {
      const double* point = kTeapotPoints[kTeapotPatches[patch][4 * row + column] - 1];
      points[column] = {point[0], point[1], point[2]};
    }
    rows[row] = blend(around, points[0], points[1], points[2], points[3]);
  }
  return blend(down, rows[0], rows[1], rows[2], rows[3]);
}

Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double length(const Vec3& a) {
  return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}

/// Outward unit normal. At the poles of lid and bottom a whole row is one point, and the derivative around vanishes;
/// its limit has the direction of the mixed derivative.
Vec3 normal_at(int patch, const Weights& down, const Weights& around) {
  const Vec3 along = evaluate(patch, down.slope, around.value);
  Vec3 across = evaluate(patch, down.value, around.slope);
  if (length(across) < 1e-9) across = evaluate(patch, down.slope, around.slope);
  Vec3 normal = cross(across, along);
  const double size = length(normal);
  for (double& c : normal) c /= size;
  return normal;
}

void add_vertex(Geometry& out, const Vec3& point, const Vec3& normal, double u, double v) {
  // z up to y up
  for (const double c : {point[0], point[2], -point[1]}) out.position.push_back(static_cast<float>(c));
  for (const double c : {normal[0], normal[2], -normal[1]}) out.normal.push_back(static_cast<float>(c));
  out.uv.push_back(static_cast<float>(u));
  out.uv.push_back(static_cast<float>(v));
}

/// Adds one triangle, unless two of its corners are the same point, as at a pole.
void add_triangle(Geometry& out, uint32_t a, uint32_t b, uint32_t c) {
  const auto same = [&](uint32_t i, uint32_t j) {
    const float *p = &out.position[size_t{3} * i], *q = &out.position[size_t{3} * j];
    return p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
  };
  if (same(a, b) || same(b, c) || same(c, a)) return;
  for (const uint32_t vertex : {a, b, c}) out.indices.push_back(vertex);
}

void add_patch(Geometry& out, const Ring& ring, int k, int steps) {
  const auto first = static_cast<uint32_t>(out.position.size() / 3);
  const auto row_size = static_cast<uint32_t>(steps + 1);
  const bool upwards = ring.v_first > ring.v_last;
  for (int i = 0; i <= steps; ++i) {
    const Weights down = weights_at(i, steps);
    const double v = ring.v_first + (ring.v_last - ring.v_first) * i / steps;
    for (int j = 0; j <= steps; ++j) {
      const Weights around = weights_at(j, steps);
      const double turn = (k + static_cast<double>(j) / steps) / ring.count;
      const double u = ring.u_span * (upwards ? turn : 1.0 - turn);
      add_vertex(out, evaluate(ring.first + k, down.value, around.value), normal_at(ring.first + k, down, around), u,
                 v);
    }
  }
  for (uint32_t i = 0; i < static_cast<uint32_t>(steps); ++i) {
    for (uint32_t j = 0; j < static_cast<uint32_t>(steps); ++j) {
      const uint32_t a = first + i * row_size + j, b = a + 1, d = a + row_size, c = d + 1;
      add_triangle(out, a, b, c);
      add_triangle(out, a, c, d);
    }
  }
}

}  // namespace

Model make_teapot(int steps) {
  Model model;
  Geometry geometry;
  for (const Ring& ring : kRings) {
    for (int k = 0; k < ring.count; ++k) add_patch(geometry, ring, k, steps);
  }
  model.geometries.push_back(std::move(geometry));
  Surface surface;
  surface.name = "ceramic";
  surface.diffuse = {0.62f, 0.6f, 0.56f};
  model.surfaces.push_back(surface);
  model.instances.push_back(Instance{});
  return model;
}
