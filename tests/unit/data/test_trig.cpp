// SPDX-License-Identifier: MIT
// Angles, tangents and cosines in double against long double arithmetic of the C library.
#include <initializer_list>

#include "support/check.h"

#include "data/trig.h"

namespace {

using shd::data::angle_of;
using shd::data::kPi;

void check_angle(const char* what, size_t index, double y, double x) {
  const long double want = atan2l(y, x);
  const auto error = static_cast<double>(fabsl(static_cast<long double>(angle_of(y, x)) - want));
  if (!(error <= 1e-15 * static_cast<double>(want) + 1e-300)) {
    fail_msg("%s[%zu]: angle_of(%.17g, %.17g) is off by %g", what, index, y, x, error);
  }
}

void test_angle_sweep(void**) {
  for (size_t i = 0; i <= 100000; ++i) {
    const double angle = kPi * static_cast<double>(i) / 100000.0;
    check_angle("circle", i, fabs(sin(angle)), cos(angle));
    check_angle("long", i, fabs(sin(angle)) * 1e100, cos(angle) * 1e100);
    check_angle("short", i, fabs(sin(angle)) * 1e-100, cos(angle) * 1e-100);
  }
}

void test_angle_slivers(void**) {
  for (int e = -300; e <= 300; ++e) {
    const double small = pow(10.0, e);
    check_angle("y", static_cast<size_t>(e + 300), small, 1.0);
    check_angle("y, backwards", static_cast<size_t>(e + 300), small, -1.0);
    check_angle("x", static_cast<size_t>(e + 300), 1.0, small);
    check_angle("minus x", static_cast<size_t>(e + 300), 1.0, -small);
  }
}

void test_angle_edges(void**) {
  assert_true(angle_of(0.0, 0.0) == 0.0);
  assert_true(angle_of(0.0, 1.0) == 0.0);
  assert_true(angle_of(0.0, -1.0) == kPi);
  assert_true(angle_of(1.0, 0.0) == 0.5 * kPi);
  assert_true(angle_of(1e308, 1e308) == angle_of(1.0, 1.0));
  assert_true(angle_of(1e-308, 1e-308) == angle_of(1.0, 1.0));
}

void test_tan(void**) {
  for (size_t i = 1; i < 200000; ++i) {
    const double x = 0.5 * kPi * static_cast<double>(i) / 200000.0;
    const long double want = tanl(static_cast<long double>(x));
    const auto error = static_cast<double>(fabsl(static_cast<long double>(shd::data::tan(x)) - want) / want);
    if (!(error <= 1e-15)) fail_msg("tan(%.17g) is off by %g", x, error);
  }
}

void test_cos(void**) {
  for (size_t i = 0; i <= 200000; ++i) {
    const double x = 0.5 * kPi * static_cast<double>(i) / 200000.0;
    const auto error =
        static_cast<double>(fabsl(static_cast<long double>(shd::data::cos(x)) - cosl(static_cast<long double>(x))));
    if (!(error <= 1e-15)) fail_msg("cos(%.17g) is off by %g", x, error);
  }
}

void test_sin(void**) {
  for (size_t i = 0; i <= 200000; ++i) {
    const double x = 0.5 * kPi * static_cast<double>(i) / 200000.0;
    const auto error =
        static_cast<double>(fabsl(static_cast<long double>(shd::data::sin(x)) - sinl(static_cast<long double>(x))));
    if (!(error <= 1e-15)) fail_msg("sin(%.17g) is off by %g", x, error);
  }
}

void test_circle(void**) {
  constexpr long double kTurn = 6.28318530717958647692528676655900577L;
  for (const uint32_t n : {1u, 2u, 3u, 4u, 7u, 8u, 12u, 100u, 1023u, 4096u, 8192u}) {
    for (uint32_t i = 0; i <= n; ++i) {
      const shd::data::CirclePoint p = shd::data::circle_point(i, n), mirrored = shd::data::circle_point(n - i, n);
      const long double angle = kTurn * i / n;
      shd_assert_close("cosine", i, p.cosine, static_cast<double>(cosl(angle)), 1e-15, 0);
      shd_assert_close("sine", i, p.sine, static_cast<double>(sinl(angle)), 1e-15, 0);
      assert_true(p.cosine == mirrored.cosine && p.sine == -mirrored.sine);
      assert_false((p.cosine == 0 && std::signbit(p.cosine)) || (p.sine == 0 && std::signbit(p.sine)));
      if (n % 4 == 0 && i <= n / 4) {
        const shd::data::CirclePoint other = shd::data::circle_point(n / 4 - i, n);
        assert_true(p.cosine == other.sine && p.sine == other.cosine);
      }
    }
  }
  assert_true(shd::data::circle_point(1, 4).cosine == 0 && shd::data::circle_point(1, 4).sine == 1);
  assert_true(shd::data::circle_point(2, 4).cosine == -1 && shd::data::circle_point(4, 4).cosine == 1);
}

void test_tan_edges(void**) {
  assert_true(shd::data::tan(0.0) == 0.0);
  assert_true(shd::data::tan(1e-300) == 1e-300);
  const double below = 0.5 * static_cast<double>(3.1415925f);  // the widest possible field of view
  assert_true(fabs(shd::data::tan(below) / static_cast<double>(tanl(below)) - 1.0) <= 1e-15);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      {"angle/sweep", test_angle_sweep, nullptr, nullptr, nullptr},
      {"angle/slivers", test_angle_slivers, nullptr, nullptr, nullptr},
      {"angle/edges", test_angle_edges, nullptr, nullptr, nullptr},
      {"tan/sweep", test_tan, nullptr, nullptr, nullptr},
      {"cos/sweep", test_cos, nullptr, nullptr, nullptr},
      {"sin/sweep", test_sin, nullptr, nullptr, nullptr},
      {"circle", test_circle, nullptr, nullptr, nullptr},
      {"tan/edges", test_tan_edges, nullptr, nullptr, nullptr},
  };
  return cmocka_run_group_tests_name("unit.data.trig", tests, nullptr, nullptr);
}
