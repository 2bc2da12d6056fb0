// SPDX-License-Identifier: MIT
// sRGB tables against IEC 61966-2-1 in long double.
#include "support/check.h"

#include "image/srgb.h"

namespace {

using shd::image::linear_to_srgb8;
using shd::image::srgb8_to_linear;

long double decode(long double c) {
  return c <= 0.04045L ? c / 12.92L : powl((c + 0.055L) / 1.055L, 2.4L);
}
long double encode(long double c) {
  return c <= 0.0031308L ? c * 12.92L : 1.055L * powl(c, 1 / 2.4L) - 0.055L;
}

/// Correct rounding to a code, clamped to the range of a byte.
int encode8(float linear) {
  if (!(linear > 0)) return 0;
  if (linear >= 1) return 255;
  return static_cast<int>(floorl(255 * encode(static_cast<long double>(linear)) + 0.5L));
}

float float_of(uint32_t bits) {
  float value;
  memcpy(&value, &bits, sizeof value);
  return value;
}
uint32_t bits_of(float value) {
  uint32_t bits;
  memcpy(&bits, &value, sizeof bits);
  return bits;
}

void test_decode_all(void**) {
  for (int code = 0; code < 256; ++code) {
    const auto want = static_cast<float>(decode(static_cast<long double>(code) / 255));
    assert_true(srgb8_to_linear(static_cast<uint8_t>(code)) == want);
  }
}

void test_round_trip(void**) {
  for (int code = 0; code < 256; ++code) {
    assert_int_equal(linear_to_srgb8(srgb8_to_linear(static_cast<uint8_t>(code))), code);
  }
}

void test_thresholds(void**) {
  for (int k = 1; k < 256; ++k) {
    const float threshold = shd::image::kLinearToSrgb8Threshold[k];
    const float below = float_of(bits_of(threshold) - 1);
    assert_int_equal(encode8(threshold), k);
    assert_int_equal(encode8(below), k - 1);
    assert_int_equal(linear_to_srgb8(threshold), k);
    assert_int_equal(linear_to_srgb8(below), k - 1);
    assert_int_equal(linear_to_srgb8(float_of(bits_of(threshold) + 1)), k);
  }
}

void test_sweep(void**) {
  for (uint32_t bits = 0; bits < 0x3f900000u; bits += 4099) {
    assert_int_equal(linear_to_srgb8(float_of(bits)), encode8(float_of(bits)));
  }
}

struct edge_case {
  const char* name;
  uint32_t bits;
  int expected;
};
const edge_case k_edges[] = {
    {"encode/zero", 0, 0},
    {"encode/minus_zero", 0x80000000u, 0},
    {"encode/smallest_float", 1, 0},
    {"encode/minus_one", 0xbf800000u, 0},
    {"encode/below_2^-13", 0x38ffffffu, 0},
    {"encode/2^-13", 0x39000000u, 0},
    {"encode/below_one", 0x3f7fffffu, 255},
    {"encode/one", 0x3f800000u, 255},
    {"encode/flt_max", 0x7f7fffffu, 255},
    {"encode/infinity", 0x7f800000u, 255},
    {"encode/minus_infinity", 0xff800000u, 0},
    {"encode/nan", 0x7fc00000u, 0},
    {"encode/minus_nan", 0xffc00000u, 0},
};

void test_edge(void** state) {
  const auto* c = static_cast<const edge_case*>(*state);
  assert_int_equal(linear_to_srgb8(float_of(c->bits)), c->expected);
}

}  // namespace

int main() {
  CMUnitTest tests[32];
  size_t n = 0;
  tests[n++] = {"decode/all", test_decode_all, nullptr, nullptr, nullptr};
  tests[n++] = {"round_trip/all", test_round_trip, nullptr, nullptr, nullptr};
  tests[n++] = {"encode/thresholds", test_thresholds, nullptr, nullptr, nullptr};
  tests[n++] = {"encode/sweep", test_sweep, nullptr, nullptr, nullptr};
  for (const edge_case& c : k_edges) tests[n++] = {c.name, test_edge, nullptr, nullptr, const_cast<edge_case*>(&c)};
  return _cmocka_run_group_tests("unit.image.srgb", tests, n, nullptr, nullptr);
}
