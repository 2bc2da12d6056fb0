// SPDX-License-Identifier: MIT
// The order of the painter's algorithm, and the number of its conflicts, against a test of every pair.
#include "paint_fixture.h"

namespace shd::tests {
namespace {

core::Context* g_context;

int set_up(void**) {
  g_context = core::create_context(shd_context_desc_default());
  return 0;
}
int tear_down(void**) {
  core::release(*g_context);
  return 0;
}

/// Rules of a test, by draw: 0 plain, 1 falling, 2 biased, 3 not painted, 4 biased by slope.
const raster::PaintRule k_rules[] = {
    {true, false, 0, 0}, {true, true, 0, 0}, {true, false, -0.25f, 0}, {false, false, 0, 0}, {true, false, 0, 2.0f}};

double reference_distance(const ScreenTriangle& t) {
  const raster::PaintRule& rule = k_rules[t.draw];
  const ref::DepthPlane plane = ref::plane_of(t);
  const double steepest = 256 * static_cast<double>(std::max(ref::magnitude(plane.dx), ref::magnitude(plane.dy)));
  double farthest = -HUGE_VAL;
  for (float z : t.z) {
    const double depth =
        static_cast<double>(z) + static_cast<double>(rule.bias) + static_cast<double>(rule.slope_bias) * steepest;
    farthest = std::max(farthest, rule.falls ? -depth : depth);
  }
  return farthest;
}

/// Triangles of every rule, some with equal depths, in 1..7 groups.
void test_sort(void**) {
  Random random = {5};
  for (size_t group_count = 1; group_count <= 7; ++group_count) {
    auto* triangles = new Triangles(make_tangle(random, 300, 10));
    for (size_t i = 0; i < triangles->size(); ++i) {
      ScreenTriangle& t = (*triangles)[i];
      t.draw = static_cast<uint32_t>(random.whole(0, 4));
      if (t.draw != 4 && i % 3 == 0) t.z[0] = t.z[1] = t.z[2] = 0.25f * static_cast<float>(random.whole(0, 4));
    }
    auto* groups = new core::Objects<raster::TriangleGroup>(g_context->allocator, group_count);
    fill_groups(*g_context, *triangles, groups);
    const size_t painted = raster::sort_far_to_near(*g_context, k_rules, groups);
    auto* sorted = new Triangles(read_groups(*groups));
    assert_int_equal(sorted->size(), triangles->size());
    for (size_t i = 0; i < sorted->size(); ++i) {
      const ScreenTriangle& t = (*sorted)[i];
      assert_int_equal(k_rules[t.draw].painted, i < painted);
      assert_memory_equal(&t, &(*triangles)[t.primitive], sizeof t);
      if (i == 0) continue;
      const ScreenTriangle& before = (*sorted)[i - 1];
      const double gap = i < painted ? reference_distance(before) - reference_distance(t) : 0;
      if (i == painted) continue;
      if (gap < -1e-6) fail_msg("%zu groups: %zu is farther than %zu by %g", group_count, i, i - 1, -gap);
      if (gap == 0) assert_true(before.primitive < t.primitive);
    }
    delete sorted;
    delete groups;
    delete triangles;
  }
}

struct conflict_case {
  const char* name;
  Triangles (*make)();
};
const conflict_case k_conflicts[] = {
    {"conflicts/one", [] { return make_tangle({1}, 1, 20); }},
    {"conflicts/layers", [] { return make_layers({2}, 40); }},
    {"conflicts/circle_of_3", [] { return make_circle(3, 0.1); }},
    {"conflicts/circle_of_7", [] { return make_circle(7, 0.3); }},
    {"conflicts/tangle_of_large", [] { return make_tangle({3}, 25, 50); }},
    {"conflicts/tangle_of_small", [] { return make_tangle({4}, 400, 3); }},
    {"conflicts/floor", [] { return make_floor({5}, 12); }},
};

/// Tests every pair of the painter's order.
void test_conflicts(void** state) {
  const auto* c = static_cast<const conflict_case*>(*state);
  auto* groups = new core::Objects<raster::TriangleGroup>(g_context->allocator, 3);
  fill_groups(*g_context, c->make(), groups);
  const size_t painted = raster::sort_far_to_near(*g_context, k_rules, groups);
  auto* sorted = new Triangles(read_groups(*groups));
  auto* triangles = new std::vector<raster::SortTriangle>;
  auto* order = new std::vector<uint32_t>;
  for (const ScreenTriangle& t : *sorted) {
    order->push_back(static_cast<uint32_t>(triangles->size()));
    triangles->push_back(raster::make_sort_triangle(t, k_rules[0]));
  }
  assert_int_equal(painted, sorted->size());
  uint64_t sure = 0, possible = 0;
  for (size_t i = 0; i < sorted->size(); ++i) {
    for (size_t k = i + 1; k < sorted->size(); ++k) {
      const double by = ref::nearer_by((*sorted)[i], (*sorted)[k]);
      sure += by > 1e-9;
      possible += by > -1e-9;
    }
  }
  raster::SortGrid grid;
  raster::make_grid(g_context->allocator, {0, 0, kEdge - 1, kEdge - 1}, triangles->data(), order->data(), order->size(),
                    &grid);
  const uint64_t got = raster::count_conflicts(*g_context, triangles->data(), grid);
  print_message("%s: %zu triangles, %llu conflicts\n", c->name, sorted->size(), static_cast<unsigned long long>(got));
  if (got < sure || got > possible) {
    fail_msg("%s: %llu conflicts, want %llu..%llu", c->name, static_cast<unsigned long long>(got),
             static_cast<unsigned long long>(sure), static_cast<unsigned long long>(possible));
  }
  delete order;
  delete triangles;
  delete sorted;
  delete groups;
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  CMUnitTest tests[16];
  size_t n = 0;
  for (const conflict_case& c : k_conflicts) {
    tests[n++] = {c.name, test_conflicts, nullptr, nullptr, const_cast<conflict_case*>(&c)};
  }
  tests[n++] = {"sort", test_sort, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.raster.painter", tests, n, set_up, tear_down);
}
