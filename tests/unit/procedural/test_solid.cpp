// SPDX-License-Identifier: MIT
// Solid textures against their formulas in double, on every target: values, gradients, band limits, tails of batches.
#include <algorithm>

#include "solid_fixture.h"

namespace shd::tests {
namespace {

Points g_points, g_first;
procedural::Solid g_solid;

/// Largest |error| of one octave within 8 cells, and of a sum of octaves.
constexpr double kOctaveError = 4e-6, kSumError = 1e-4, kWoodError = 2e-5;  // rings have steep edges
constexpr size_t kChecked = 701;

/// Compares the first points with the oracle. Near the jumps of stripes and checkers only one side can be right.
void check_values(const solid_case& c, const shd_solid_desc& desc, bool has_width, double error) {
  for (size_t i = 0; i < kChecked; i += SHD_ORACLE_STRIDE) {
    const double place[3] = {double{g_points.x[i]}, double{g_points.y[i]}, double{g_points.z[i]}};
    double width = has_width ? double{g_points.width[i]} : 0.0;
    const bool is_wave = c.kind == SHD_SOLID_STRIPES || c.kind == SHD_SOLID_CHECKER;
    if (is_wave && width < 0x1p-12 * double{desc.size}) width = 0.0;
    const double relative = is_wave && width > 0 ? 2e-6 / fmin(width / double{desc.size}, 1.0) : 0.0;
    shd_assert_close(c.name, i, double{g_points.value[i]}, ref_value(c, desc, g_solid, place, width), error + relative,
                     0);
  }
}

/// Runs every target, and checks the first one; the bits of all others are the same.
template <class Check>
void on_every_target(bool has_width, bool has_gradient, const Check& check) {
  for_each_target([&](const core::SimdTarget& target, bool first) {
    assert_int_equal(run(g_solid, target, has_width, has_gradient, &g_points), 0);
    if (first) check();
    if (first) g_first = g_points;
    assert_memory_equal(g_first.value, g_points.value, sizeof g_first.value);
    assert_memory_equal(g_first.gradient, g_points.gradient, sizeof g_first.gradient);
  });
}

/// One octave, without and with pixels of any width.
void test_octave(void** state) {
  const auto& c = *static_cast<const solid_case*>(*state);
  Random random{11};
  g_points.count = kChecked;
  g_points.fill(&random, 8.0);
  shd_solid_desc desc = desc_of(c);
  desc.seed = 77;
  procedural::build(desc, &g_solid);
  for (const bool has_width : {false, true}) {
    const double error = c.kind == SHD_SOLID_WOOD ? kWoodError : kOctaveError;
    on_every_target(has_width, false, [&] { check_values(c, desc, has_width, error); });
  }
}

/// Sums of octaves as fBm and as turbulence, with another size, lacunarity and gain.
void test_sum(void** state) {
  const auto& c = *static_cast<const solid_case*>(*state);
  Random random{12};
  g_points.count = kChecked;
  g_points.fill(&random, 6.0);
  shd_solid_desc desc = desc_of(c);
  desc.seed = 3;
  desc.size = 0.5f;
  desc.octaves = 5;
  desc.lacunarity = 1.75f;
  desc.gain = 0.625f;
  desc.distortion = 0.5f;
  for (const shd_solid_sum sum : {SHD_SOLID_SUM_FBM, SHD_SOLID_SUM_TURBULENCE}) {
    desc.sum = sum;
    procedural::build(desc, &g_solid);
    on_every_target(true, false, [&] { check_values(c, desc, true, kSumError); });
  }
}

/// Gradients are the differences of the oracle, where these converge; values do not depend on them.
void test_gradient(void** state) {
  const auto& c = *static_cast<const solid_case*>(*state);
  Random random{13};
  g_points.count = 301;
  g_points.fill(&random, 4.0);
  shd_solid_desc desc = desc_of(c);
  desc.size = 0.75f;
  desc.octaves = 2;
  desc.sum = SHD_SOLID_SUM_TURBULENCE;
  procedural::build(desc, &g_solid);
  static float plain[kMaxPoints + 1];
  run(g_solid, best_target(), true, false, &g_points);
  memcpy(plain, g_points.value, sizeof plain);
  on_every_target(true, true, [&] { assert_memory_equal(plain, g_points.value, sizeof plain); });
  size_t compared = 0;
  for (size_t i = 0; i < g_points.count; i += SHD_ORACLE_STRIDE) {
    const bool is_wave = c.kind == SHD_SOLID_STRIPES || c.kind == SHD_SOLID_CHECKER;
    const double width = is_wave ? fmax(double{g_points.width[i]}, 0.01) : double{g_points.width[i]};
    if (is_wave && width != double{g_points.width[i]}) continue;  // 0 almost everywhere
    for (int axis = 0; axis < 3; ++axis) {
      const auto slope = [&](double h) {
        double before[3] = {double{g_points.x[i]}, double{g_points.y[i]}, double{g_points.z[i]}};
        double after[3] = {before[0], before[1], before[2]};
        before[axis] -= h;
        after[axis] += h;
        return (ref_value(c, desc, g_solid, after, width) - ref_value(c, desc, g_solid, before, width)) / (2 * h);
      };
      const double want = slope(1e-5), wider = slope(1e-3);
      if (fabs(want - wider) > 1e-3 * (1 + fabs(want))) continue;  // a kink
      shd_assert_close(c.name, 3 * i + static_cast<size_t>(axis), double{g_points.gradient[axis][i]}, want, 3e-3, 2e-3);
      ++compared;
    }
  }
  assert_true(compared > 250 / SHD_ORACLE_STRIDE);
}

/// Batches of every length up to several vectors: each value is that of the long batch, and nothing else is written.
void test_tails(void** state) {
  const auto& c = *static_cast<const solid_case*>(*state);
  Random random{14};
  g_points.fill(&random, 8.0);
  const shd_solid_desc desc = desc_of(c);
  procedural::build(desc, &g_solid);
  for_each_target([&](const core::SimdTarget& target, bool) {
    g_points.count = 64;
    run(g_solid, target, true, true, &g_points);
    g_first = g_points;
    for (size_t count = 0; count <= 37; ++count) {
      Points* const p = &g_points;
      p->count = count;
      run(g_solid, target, true, true, p);
      assert_memory_equal(p->value, g_first.value, count * sizeof(float));
      for (size_t i = count; i < 64; ++i) assert_true(p->value[i] == kCanary);
      for (size_t k = 0; k < 3; ++k) {
        assert_memory_equal(p->gradient[k], g_first.gradient[k], count * sizeof(float));
        for (size_t i = count; i < 64; ++i) assert_true(p->gradient[k][i] == kCanary);
      }
    }
  });
}

/// The classic form by hand. On the line between (4, -2, 300) and (5, -2, 300), only the x of two gradients counts.
void test_by_hand(void**) {
  shd_solid_desc desc = shd_solid_desc_default();
  desc.kind = SHD_SOLID_PERLIN;
  desc.gradients = SHD_SOLID_GRADIENTS_TABLE;
  desc.fade = SHD_SOLID_FADE_CUBIC;
  procedural::build(desc, &g_solid);
  const int32_t* const phi = g_solid.table.permutation;
  const int32_t jk = phi[(-2 + phi[300 % 256]) & 255];
  const double g4 = double{g_solid.table.x[(4 + jk) & 255]}, g5 = double{g_solid.table.x[(5 + jk) & 255]};
  // w(1/4) = 2/64 - 3/16 + 1 = 27/32, w(3/4) = 54/64 - 27/16 + 1 = 5/32
  const double want = 27.0 / 32 * g4 * 0.25 + 5.0 / 32 * g5 * -0.75;
  g_points.count = 1;
  g_points.x[0] = 4.25f, g_points.y[0] = -2.0f, g_points.z[0] = 300.0f;
  on_every_target(false, false, [&] { shd_assert_close("classic", 0, double{g_points.value[0]}, want, 1e-7, 0); });
}

/// The table has each index once, unit vectors, and its first element again at the end; seeds change it.
void test_table(void**) {
  static procedural::GradientTable tables[3];
  for (uint32_t seed = 0; seed < 3; ++seed) {
    const procedural::GradientTable& t = tables[seed];
    procedural::fill(seed, &tables[seed]);
    bool found[256] = {};
    for (size_t i = 0; i < 256; ++i) {
      assert_in_range(t.permutation[i], 0, 255);
      assert_false(found[t.permutation[i]]);
      found[t.permutation[i]] = true;
      const double x = double{t.x[i]}, y = double{t.y[i]}, z = double{t.z[i]};
      shd_assert_close("length", i, x * x + y * y + z * z, 1, 1e-6, 0);
    }
    assert_int_equal(t.permutation[256], t.permutation[0]);
    assert_true(t.x[256] == t.x[0] && t.y[256] == t.y[0] && t.z[256] == t.z[0]);
    for (uint32_t other = 0; other < seed; ++other) {
      assert_memory_not_equal(tables[other].permutation, t.permutation, sizeof t.permutation);
    }
  }
}

/// Stripes are c0 exactly where the sine is positive, at the integers too, and for any width of a stripe.
void test_stripe_edges(void**) {
  const float x[] = {0.0f, -0.0f, 0.25f, 0.5f, 0.75f, -0.25f, -0.125f, 1e-30f, -1e-30f, 1e9f, -3.4e38f};
  const float want[] = {1, 1, 1, 1, 1, 1, 1, 0, 1, 1, 1};
  shd_solid_desc desc = shd_solid_desc_default();
  desc.size = 0.25f;
  procedural::build(desc, &g_solid);
  g_points.count = 11;
  for (size_t i = 0; i < 11; ++i) {
    g_points.x[i] = x[i];
    g_points.y[i] = g_points.z[i] = 5.0f;
  }
  on_every_target(false, false, [&] {
    for (size_t i = 0; i < 11; ++i) shd_assert_close("stripe", i, double{g_points.value[i]}, double{want[i]}, 0, 0);
  });
}

/// Colours: those of the ramp at its ends, beyond them and in between, for every number of colours.
void test_colors(void**) {
  Random random{15};
  shd_solid_desc desc = shd_solid_desc_default();
  desc.kind = SHD_SOLID_PERLIN;
  for (auto& color : desc.colors) {
    for (float& component : color) component = random.real(-2.0, 2.0);
  }
  static float values[67], out[4][68];
  for (size_t i = 0; i < 67; ++i) values[i] = static_cast<float>(i) / 16.0f - 2.0f;
  for (desc.color_count = 2; desc.color_count <= SHD_MAX_SOLID_COLORS; ++desc.color_count) {
    procedural::build(desc, &g_solid);
    for_each_target([&](const core::SimdTarget& target, bool) {
      for (size_t count = 0; count <= 67; count += count < 35 ? 1 : 16) {
        for (auto& column : out) std::fill_n(column, 68, kCanary);
        float* const columns[4] = {out[0], nullptr, out[2], out[3]};
        procedural::find_colors(g_solid, target, values, count, columns);
        for (size_t i = 0; i < count; ++i) {
          const double steps = desc.color_count - 1.0;
          const double t = fmin(fmax((double{values[i]} + 1) / 2, 0), 1) * steps, k = fmin(floor(t), steps - 1);
          const auto at = static_cast<size_t>(k);
          for (size_t c : {0, 2, 3}) {
            const double a = double{desc.colors[at][c]}, b = double{desc.colors[at + 1][c]};
            shd_assert_close("color", i, double{out[c][i]}, a + (t - k) * (b - a), 2e-6, 0);
          }
        }
        for (auto& column : out) assert_true(column[count] == kCanary);
        assert_true(out[1][0] == kCanary);
      }
    });
  }
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  CMUnitTest tests[80];
  size_t n = add_solid_tests(
      {{"octave", test_octave}, {"sum", test_sum}, {"gradient", test_gradient}, {"tails", test_tails}}, tests);
  tests[n++] = {"classic_by_hand", test_by_hand, nullptr, nullptr, nullptr};
  tests[n++] = {"table", test_table, nullptr, nullptr, nullptr};
  tests[n++] = {"stripe_edges", test_stripe_edges, nullptr, nullptr, nullptr};
  tests[n++] = {"colors", test_colors, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.procedural.solid", tests, n, nullptr, nullptr);
}
