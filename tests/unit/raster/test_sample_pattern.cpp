// SPDX-License-Identifier: MIT
// Sample patterns against the table "Standard sample locations" in the section "Multisampling" of the Vulkan 1.3
// specification (limit standardSampleLocations), which has the positions and the order of
// D3D11_STANDARD_MULTISAMPLE_PATTERN. The values are those of the table, as fractions of a pixel.
#include "support/check.h"

#include "raster/sample_pattern.h"

namespace {

using shd::raster::sample_pattern;
using shd::raster::SamplePattern;

struct place {
  double x, y;
};
struct pattern_case {
  const char* name;
  uint32_t count;
  place places[16];
};

const pattern_case k_patterns[] = {
    {"standard/1", 1, {{0.5, 0.5}}},
    {"standard/2", 2, {{0.75, 0.75}, {0.25, 0.25}}},
    {"standard/4", 4, {{0.375, 0.125}, {0.875, 0.375}, {0.125, 0.625}, {0.625, 0.875}}},
    {"standard/8",
     8,
     {{0.5625, 0.3125},
      {0.4375, 0.6875},
      {0.8125, 0.5625},
      {0.3125, 0.1875},
      {0.1875, 0.8125},
      {0.0625, 0.4375},
      {0.6875, 0.9375},
      {0.9375, 0.0625}}},
    {"standard/16",
     16,
     {{0.5625, 0.5625},
      {0.4375, 0.3125},
      {0.3125, 0.625},
      {0.75, 0.4375},
      {0.1875, 0.375},
      {0.625, 0.8125},
      {0.8125, 0.6875},
      {0.6875, 0.1875},
      {0.375, 0.875},
      {0.5, 0.0625},
      {0.25, 0.125},
      {0.125, 0.75},
      {0.0, 0.5},
      {0.9375, 0.25},
      {0.875, 0.9375},
      {0.0625, 0.0}}},
};

void test_positions(void** state) {
  const auto* c = static_cast<const pattern_case*>(*state);
  const SamplePattern& pattern = sample_pattern(c->count);
  assert_int_equal(pattern.count, c->count);
  for (uint32_t s = 0; s < c->count; ++s) {
    if (pattern.point[s].x != 256 * c->places[s].x || pattern.point[s].y != 256 * c->places[s].y) {
      fail_msg("sample %u: (%d, %d) / 256, want (%g, %g)", s, pattern.point[s].x, pattern.point[s].y, c->places[s].x,
               c->places[s].y);
    }
  }
}

/// The derived columns: lanes of a vector hold the samples of one pixel after the other, sums are those of the bits.
void test_columns(void** state) {
  const auto* c = static_cast<const pattern_case*>(*state);
  const SamplePattern& pattern = sample_pattern(c->count);
  for (uint32_t lane = 0; lane < 16; ++lane) {
    const place& want = c->places[lane % c->count];
    assert_true(pattern.x[lane] == 256 * want.x && pattern.y[lane] == 256 * want.y);
    assert_true(pattern.pixel_x[lane] == want.x && pattern.pixel_y[lane] == want.y);
    assert_int_equal(pattern.column[lane], lane / c->count);
  }
  for (uint32_t mask = 0; mask < 1u << c->count; ++mask) {
    double x = 0, y = 0;
    int count = 0;
    for (uint32_t s = 0; s < c->count; ++s) {
      if (!(mask >> s & 1)) continue;
      x += c->places[s].x;
      y += c->places[s].y;
      ++count;
    }
    const shd::raster::PointSum sum = sum_of_points(pattern, mask);
    assert_true(sum.x == 256 * x && sum.y == 256 * y && sum.count == count);
  }
}

}  // namespace

int main() {
  constexpr size_t kCount = sizeof k_patterns / sizeof k_patterns[0];
  CMUnitTest tests[2 * kCount];
  static char names[kCount][32];
  size_t n = 0;
  for (size_t i = 0; i < kCount; ++i) {
    auto* c = const_cast<pattern_case*>(&k_patterns[i]);
    tests[n++] = {c->name, test_positions, nullptr, nullptr, c};
    snprintf(names[i], sizeof names[i], "columns/%u", c->count);
    tests[n++] = {names[i], test_columns, nullptr, nullptr, c};
  }
  return _cmocka_run_group_tests("unit.raster.sample_pattern", tests, n, nullptr, nullptr);
}
