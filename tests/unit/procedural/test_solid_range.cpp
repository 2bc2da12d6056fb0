// SPDX-License-Identifier: MIT
// Solid textures: the factors that keep noise in -1..1, the means of octaves, and hostile places.
#include <algorithm>
#include <cfloat>

#include "solid_fixture.h"

namespace shd::tests {
namespace {

Points g_points, g_other;
procedural::Solid g_solid;

/// The largest product of a place with one of the twelve gradients: the sum of its two largest coordinates.
double largest_product(const double (&p)[3]) {
  const double a = fabs(p[0]), b = fabs(p[1]), c = fabs(p[2]);
  return a + b + c - fmin(a, fmin(b, c));
}

/// The largest value of hashed Perlin noise at a place in a cell, over all gradients of the corners.
double perlin_bound(const double (&p)[3], shd_solid_fade fade) {
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    double weight = 1, to[3];
    for (int c = 0; c < 3; ++c) {
      to[c] = p[c] - (corner >> c & 1);
      weight *= ref::solid_weight(fade, to[c]);
    }
    sum += weight * largest_product(to);
  }
  return ref::solid_factor(fade) * sum;
}

/// The largest value of simplex noise at a place.
double simplex_bound(const double (&p)[3], shd_solid_fade) {
  double sum = 0;
  for (int n = 0; n < 64; ++n) {
    const int i = n % 4 - 1, j = n / 4 % 4 - 1, k = n / 16 - 1;
    const double unskew = (i + j + k) / 6.0;
    const double to[3] = {p[0] - i + unskew, p[1] - j + unskew, p[2] - k + unskew};
    const double t = fmax(0.5 - to[0] * to[0] - to[1] * to[1] - to[2] * to[2], 0);
    sum += t * t * t * t * largest_product(to);
  }
  return 76.88 * sum;
}

/// Noise lies in -1..1 for every choice of gradients, and the range is used: the largest sum over a grid of places,
/// refined around its maximum.
template <class Bound>
void check_bound(const Bound& bound, shd_solid_fade fade) {
  double best = 0, centre[3] = {0.5, 0.5, 0.5}, half = 0.5;
  for (int round = 0; round < 6; ++round) {
    double next[3] = {centre[0], centre[1], centre[2]};
    constexpr int kSteps = 20;
    for (int n = 0; n < (kSteps + 1) * (kSteps + 1) * (kSteps + 1); ++n) {
      const int at[3] = {n % (kSteps + 1), n / (kSteps + 1) % (kSteps + 1), n / ((kSteps + 1) * (kSteps + 1))};
      double p[3];
      for (int c = 0; c < 3; ++c) p[c] = centre[c] + half * (2.0 * at[c] / kSteps - 1.0);
      const double value = bound(p, fade);
      if (value <= best) continue;
      best = value;
      std::copy_n(p, 3, next);
    }
    std::copy_n(next, 3, centre);
    half *= 0.2;
  }
  print_message("largest |n|: %.6f\n", best);
  assert_true(best <= 1.0 && best > 0.9995);
}

void test_bounds(void**) {
  check_bound(perlin_bound, SHD_SOLID_FADE_QUINTIC);
  check_bound(perlin_bound, SHD_SOLID_FADE_CUBIC);
  check_bound(perlin_bound, SHD_SOLID_FADE_LINEAR);
  check_bound(simplex_bound, SHD_SOLID_FADE_QUINTIC);
}

/// Random places stay in the range of their kind, and the means that replace octaves are those of the noise.
void test_mean(void** state) {
  const auto& c = *static_cast<const solid_case*>(*state);
  Random random{21};
  shd_solid_desc desc = desc_of(c);
  double sum = 0, absolute = 0;
  constexpr uint32_t kRounds = 24;
  for (uint32_t round = 0; round < kRounds; ++round) {
    desc.seed = round;
    procedural::build(desc, &g_solid);
    g_points.count = kMaxPoints;
    g_points.fill(&random, 100.0);
    run(g_solid, best_target(), false, false, &g_points);
    for (size_t i = 0; i < kMaxPoints; ++i) {
      const double value = double{g_points.value[i]};
      assert_true(value >= (can_fold(c) ? -1.0 : 0.0) && value <= 1.0);
      sum += value;
      absolute += fabs(value);
    }
  }
  sum /= kRounds * kMaxPoints;
  absolute /= kRounds * kMaxPoints;
  if (can_fold(c)) shd_assert_close("mean", 0, sum, 0, 0.005, 0);
  if (can_fold(c) || c.kind == SHD_SOLID_WORLEY) shd_assert_close("mean", 1, absolute, c.mean_absolute, 0.004, 0);
  if (c.kind == SHD_SOLID_WOOD) shd_assert_close("mean", 2, sum, 0.515, 0.005, 0);
  if (c.kind == SHD_SOLID_MARBLE) shd_assert_close("mean", 3, sum, 0.5, 0.005, 0);
}

/// A place that is not finite counts as 0 in that coordinate, in every lane, and is counted.
void test_nonfinite(void** state) {
  const auto& c = *static_cast<const solid_case*>(*state);
  const float bad[] = {NAN, -NAN, INFINITY, -INFINITY};
  procedural::build(desc_of(c), &g_solid);
  for_each_target([&](const core::SimdTarget& target, bool) {
    for (size_t lane = 0; lane < 35; ++lane) {
      Random random{22};
      g_points.fill(&random, 5.0);
      g_points.count = 35;
      g_other = g_points;
      const size_t column = lane % 3;
      (column == 0 ? g_points.x : column == 1 ? g_points.y : g_points.z)[lane] = bad[lane % 4];
      (column == 0 ? g_other.x : column == 1 ? g_other.y : g_other.z)[lane] = 0.0f;
      assert_int_equal(run(g_solid, target, true, true, &g_points), 1);
      assert_int_equal(run(g_solid, target, true, true, &g_other), 0);
      assert_memory_equal(g_points.value, g_other.value, sizeof g_other.value);
      assert_memory_equal(g_points.gradient, g_other.gradient, sizeof g_other.gradient);
    }
  });
}

/// NaN and negative widths count as 0, infinite ones as the widest; only those that are not finite are counted.
void test_widths(void** state) {
  const auto& c = *static_cast<const solid_case*>(*state);
  const float widths[] = {NAN, -1.0f, -INFINITY, INFINITY, FLT_MAX, -0.0f, 1e-45f};
  const float same[] = {0.0f, 0.0f, 0.0f, FLT_MAX, FLT_MAX, 0.0f, 1e-45f};
  procedural::build(desc_of(c), &g_solid);
  Random random{23};
  g_points.fill(&random, 5.0);
  g_points.count = 35;
  g_other = g_points;
  for (size_t i = 0; i < 35; ++i) {
    g_points.width[i] = widths[i % 7];
    g_other.width[i] = same[i % 7];
  }
  for_each_target([&](const core::SimdTarget& target, bool) {
    assert_int_equal(run(g_solid, target, true, true, &g_points), 15);
    assert_int_equal(run(g_solid, target, true, true, &g_other), 0);
    assert_memory_equal(g_points.value, g_other.value, sizeof g_other.value);
    assert_memory_equal(g_points.gradient, g_other.gradient, sizeof g_other.gradient);
  });
}

/// Places of every magnitude, with the extremes of every number: values stay in the range, gradients are finite, and
/// all targets agree.
void test_hostile(void** state) {
  const auto& c = *static_cast<const solid_case*>(*state);
  const float places[] = {0.0f,       -0.0f,       1e-45f,        -1e-45f, 1e9f,        -1e9f,
                          8388608.0f, -8388609.0f, 2147483648.0f, 1.0f,    16777215.0f, FLT_MAX,
                          -FLT_MAX,   0.99999994f, -1e-8f,        -1.0f,   255.5f,      -256.0f};
  constexpr size_t kPlaces = sizeof places / sizeof places[0];
  for (const float size : {1.0f, 1e-30f, 1e30f}) {
    for (const float lacunarity : {1.0f, 16.0f}) {
      shd_solid_desc desc = desc_of(c);
      desc.size = size;
      desc.octaves = 32;
      desc.lacunarity = lacunarity;
      desc.gain = 1.0f;
      desc.distortion = 1000.0f;
      desc.seed = 0xffffffffu;
      procedural::build(desc, &g_solid);
      g_points.count = kPlaces * kPlaces;
      for (size_t i = 0; i < g_points.count; ++i) {
        g_points.x[i] = places[i % kPlaces];
        g_points.y[i] = places[i / kPlaces];
        g_points.z[i] = places[(i * 7 + i / kPlaces) % kPlaces];
        g_points.width[i] = i % 3 ? fabsf(places[i * 5 % kPlaces]) : 0.0f;
      }
      for_each_target([&](const core::SimdTarget& target, bool first) {
        assert_int_equal(run(g_solid, target, true, true, &g_points), 0);
        for (size_t i = 0; i < g_points.count; ++i) {
          assert_true(fabsf(g_points.value[i]) <= 1.0f);
          for (const auto& column : g_points.gradient) assert_true(fabsf(column[i]) <= 1e30f);
        }
        if (first) g_other = g_points;
        assert_memory_equal(g_points.value, g_other.value, sizeof g_other.value);
        assert_memory_equal(g_points.gradient, g_other.gradient, sizeof g_other.gradient);
      });
    }
  }
}

/// Pixels as wide as the shortest wave of an octave leave its mean; narrower ones than half of it change nothing.
void test_band_limit(void**) {
  for (const solid_case& c : k_solids) {
    if (!can_fold(c)) continue;
    Random random{24};
    shd_solid_desc desc = desc_of(c);
    desc.octaves = 3;
    procedural::build(desc, &g_solid);
    g_points.count = 100;
    g_points.fill(&random, 9.0);
    std::fill_n(g_points.width, 100, 0.125f);  // 1/2 of the wave of the third octave
    g_other = g_points;
    run(g_solid, best_target(), true, false, &g_points);
    run(g_solid, best_target(), false, false, &g_other);
    assert_memory_equal(g_points.value, g_other.value, 100 * sizeof(float));
    std::fill_n(g_points.width, 100, 1.0f);
    run(g_solid, best_target(), true, false, &g_points);
    for (size_t i = 0; i < 100; ++i) assert_true(g_points.value[i] == 0.0f);
  }
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  CMUnitTest tests[80];
  size_t n = add_solid_tests(
      {{"mean", test_mean}, {"nonfinite", test_nonfinite}, {"width", test_widths}, {"hostile", test_hostile}}, tests);
  tests[n++] = {"bounds", test_bounds, nullptr, nullptr, nullptr};
  tests[n++] = {"band_limit", test_band_limit, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.procedural.solid_range", tests, n, nullptr, nullptr);
}
