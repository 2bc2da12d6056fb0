// SPDX-License-Identifier: MIT
// binary16 against arithmetic on doubles: every half, every tie between neighbours, and the edges.
#include "support/check.h"

#include "image/half.h"

namespace {

using shd::image::float_to_half;
using shd::image::half_to_float;

uint32_t bits_of(float value) {
  uint32_t bits;
  memcpy(&bits, &value, sizeof bits);
  return bits;
}
float float_of(uint32_t bits) {
  float value;
  memcpy(&value, &bits, sizeof value);
  return value;
}

/// The definition: (-1)^s 2^(e-15) (1 + m/1024), or subnormal.
double oracle(uint32_t half) {
  const int exponent = static_cast<int>(half >> 10 & 31);
  const double mantissa = half & 1023;
  const double magnitude = exponent == 0 ? ldexp(mantissa, -24) : ldexp(1024 + mantissa, exponent - 25);
  return half & 0x8000 ? -magnitude : magnitude;
}

void test_decode_all(void**) {
  for (uint32_t half = 0; half < 65536; ++half) {
    const float value = half_to_float(static_cast<uint16_t>(half));
    if ((half & 0x7c00) == 0x7c00) {
      assert_true((half & 0x3ff) ? isnan(value) : isinf(value));
      assert_int_equal(bits_of(value) >> 31, half >> 15);
    } else {
      assert_true(static_cast<double>(value) == oracle(half));
      assert_int_equal(bits_of(value) >> 31, half >> 15);
    }
  }
}

void test_round_trip_all(void**) {
  for (uint32_t half = 0; half < 65536; ++half) {
    const uint16_t back = float_to_half(half_to_float(static_cast<uint16_t>(half)));
    const bool nan = (half & 0x7c00) == 0x7c00 && (half & 0x3ff);
    assert_int_equal(back, nan ? (half | 0x200) : half);
  }
}

void test_ties_and_neighbours(void**) {
  for (uint32_t half = 0; half < 0x7bff; ++half) {
    const double low = oracle(half), high = oracle(half + 1);
    const auto tie = static_cast<float>((low + high) / 2);  // exact: one more bit
    assert_true(static_cast<double>(tie) == (low + high) / 2);
    const uint32_t even = half & 1 ? half + 1 : half;
    assert_int_equal(float_to_half(tie), even);
    assert_int_equal(float_to_half(-tie), even | 0x8000);
    assert_int_equal(float_to_half(float_of(bits_of(tie) - 1)), half);
    assert_int_equal(float_to_half(float_of(bits_of(tie) + 1)), half + 1);
  }
}

struct edge_case {
  const char* name;
  uint32_t bits;
  uint16_t expected;
};
const edge_case k_edges[] = {
    {"encode/zero", 0, 0},
    {"encode/minus_zero", 0x80000000u, 0x8000},
    {"encode/smallest_float", 1, 0},
    {"encode/half_of_smallest_half", 0x33000000u, 0},
    {"encode/above_half_of_smallest_half", 0x33000001u, 1},
    {"encode/65504", 0x477fe000u, 0x7bff},
    {"encode/below_65520", 0x477fefffu, 0x7bff},
    {"encode/65520", 0x477ff000u, 0x7c00},
    {"encode/flt_max", 0x7f7fffffu, 0x7c00},
    {"encode/infinity", 0x7f800000u, 0x7c00},
    {"encode/minus_infinity", 0xff800000u, 0xfc00},
    {"encode/quiet_nan", 0x7fc00000u, 0x7e00},
    {"encode/signalling_nan_low_payload", 0x7f800001u, 0x7e00},
    {"encode/minus_nan", 0xffffffffu, 0xffff},
};

void test_edge(void** state) {
  const auto* c = static_cast<const edge_case*>(*state);
  assert_int_equal(float_to_half(float_of(c->bits)), c->expected);
}

}  // namespace

int main() {
  CMUnitTest tests[32];
  size_t n = 0;
  tests[n++] = {"decode/all", test_decode_all, nullptr, nullptr, nullptr};
  tests[n++] = {"round_trip/all", test_round_trip_all, nullptr, nullptr, nullptr};
  tests[n++] = {"encode/ties_and_neighbours", test_ties_and_neighbours, nullptr, nullptr, nullptr};
  for (const edge_case& c : k_edges) tests[n++] = {c.name, test_edge, nullptr, nullptr, const_cast<edge_case*>(&c)};
  return _cmocka_run_group_tests("unit.image.half", tests, n, nullptr, nullptr);
}
