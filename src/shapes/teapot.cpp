// SPDX-License-Identifier: MIT
#include "shapes/shapes.h"
#include "shapes/teapot_data.h"

namespace shd::shapes {
namespace {

/// A ring of patches that share a texture chart. u runs around, to the right seen from outside; v runs down.
struct Ring {
  int first, count;        // number of patches; together they go once around
  double u_span;           // repeats of the texture around; whole numbers leave no seam
  double v_first, v_last;  // at the first and last row of control points
  bool has_pole;           // the first row is one point
};

// One unit of the texture is about a quarter of the body's girth; handle and spout are thinner.
constexpr Ring kRings[] = {
    {0, 4, 4.0, 0.0, 0.07, false},     // rim
    {4, 4, 4.0, 0.07, 0.57, false},    // upper body
    {8, 4, 4.0, 0.57, 0.9, false},     // lower body
    {12, 2, 1.0, 0.0, 1.6, false},     // handle
    {14, 2, 1.0, 1.6, 3.5, false},     //
    {16, 2, 1.0, 1.2, 0.35, false},    // spout: rows go up
    {18, 2, 1.0, 0.35, 0.0, false},    //
    {20, 4, 4.0, -0.62, -0.38, true},  // lid
    {24, 4, 4.0, -0.38, 0.0, false},   //
    {28, 4, 4.0, 1.38, 0.9, true},     // bottom: rows go up, from the middle outwards
};

/// Bernstein weights and their derivatives at step/steps. Both ends are symmetric in every bit: walking an edge
/// backwards gives the same points.
struct Weights {
  double value[4], slope[4];
};

Weights weights_at(double step, int steps) {
  const double t = step / steps, s = (steps - step) / steps;
  return {{s * s * s, 3.0 * (s * s * t), 3.0 * (t * t * s), t * t * t},
          {-3.0 * (s * s), 3.0 * (s * s - 2.0 * (s * t)), 3.0 * (2.0 * (s * t) - t * t), 3.0 * (t * t)}};
}

Vec3d blend(const double* weights, const Vec3d& p0, const Vec3d& p1, const Vec3d& p2, const Vec3d& p3) {
  return (weights[0] * p0 + weights[3] * p3) + (weights[1] * p1 + weights[2] * p2);
}

/// Evaluates a patch with `down` and `around` as weights of rows and columns; gives a point or a derivative.
Vec3d evaluate(int patch, const double* down, const double* around) {
  Vec3d rows[4];
  for (int row = 0; row < 4; ++row) {
    Vec3d points[4];
    for (int column = 0; column < 4; ++column) {
      const double* point = kTeapotPoints[kTeapotPatches[patch][4 * row + column] - 1];
      points[column] = {point[0], point[1], point[2]};
    }
    rows[row] = blend(around, points[0], points[1], points[2], points[3]);
  }
  return blend(down, rows[0], rows[1], rows[2], rows[3]);
}

/// Outward unit normal. At the poles of lid and bottom a whole row is one point and the derivative around vanishes;
/// its limit has the direction of the mixed derivative.
Vec3d normal_at(int patch, const Weights& down, const Weights& around) {
  const Vec3d along = evaluate(patch, down.slope, around.value);
  Vec3d across = evaluate(patch, down.value, around.slope);
  if (data::length(across) < 1e-9) across = evaluate(patch, down.slope, around.slope);
  return data::normalized(data::cross(across, along));
}

/// A vertex of patch k of a ring, with the z of the published points as y.
void add_point(Sink& out, const Ring& ring, int k, int steps, int i, double j) {
  const Weights down = weights_at(i, steps), around = weights_at(j, steps);
  const Vec3d p = evaluate(ring.first + k, down.value, around.value), n = normal_at(ring.first + k, down, around);
  const double turn = (k + j / steps) / ring.count;
  const double u = ring.u_span * (ring.v_first > ring.v_last ? turn : 1.0 - turn);
  const double v = ring.v_first + (ring.v_last - ring.v_first) * i / steps;
  add_vertex(out, {p.x, p.z, 0.0 - p.y}, {n.x, n.z, 0.0 - n.y}, u, v);
}

void add_patch(Sink& out, const Ring& ring, int k, int steps) {
  const uint32_t first = out.vertex, size = static_cast<uint32_t>(steps);
  const uint32_t first_row = first + size + (ring.has_pole ? 0 : 1);  // first vertex of the second row
  for (int j = 0; j < steps && ring.has_pole; ++j) add_point(out, ring, k, steps, 0, j + 0.5);
  for (int i = ring.has_pole ? 1 : 0; i <= steps; ++i) {
    for (int j = 0; j <= steps; ++j) add_point(out, ring, k, steps, i, j);
  }
  for (uint32_t j = 0; j < size; ++j) {
    const uint32_t a = first + j, d = first_row + j;
    if (!ring.has_pole) add_triangle(out, a, a + 1, d + 1);
    add_triangle(out, a, d + 1, d);
  }
  for (uint32_t i = 1; i < size; ++i) {
    for (uint32_t j = 0; j < size; ++j) {
      const uint32_t a = first_row + (i - 1) * (size + 1) + j, d = a + size + 1;
      add_triangle(out, a, a + 1, d + 1);
      add_triangle(out, a, d + 1, d);
    }
  }
}

}  // namespace

Counts count_teapot(const shd_shape_desc& desc) {
  const uint64_t n = desc.segments[0];
  Counts counts = {0, 0};
  for (const Ring& ring : kRings) {
    const auto patches = static_cast<uint64_t>(ring.count), pole = uint64_t{ring.has_pole};
    counts.vertices += patches * ((n + 1) * (n + 1) - pole);
    counts.triangles += patches * (2 * n * n - pole * n);
  }
  return counts;
}

void fill_teapot(const shd_shape_desc& desc, Sink& out) {
  for (const Ring& ring : kRings) {
    for (int k = 0; k < ring.count; ++k) add_patch(out, ring, k, static_cast<int>(desc.segments[0]));
  }
}

}  // namespace shd::shapes
