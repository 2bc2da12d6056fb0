// SPDX-License-Identifier: MIT
// Generalised barycentric coordinates: formulas with angles, the properties that every kind has, harmonic functions,
// flaws of polygons, and triangulations.
#include <algorithm>
#include <vector>

#include "core/allocator.h"
#include "polygon/harmonic.h"
#include "polygon/sparse_solver.h"
#include "ref/polygon_ref.h"
#include "support/check.h"
#include "support/random.h"

namespace shd::tests {
namespace {

using polygon::Polygon;
using polygon::PolygonFlaw;
using polygon::PolygonPlace;
using Vertices = std::vector<ref::PolygonPoint>;

Polygon to_polygon(const Vertices& vertices) {
  Polygon p = {};
  p.count = static_cast<uint32_t>(vertices.size());
  for (size_t i = 0; i < vertices.size(); ++i) {
    p.x[i] = vertices[i].x;
    p.y[i] = vertices[i].y;
  }
  return p;
}

const Vertices& convex() {
  static const Vertices v = {{0, 0}, {3, -1}, {4, 1}, {3.5, 3}, {1, 3.5}, {-0.5, 2}};
  return v;
}
const Vertices& star() {
  static const Vertices v = {{0, 0}, {2, 1}, {4, 0}, {3, 2}, {4, 4}, {2, 3}, {0, 4}, {1, 2}};
  return v;
}
/// An L with a straight vertex, clockwise.
const Vertices& corner() {
  static const Vertices v = {{0, 0}, {0, 4}, {1.5, 4}, {1.5, 1}, {3, 1}, {5, 1}, {5, 0}};
  return v;
}

struct kind_case {
  const char* name;
  shd_barycentric kind;
  const Vertices& (*vertices)();
  bool is_positive;
};
const kind_case k_kinds[] = {
    {"wachspress/convex", SHD_BARYCENTRIC_WACHSPRESS, convex, true},
    {"mean_value/convex", SHD_BARYCENTRIC_MEAN_VALUE, convex, true},
    {"mean_value/star", SHD_BARYCENTRIC_MEAN_VALUE, star, false},
    {"mean_value/corner", SHD_BARYCENTRIC_MEAN_VALUE, corner, false},
    {"discrete_harmonic/convex", SHD_BARYCENTRIC_DISCRETE_HARMONIC, convex, false},
    {"harmonic/convex", SHD_BARYCENTRIC_HARMONIC, convex, true},
    {"harmonic/star", SHD_BARYCENTRIC_HARMONIC, star, true},
    {"harmonic/corner", SHD_BARYCENTRIC_HARMONIC, corner, true},
};

/// Computes weights as the library does.
struct Weights {
  Polygon polygon;
  shd_barycentric kind;
  polygon::HarmonicField field;
  core::Allocator allocator = {core::default_allocator()};
  double b[polygon::kMaxPolygon];

  Weights(const Vertices& vertices, shd_barycentric which, uint32_t segments)
      : polygon(to_polygon(vertices)), kind(which) {
    if (kind != SHD_BARYCENTRIC_HARMONIC) return;
    assert_true(polygon::solve_harmonic(allocator, polygon, segments, &field));
  }
  PolygonPlace::Kind find(double x, double y) {
    const PolygonPlace place = find_place(polygon, x, y);
    if (place.kind != PolygonPlace::kInside) {
      edge_weights(polygon, place, b);
    } else if (kind == SHD_BARYCENTRIC_HARMONIC) {
      harmonic_weights(polygon, field, x, y, b);
    } else {
      assert_true(closed_form_weights(polygon, kind, x, y, b));
    }
    return place.kind;
  }
};

bool is_skipped(const kind_case& c) {
  return c.kind == SHD_BARYCENTRIC_HARMONIC && !polygon::has_sparse_solver();
}

/// Partition of unity, linear precision and, where it is promised, no negative weight; the formulas with angles.
void test_inside(void** state) {
  const auto& c = *static_cast<const kind_case*>(*state);
  if (is_skipped(c)) skip();
  const Vertices& v = c.vertices();
  Weights weights(v, c.kind, 12);
  Random random{31};
  size_t inside = 0;
  for (size_t point = 0; point < 400; ++point) {
    const double x = random.in(-1, 5), y = random.in(-1, 5);
    if (weights.find(x, y) != PolygonPlace::kInside) continue;
    ++inside;
    double sum = 0, sum_x = 0, sum_y = 0;
    for (size_t i = 0; i < v.size(); ++i) {
      sum += weights.b[i];
      sum_x += weights.b[i] * v[i].x;
      sum_y += weights.b[i] * v[i].y;
      if (c.is_positive) assert_true(weights.b[i] >= (c.kind == SHD_BARYCENTRIC_HARMONIC ? -0.01 : 0.0));
    }
    shd_assert_close("sum", point, sum, 1, 1e-12, 0);
    shd_assert_close("x", point, sum_x, x, 1e-11, 0);
    shd_assert_close("y", point, sum_y, y, 1e-11, 0);
    if (c.kind == SHD_BARYCENTRIC_HARMONIC) continue;
    Vertices turned = v;
    if (c.vertices == corner) std::reverse(turned.begin(), turned.end());
    std::vector<double> want = ref::polygon_weights(c.kind, turned, {x, y});
    if (c.vertices == corner) std::reverse(want.begin(), want.end());
    for (size_t i = 0; i < v.size(); ++i) shd_assert_close(c.name, i, weights.b[i], want[i], 1e-9, 1e-9);
  }
  assert_true(inside > 80);
}

/// Vertices, edges, and the approach to them from inside.
void test_edges(void** state) {
  const auto& c = *static_cast<const kind_case*>(*state);
  if (is_skipped(c)) skip();
  const Vertices& v = c.vertices();
  const size_t n = v.size();
  Weights weights(v, c.kind, 12);
  for (size_t i = 0; i < n; ++i) {
    const ref::PolygonPoint a = v[i], b = v[(i + 1) % n];
    for (const double t : {0.0, 0.25, 0.5, 0.8125}) {
      const double x = a.x + t * (b.x - a.x), y = a.y + t * (b.y - a.y);
      assert_int_equal(weights.find(x, y), PolygonPlace::kOnEdge);
      const auto want = [&](size_t k) { return k == i ? 1 - t : k == (i + 1) % n ? t : 0.0; };
      for (size_t k = 0; k < n; ++k) shd_assert_close("edge", k, weights.b[k], want(k), 1e-15, 0);
      const double inward = c.vertices == corner ? -1e-7 : 1e-7;
      if (t == 0.0) continue;
      assert_int_equal(weights.find(x - inward * (b.y - a.y), y + inward * (b.x - a.x)), PolygonPlace::kInside);
      for (size_t k = 0; k < n; ++k) shd_assert_close("beside", k, weights.b[k], want(k), 1e-5, 0);
    }
  }
}

/// Harmonic coordinates of a square are the bilinear ones; the error falls with the size of the elements.
void test_square(void**) {
  if (!polygon::has_sparse_solver()) skip();
  double error[2] = {0, 0};
  for (int fine = 0; fine < 2; ++fine) {
    Weights weights({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, SHD_BARYCENTRIC_HARMONIC, fine ? 32 : 8);
    Random random{32};
    for (size_t point = 0; point < 300; ++point) {
      const double x = random.unit(), y = random.unit();
      weights.find(x, y);
      const double want[4] = {(1 - x) * (1 - y), x * (1 - y), x * y, (1 - x) * y};
      for (size_t i = 0; i < 4; ++i) error[fine] = std::max(error[fine], std::fabs(weights.b[i] - want[i]));
    }
  }
  print_message("error with 8 and 32 parts: %.2g, %.2g\n", error[0], error[1]);
  assert_true(error[0] < 4e-3 && error[1] < 3e-4);
}

/// The value in the centre of a circle is the mean over the circle: the mean value property of harmonic functions.
void test_mean_value_property(void**) {
  if (!polygon::has_sparse_solver()) skip();
  for (const Vertices* v : {&convex(), &star()}) {
    Weights weights(*v, SHD_BARYCENTRIC_HARMONIC, 48);
    double mean[8] = {};
    for (int k = 0; k < 720; ++k) {
      const double a = k * 3.14159265358979324 / 360;
      assert_int_equal(weights.find(2 + 0.8 * std::cos(a), 2 + 0.8 * std::sin(a)), PolygonPlace::kInside);
      for (size_t i = 0; i < v->size(); ++i) mean[i] += weights.b[i] / 720;
    }
    weights.find(2, 2);
    for (size_t i = 0; i < v->size(); ++i) shd_assert_close("centre", i, weights.b[i], mean[i], 5e-4, 0);
  }
}

/// Points outside have the weights of the nearest point of the edges.
void test_outside(void**) {
  Weights weights(convex(), SHD_BARYCENTRIC_WACHSPRESS, 1);
  assert_int_equal(weights.find(1.5 + 1, -0.5 - 9), PolygonPlace::kOutside);
  double sum = 0;
  for (size_t i = 0; i < 6; ++i) sum += weights.b[i] * convex()[i].x;
  assert_true(sum > 2.9 && sum <= 3.0 && weights.b[0] + weights.b[1] == 1.0);
  assert_int_equal(weights.find(1e30, 1e30), PolygonPlace::kOutside);
  assert_int_equal(weights.find(-7, 0), PolygonPlace::kOutside);
}

/// Points far away: mean value weights are finite, and the nearest vertex of a square is found.
void test_far(void**) {
  const Vertices square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  Weights mean_value(square, SHD_BARYCENTRIC_MEAN_VALUE, 1), wachspress(square, SHD_BARYCENTRIC_WACHSPRESS, 1);
  for (const double x : {1e2, 1e4, 1e6, 1e9, 1e16, 1e17, 3e38, 3.4028234663852886e38}) {
    assert_true(closed_form_weights(mean_value.polygon, mean_value.kind, x, 0.75 * x, mean_value.b));
    double sum = 0, at = 0;
    for (size_t i = 0; i < 4; ++i) sum += mean_value.b[i], at += mean_value.b[i] * square[i].x;
    const double limit = 0.8 * 1.4142135623730951 * 0x1p20;  // 2^20 diameters, times the cosine of the direction
    shd_assert_close("sum", 0, sum, 1, 1e-6, 1e-6);
    shd_assert_close("x", 0, at, x < limit ? x : limit, 0, 1e-3);
    wachspress.find(x, 0.75 * x);
    assert_true(wachspress.b[2] == 1);
  }
}

struct flaw_case {
  const char* name;
  Vertices vertices;
  PolygonFlaw::Kind kind;
  uint32_t a, b;
  PolygonFlaw::Kind concavity;
};

void test_flaw(void** state) {
  const auto& c = *static_cast<const flaw_case*>(*state);
  const Polygon p = to_polygon(c.vertices);
  const PolygonFlaw flaw = polygon::find_flaw(p);
  assert_int_equal(flaw.kind, c.kind);
  assert_int_equal(flaw.a, c.a);
  assert_int_equal(flaw.b, c.b);
  if (c.kind == PolygonFlaw::kNone) assert_int_equal(polygon::find_concavity(p).kind, c.concavity);
}

/// A triangulation covers the polygon with triangles of its vertices, and no vertex lies in a circle of a triangle of a
/// convex polygon.
void test_triangulation(void**) {
  for (const Vertices* v : {&convex(), &star(), &corner()}) {
    const Polygon p = to_polygon(*v);
    polygon::Triangulation out;
    assert_true(polygon::triangulate(p, &out));
    assert_int_equal(out.count, p.count - 2);
    double area = 0, whole = 0;
    for (uint32_t t = 0; t < out.count; ++t) {
      const double twice = turn(p, out.corner[t][0], out.corner[t][1], out.corner[t][2]);
      assert_true(twice > 0);
      area += twice;
    }
    for (uint32_t i = 0; i < p.count; ++i) {
      const uint32_t k = (i + 1) % p.count;
      whole += p.x[i] * p.y[k] - p.x[k] * p.y[i];
    }
    shd_assert_close("area", 0, area, fabs(whole), 1e-12, 0);
  }
}

/// A polygon of the largest size, a regular one, with every kind.
void test_largest(void**) {
  Vertices circle(polygon::kMaxPolygon);
  for (size_t i = 0; i < circle.size(); ++i) {
    const double a = 2 * 3.14159265358979324 * static_cast<double>(i) / polygon::kMaxPolygon;
    circle[i] = {std::cos(a), std::sin(a)};
  }
  for (int kind = 0; kind <= SHD_BARYCENTRIC_HARMONIC; ++kind) {
    if (kind == SHD_BARYCENTRIC_HARMONIC && !polygon::has_sparse_solver()) continue;
    Weights weights(circle, static_cast<shd_barycentric>(kind), 3);
    weights.find(0.25, -0.5);
    double sum = 0, sum_x = 0;
    for (size_t i = 0; i < circle.size(); ++i) {
      sum += weights.b[i];
      sum_x += weights.b[i] * circle[i].x;
    }
    shd_assert_close("sum", static_cast<size_t>(kind), sum, 1, 1e-12, 0);
    shd_assert_close("x", static_cast<size_t>(kind), sum_x, 0.25, 1e-11, 0);
  }
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  const flaw_case flaws[] = {
      {"flaw/convex", convex(), PolygonFlaw::kNone, 0, 0, PolygonFlaw::kNone},
      {"flaw/star", star(), PolygonFlaw::kNone, 0, 0, PolygonFlaw::kReflex},
      {"flaw/straight", {{0, 0}, {1, 0}, {2, 0}, {1, 1}}, PolygonFlaw::kNone, 0, 0, PolygonFlaw::kStraight},
      {"flaw/point_edge", {{0, 0}, {1, 0}, {1, 0}, {0, 1}}, PolygonFlaw::kPointEdge, 1, 2, PolygonFlaw::kNone},
      {"flaw/last_edge", {{0, 0}, {1, 0}, {1, 1}, {0, 0}}, PolygonFlaw::kPointEdge, 3, 0, PolygonFlaw::kNone},
      {"flaw/collinear", {{0, 0}, {1, 1}, {2, 2}}, PolygonFlaw::kFold, 0, 0, PolygonFlaw::kNone},
      {"flaw/bow_tie", {{0, 0}, {1, 1}, {1, 0}, {0, 1}}, PolygonFlaw::kCrossing, 0, 2, PolygonFlaw::kNone},
      {"flaw/touches", {{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}, PolygonFlaw::kCrossing, 0, 2, PolygonFlaw::kNone},
      {"flaw/twice",
       {{0, 0}, {2, 0}, {1, 1}, {0, 0}, {-1, 1}, {-1, 0}},
       PolygonFlaw::kCrossing,
       0,
       2,
       PolygonFlaw::kNone},
      {"flaw/overlap",
       {{0, 0}, {4, 0}, {4, 1}, {3, 0}, {1, 0}, {0, 1}},
       PolygonFlaw::kCrossing,
       0,
       2,
       PolygonFlaw::kNone},
  };
  CMUnitTest tests[40];
  static char names[40][64];
  size_t n = 0;
  for (int edges = 0; edges < 2; ++edges) {
    for (const kind_case& c : k_kinds) {
      snprintf(names[n], sizeof names[n], "%s/%s", edges ? "edges" : "inside", c.name);
      tests[n] = {names[n], edges ? test_edges : test_inside, nullptr, nullptr, const_cast<kind_case*>(&c)};
      ++n;
    }
  }
  for (const flaw_case& c : flaws) tests[n++] = {c.name, test_flaw, nullptr, nullptr, const_cast<flaw_case*>(&c)};
  tests[n++] = {"square", test_square, nullptr, nullptr, nullptr};
  tests[n++] = {"mean_value_property", test_mean_value_property, nullptr, nullptr, nullptr};
  tests[n++] = {"outside", test_outside, nullptr, nullptr, nullptr};
  tests[n++] = {"far", test_far, nullptr, nullptr, nullptr};
  tests[n++] = {"triangulation", test_triangulation, nullptr, nullptr, nullptr};
  tests[n++] = {"largest", test_largest, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.polygon.coordinates", tests, n, nullptr, nullptr);
}
