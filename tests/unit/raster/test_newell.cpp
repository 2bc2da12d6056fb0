// SPDX-License-Identifier: MIT
// The last painted triangle in Newell's order against the nearest one, at every pixel; pairs of triangles, and cuts.
#include "paint_fixture.h"

namespace shd::tests {
namespace {

core::Context* g_context;
const raster::PaintArea k_area = {{0, 0, kEdge - 1, kEdge - 1}, {128, 128, 128, 128}};

int set_up(void**) {
  g_context = core::create_context(shd_context_desc_default());
  return 0;
}
int tear_down(void**) {
  core::release(*g_context);
  return 0;
}

struct order_case {
  const char* name;
  Triangles (*make)();
  bool falls;
  bool cuts; /* whether there must be cuts */
};
const order_case k_orders[] = {
    {"order/none", [] { return Triangles(); }, false, false},
    {"order/one", [] { return make_tangle({1}, 1, 20); }, false, false},
    {"order/layers", [] { return make_layers({2}, 60); }, false, false},
    {"order/layers_falling", [] { return make_layers({2}, 60); }, true, false},
    {"order/circle_of_3", [] { return make_circle(3, 0.1); }, false, true},
    {"order/circle_of_3_falling", [] { return make_circle(3, 1.3); }, true, true},
    {"order/circle_of_4", [] { return make_circle(4, 0.7); }, false, true},
    {"order/circle_of_7", [] { return make_circle(7, 0.3); }, false, true},
    {"order/tangle_of_2", [] { return make_tangle({9}, 2, 60); }, false, false},
    {"order/tangle_of_large", [] { return make_tangle({3}, 30, 50); }, false, true},
    {"order/tangle_of_small", [] { return make_tangle({4}, 600, 4); }, false, true},
    {"order/tangle_falling", [] { return make_tangle({6}, 60, 25); }, true, true},
    {"order/floor", [] { return make_floor({5}, 12); }, false, true},
    {"order/fine_floor", [] { return make_floor({8}, 60); }, false, true},
};

/// Distance of the centre of a pixel from the outline of a triangle, in grid steps.
double edge_distance(const ScreenTriangle& t, int x, int y) {
  double found = HUGE_VAL;
  for (int k = 0; k < 3; ++k) {
    const int n = (k + 1) % 3;
    const double dx = t.x[n] - t.x[k], dy = t.y[n] - t.y[k];
    const double px = 256 * x + 128 - t.x[k], py = 256 * y + 128 - t.y[k];
    found = std::min(found, std::fabs(dx * py - dy * px) / std::sqrt(dx * dx + dy * dy));
  }
  return found;
}

/// Whether an order may show `shown` where another triangle is nearest: the pixel is at an edge, or the depths are
/// equal within a grid step.
bool is_excused(const Triangles& triangles, size_t shown, size_t want, int x, int y) {
  if (want != ref::kNothing && edge_distance(triangles[want], x, y) < 1) return true;
  if (shown != ref::kNothing && edge_distance(triangles[shown], x, y) < 1) return true;
  if (shown == ref::kNothing || want == ref::kNothing) return false;
  const ref::DepthPlane a = ref::plane_of(triangles[shown]), b = ref::plane_of(triangles[want]);
  const double gap = ref::depth_at(triangles[shown], x, y).value - ref::depth_at(triangles[want], x, y).value;
  const double step = static_cast<double>(ref::magnitude(a.dx - b.dx) + ref::magnitude(a.dy - b.dy));
  return std::fabs(gap) <= 1.001 * (step + 0x1p-22);
}

/// Sorts as the painter does and passes the result to newell().
void make_painting(const Triangles& triangles, const raster::PaintRule& rule, raster::Painting* painting) {
  Triangles sorted = triangles;
  std::stable_sort(sorted.begin(), sorted.end(), [&](const ScreenTriangle& a, const ScreenTriangle& b) {
    return raster::farthest_distance(a, rule) > raster::farthest_distance(b, rule);
  });
  painting->triangles.attach(g_context->allocator);
  painting->order.attach(g_context->allocator);
  for (const ScreenTriangle& t : sorted) painting->triangles.push_back(raster::make_sort_triangle(t, rule));
  raster::newell(*g_context, k_area, painting);
}

void check_pixels(const char* name, const Triangles& triangles, const Triangles& painted, double sign) {
  size_t covered = 0, excused = 0;
  for (int y = 0; y < kEdge; ++y) {
    for (int x = 0; x < kEdge; ++x) {
      const size_t last = ref::painted_last(painted.data(), painted.size(), x, y);
      const size_t want = ref::nearest(triangles.data(), triangles.size(), x, y, sign);
      const size_t shown = last == ref::kNothing ? last : painted[last].primitive;
      covered += want != ref::kNothing;
      if (shown == want) continue;
      ++excused;
      if (!is_excused(triangles, shown, want, x, y))
        fail_msg("%s: (%d, %d) shows %zd, want %zd", name, x, y, shown, want);
    }
  }
  print_message("%s: %zu triangles, %zu painted, %zu of %zu pixels at seams\n", name, triangles.size(), painted.size(),
                excused, covered);
  if (200 * excused > covered + 200) fail_msg("%s: %zu of %zu pixels at seams", name, excused, covered);
}

void test_order(void** state) {
  const auto* c = static_cast<const order_case*>(*state);
  const raster::PaintRule rule = {true, c->falls, 0, 0};
  auto* triangles = new Triangles(c->make());
  auto* painting = new raster::Painting;
  make_painting(*triangles, rule, painting);
  auto* painted = new Triangles;
  for (size_t i = 0; i < painting->order.size(); ++i) {
    painted->push_back(painting->triangles[painting->order[i]].triangle);
    assert_true(raster::doubled_area(painted->back()) > 0);
  }
  if (c->cuts != (painting->cuts > 0)) fail_msg("%s: %zu cuts", c->name, static_cast<size_t>(painting->cuts));
  if (painted->size()) {
    raster::SortGrid grid;
    raster::make_grid(g_context->allocator, k_area.pixels, painting->triangles.data(), painting->order.data(),
                      painting->order.size(), &grid);
    assert_int_equal(raster::count_conflicts(*g_context, painting->triangles.data(), grid), 0);
  }
  check_pixels(c->name, *triangles, *painted, c->falls ? -1.0 : 1.0);
  delete painted;
  delete painting;
  delete triangles;
}

/// Returns false if one has no area.
bool make_pair(Random* random, double size, ScreenTriangle out[2]) {
  const Triangles triangles = make_tangle({random->bits()}, 2, size);
  if (triangles.size() < 2) return false;
  out[0] = triangles[0];
  out[1] = triangles[1];
  return true;
}

/// Compares the allowed orders of two triangles with the reference, in both directions.
void test_pairs(void**) {
  Random random = {77};
  size_t overlapping = 0, crossing = 0;
  for (int round = 0; round < 20000; ++round) {
    ScreenTriangle pair[2];
    if (!make_pair(&random, round % 2 ? 3 : 30, pair)) continue;
    const raster::SortTriangle a = raster::make_sort_triangle(pair[0], {true, false, 0, 0});
    const raster::SortTriangle b = raster::make_sort_triangle(pair[1], {true, false, 0, 0});
    const double a_nearer = ref::nearer_by(pair[0], pair[1]), b_nearer = ref::nearer_by(pair[1], pair[0]);
    assert_true(raster::overlaps(pair[0], pair[1]) == raster::overlaps(pair[1], pair[0]));
    assert_int_equal(raster::overlaps(pair[0], pair[1]), a_nearer > -HUGE_VAL);
    if (std::fabs(a_nearer) > 1e-9) assert_int_equal(raster::may_precede(a, b), a_nearer < 0);
    if (std::fabs(b_nearer) > 1e-9) assert_int_equal(raster::may_precede(b, a), b_nearer < 0);
    overlapping += a_nearer > -HUGE_VAL;
    crossing += a_nearer > 0 && b_nearer > 0;
  }
  assert_true(overlapping > 1000 && crossing > 300);
}

/// Pieces lie on one side of the plane, in the plane of the whole, and together have its area.
void test_cuts(void**) {
  Random random = {78};
  size_t cuts = 0;
  for (int round = 0; round < 20000; ++round) {
    ScreenTriangle pair[2];
    if (!make_pair(&random, round % 2 ? 0.2 : 30, pair)) continue;
    const raster::PaintRule rule = {true, round % 3 == 0, round % 5 ? 0.0f : 0.125f, 0};
    const raster::SortTriangle a = raster::make_sort_triangle(pair[0], rule),
                               b = raster::make_sort_triangle(pair[1], rule);
    raster::TrianglePieces pieces;
    if (!raster::split_triangle(a, b, &pieces)) continue;
    ++cuts;
    const double limit = raster::tolerance(a, b);
    double area = 0, sides = 0;
    for (int i = 0; i < pieces.count; ++i) {
      const raster::SortTriangle& p = pieces.piece[i];
      const raster::DistanceRange range = raster::beyond_plane(p, b);
      assert_true(range.low >= -limit || range.high <= limit);
      sides += range.high > limit ? 1 : range.low < -limit ? -1 : 0;
      assert_true(p.min_x >= a.min_x && p.max_x <= a.max_x && p.min_y >= a.min_y && p.max_y <= a.max_y);
      assert_true(p.nearest >= a.nearest && p.farthest <= a.farthest);
      assert_int_equal(p.triangle.primitive, a.triangle.primitive);
      area += static_cast<double>(raster::doubled_area(p.triangle));
    }
    const double perimeter = 4.0 * (a.max_x - a.min_x + a.max_y - a.min_y);
    shd_assert_close("area", static_cast<size_t>(round), area, static_cast<double>(raster::doubled_area(a.triangle)),
                     perimeter + 16, 0);
    assert_true(std::fabs(sides) < pieces.count);
  }
  assert_true(cuts > 1000);
}

/// With more cuts than allowed, every triangle is painted once, and the remaining conflicts are counted.
void test_bound(void**) {
  auto* triangles = new Triangles;
  for (int i = 0; i < 120; ++i) {
    const double at = 2 + 0.5 * i, z = 0.1 + 0.0125 * at; /* along both rulings of 0.1 + 0.8 x y / 64^2 */
    const double along[3][3] = {{0, at, 0.1}, {64, at - 0.2, z}, {64, at + 0.2, z}};
    const double across[3][3] = {{at, 0, 0.1}, {at - 0.2, 64, z}, {at + 0.2, 64, z}};
    append(*triangles, along);
    append(*triangles, across);
  }
  auto* painting = new raster::Painting;
  make_painting(*triangles, {true, false, 0, 0}, painting);
  assert_int_equal(painting->cuts, triangles->size() + 1024);
  raster::SortGrid grid;
  raster::make_grid(g_context->allocator, k_area.pixels, painting->triangles.data(), painting->order.data(),
                    painting->order.size(), &grid);
  assert_true(raster::count_conflicts(*g_context, painting->triangles.data(), grid) > 1000);
  assert_true(painting->order.size() <= 3 * painting->cuts + triangles->size());
  auto* times = new std::vector<int>(painting->triangles.size());
  for (size_t i = 0; i < painting->order.size(); ++i) ++(*times)[painting->order[i]];
  for (int n : *times) assert_true(n <= 1);
  print_message("bound: %zu triangles, %zu cuts\n", triangles->size(), static_cast<size_t>(painting->cuts));
  delete times;
  delete painting;
  delete triangles;
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  CMUnitTest tests[24];
  size_t n = 0;
  for (const order_case& c : k_orders) tests[n++] = {c.name, test_order, nullptr, nullptr, const_cast<order_case*>(&c)};
  tests[n++] = {"pairs", test_pairs, nullptr, nullptr, nullptr};
  tests[n++] = {"cuts", test_cuts, nullptr, nullptr, nullptr};
  tests[n++] = {"bound", test_bound, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.raster.newell", tests, n, set_up, tear_down);
}
