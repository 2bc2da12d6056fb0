// SPDX-License-Identifier: MIT
// Log2, Exp2, Pow, SinPi and CosPi against libm in double, rounding against libm bit for bit, on every target, and bit
// for bit between targets.
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>

namespace shd::tests {
#ifndef SHD_TESTS_MATH_FUNCTIONS
#define SHD_TESTS_MATH_FUNCTIONS
enum Function { kLog2, kExp2, kPow, kUnitPow, kSinPi, kCosPi, kRoundDown, kRoundUp, kRoundNearest };
#endif
}  // namespace shd::tests

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "unit/simd/test_math.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "simd/math-inl.h"
#include "simd/round-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::tests::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// out[i] = f(x[i]) or x[i]^y[i]; count is a multiple of the lanes.
void evaluate(int function, const float* x, const float* y, size_t count, float* out) {
  const hn::ScalableTag<float> d;
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto a = hn::LoadU(d, x + i);
    auto result = a;
    if (function == kLog2) result = simd::HWY_NAMESPACE::Log2(d, a);
    if (function == kExp2) result = simd::HWY_NAMESPACE::Exp2(d, a);
    if (function == kUnitPow) result = simd::HWY_NAMESPACE::UnitPow(d, a, hn::LoadU(d, y + i));
    if (function == kPow) result = simd::HWY_NAMESPACE::Pow(d, a, hn::LoadU(d, y + i));
    if (function == kSinPi) result = simd::HWY_NAMESPACE::SinPi(d, a);
    if (function == kCosPi) result = simd::HWY_NAMESPACE::CosPi(d, a);
    if (function == kRoundDown) result = simd::HWY_NAMESPACE::RoundDown(a);
    if (function == kRoundUp) result = simd::HWY_NAMESPACE::RoundUp(a);
    if (function == kRoundNearest) result = simd::HWY_NAMESPACE::RoundNearest(a);
    hn::StoreU(result, d, out + i);
  }
}

}  // namespace shd::tests::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "core/simd_target.h"
#include "support/check.h"

namespace shd::tests {
HWY_EXPORT(evaluate);
namespace {

constexpr size_t kCount = 1 << 16;
float g_x[kCount], g_y[kCount], g_out[kCount], g_first[kCount];

float float_from_bits(uint32_t bits) {
  float value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

/// Deterministic numbers in [0, 2^32).
uint32_t next(uint32_t* state) {
  return *state = *state * 1664525u + 1013904223u;
}

template <class Check>
void on_every_target(int function, Check check) {
  bool first = true;
  for (int64_t bit : hwy::SupportedAndGeneratedTargets()) {
    const core::SimdTarget target = core::simd_target_from_bit(bit);
    SHD_DISPATCH(evaluate, target)(function, g_x, g_y, kCount, g_out);
    for (size_t i = 0; i < kCount; ++i) check(i);
    if (first) std::memcpy(g_first, g_out, sizeof g_out);
    first = false;
    for (size_t i = 0; i < kCount; ++i) {
      if (std::isnan(g_first[i]) ? !std::isnan(g_out[i]) : std::memcmp(&g_first[i], &g_out[i], 4) != 0) {
        fail_msg("%s: x %a: %a differs from %a", target.name, static_cast<double>(g_x[i]),
                 static_cast<double>(g_out[i]), static_cast<double>(g_first[i]));
      }
    }
  }
}

void test_log2(void**) {
  uint32_t state = 1;
  for (size_t i = 0; i < kCount; ++i) {
    g_x[i] = i % 2 ? float_from_bits(next(&state) & 0x7fffffffu) : 1.0f + static_cast<float>(i) * 1e-6f - 0.03f;
  }
  const float edges[] = {0.0f, -0.0f, 1.0f, FLT_MIN, FLT_MAX, 1.4e-45f, INFINITY, NAN, -1.0f, -INFINITY, 2.0f, 0.5f};
  std::memcpy(g_x, edges, sizeof edges);
  on_every_target(kLog2, [](size_t i) {
    shd_assert_close("log2", i, g_out[i], std::log2(static_cast<double>(g_x[i])), 0.0, 4e-7);
  });
}

void test_exp2(void**) {
  uint32_t state = 2;
  for (size_t i = 0; i < kCount; ++i) g_x[i] = static_cast<float>(next(&state)) * (300.0f / 4294967296.0f) - 152.0f;
  const float edges[] = {0.0f,    -0.0f,    1.0f,      127.99999f, 128.0f, -149.0f,
                         -151.0f, INFINITY, -INFINITY, NAN,        1e30f,  -1e30f};
  std::memcpy(g_x, edges, sizeof edges);
  on_every_target(kExp2, [](size_t i) {
    const double want = std::exp2(static_cast<double>(g_x[i]));
    if (want > static_cast<double>(FLT_MAX)) {
      shd_assert_close("exp2", i, g_out[i], INFINITY, 0.0, 0.0);
    } else {
      shd_assert_close("exp2", i, g_out[i], want, 1.5e-45, 2e-7);
    }
  });
}

/// Sines and cosines of places in a few periods, at the quarters of the period, and of the largest numbers.
void test_waves(void**) {
  uint32_t state = 5;
  const double pi = 3.14159265358979324;
  for (size_t i = 0; i < kCount; ++i) {
    g_x[i] = i < 64 ? static_cast<float>(i) / 4.0f - 8.0f : static_cast<float>(next(&state)) * 0x1p-29f - 4.0f;
  }
  const float edges[] = {-0.0f, 1e-45f, FLT_MAX, -FLT_MAX, 8388607.5f, 1048576.25f, 0.49999997f, 0.50000006f};
  std::memcpy(g_x + 64, edges, sizeof edges);
  for (const Function function : {kSinPi, kCosPi}) {
    on_every_target(function, [&](size_t i) {
      const double x = std::fmod(static_cast<double>(g_x[i]), 2.0);
      const double want = function == kSinPi ? std::sin(pi * x) : std::cos(pi * x);
      shd_assert_close("wave", i, static_cast<double>(g_out[i]), want, 3e-7, 0.0);
      if (function == kSinPi && std::floor(x) == x) assert_true(g_out[i] == 0.0f);
    });
  }
}

/// Whole numbers have the bits of libm, with the sign of a zero.
void test_rounding(void**) {
  uint32_t state = 7;
  for (size_t i = 0; i < kCount; ++i) {
    const float number = float_from_bits(next(&state));
    g_x[i] = i % 2 ? static_cast<float>(next(&state)) * 0x1p-29f - 4.0f : std::isfinite(number) ? number : 0.0f;
  }
  const float edges[] = {0.0f,        -0.0f,      0.3f,        -0.3f,         0.5f,        -0.5f,
                         1.5f,        -1.5f,      2.5f,        1e-45f,        -1e-45f,     FLT_MAX,
                         -FLT_MAX,    8388607.5f, -8388607.5f, 8388608.0f,    -8388609.0f, 0.49999997f,
                         -0.9999999f, INFINITY,   -INFINITY,   2147483648.0f, -4e9f,       NAN};
  std::memcpy(g_x, edges, sizeof edges);
  float (*const wanted[])(float) = {std::floor, std::ceil, std::nearbyint};
  for (int k = 0; k < 3; ++k) {
    on_every_target(kRoundDown + k, [&](size_t i) {
      const float want = wanted[k](g_x[i]);
      const bool same = std::isnan(want) ? std::isnan(g_out[i]) : std::memcmp(&want, &g_out[i], sizeof want) == 0;
      if (!same) {
        fail_msg("function %d of %a: got %a, want %a", k, static_cast<double>(g_x[i]), static_cast<double>(g_out[i]),
                 static_cast<double>(want));
      }
    });
  }
}

void fill_powers() {
  uint32_t state = 3;
  for (size_t i = 0; i < kCount; ++i) {
    g_x[i] = static_cast<float>(next(&state)) / 4294967296.0f;
    g_y[i] = std::exp2(static_cast<float>(next(&state)) * (20.0f / 4294967296.0f));
  }
  const float edges[][2] = {{0.0f, 0.0f}, {0.0f, 5.0f}, {1.0f, 1e6f}, {0.5f, 0.0f}, {0.0f, 1e6f}, {0.9999f, 1e6f}};
  for (size_t i = 0; i < 6; ++i) {
    g_x[i] = edges[i][0];
    g_y[i] = edges[i][1];
  }
}

void test_pow(void**) {
  fill_powers();
  on_every_target(kPow, [](size_t i) {
    const double x = static_cast<double>(g_x[i]), y = static_cast<double>(g_y[i]);
    const double want = std::pow(x, y);
    const double exponent = x > 0.0 ? std::fmin(std::fabs(y * std::log2(x)), 160.0) : 0.0;
    shd_assert_close("pow", i, g_out[i], want, 1.5e-45, exponent * 4e-7 + 3e-7);
  });
}

/// UnitPow has the bits of Pow, except 0 for results below 2^-96 and bases that are negative or not normal.
void test_unit_pow(void**) {
  static float pow[kCount];
  fill_powers();
  g_x[7] = 1e-40f, g_y[7] = 0.25f;        // a base
  g_x[8] = 0.5f, g_y[8] = 96.0f;          // the last result
  g_x[9] = 0.5f, g_y[9] = 0x1.800002p6f;  // the first one below
  for (size_t i = 10; i < 16; ++i) g_x[i] = i % 2 ? -1.0f : NAN, g_y[i] = i < 12 ? 0.0f : static_cast<float>(i);
  HWY_DYNAMIC_DISPATCH(evaluate)(kPow, g_x, g_y, kCount, pow);
  for (size_t i = 0; i < kCount; ++i) {
    if (!(g_x[i] >= 0.0f)) pow[i] = 0.0f;
    if (g_y[i] != 0.0f && (pow[i] < 0x1p-96f || g_x[i] < 0x1p-126f)) pow[i] = 0.0f;
  }
  on_every_target(kUnitPow, [](size_t i) {
    if (std::memcmp(&g_out[i], &pow[i], sizeof(float)) != 0) {
      fail_msg("%g^%g: %g instead of %g", double{g_x[i]}, double{g_y[i]}, double{g_out[i]}, double{pow[i]});
    }
  });
  assert_true(pow[7] == 0.0f && pow[8] == 0x1p-96f && pow[9] == 0.0f);
}

}  // namespace
}  // namespace shd::tests

int main() {
  const CMUnitTest tests[] = {
      {"log2", shd::tests::test_log2, nullptr, nullptr, nullptr},
      {"exp2", shd::tests::test_exp2, nullptr, nullptr, nullptr},
      {"pow", shd::tests::test_pow, nullptr, nullptr, nullptr},
      {"unit_pow", shd::tests::test_unit_pow, nullptr, nullptr, nullptr},
      {"waves", shd::tests::test_waves, nullptr, nullptr, nullptr},
      {"rounding", shd::tests::test_rounding, nullptr, nullptr, nullptr},
  };
  return cmocka_run_group_tests_name("unit.simd.math", tests, nullptr, nullptr);
}
#endif  // HWY_ONCE
