// SPDX-License-Identifier: MIT
// Interpolation of vertices at the ends of the range of float: finite vertices give finite rows.
#include <cfloat>

#include "unit/raster/interpolate_fixture.h"

namespace shd::tests {
namespace {

struct extreme_case {
  const char* name;
  float raster[3][4];
  float attribute[3];  // world position, u and v of the vertices
};
const extreme_case k_extremes[] = {
    {"finite/point", {{5, 5, 0, 1}, {5, 5, 0, 1}, {5, 5, 0, 1}}, {1, 2, 3}},
    {"finite/line", {{0, 0, 0, 1}, {10, 10, 0, 1}, {20, 20, 0, 1}}, {1, 2, 3}},
    {"finite/all_zero", {{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}}, {1, 2, 3}},
    {"finite/w_zero", {{1, 0, 0, 0}, {0, 1, 0, 0}, {1, 1, 0, 0}}, {1, 2, 3}},
    {"finite/all_behind", {{-5, -5, 0, -1}, {-9, -5, 0, -1}, {-5, -9, 0, -1}}, {1, 2, 3}},
    {"finite/w_smallest", {{0, 0, 0, 1.4e-45f}, {1.4e-45f, 0, 0, 1.4e-45f}, {0, 1.4e-45f, 0, 1.4e-45f}}, {1, 2, 3}},
    {"finite/w_2^-100", {{0, 0, 0, 0x1p-100f}, {0x1p-90f, 0, 0, 0x1p-100f}, {0, 0x1p-90f, 0, 0x1p-100f}}, {1, 2, 3}},
    {"finite/w_largest", {{0, 0, 0, FLT_MAX}, {FLT_MAX, 0, 0, FLT_MAX}, {0, FLT_MAX, 0, FLT_MAX}}, {1, 2, 3}},
    {"finite/w_2^60", {{0, 0, 0, 0x1p60f}, {0x1p68f, 0, 0, 0x1p60f}, {0, 0x1p68f, 0, 0x1p60f}}, {1, 2, 3}},
    {"finite/w_ratio_2^200", {{0, 0, 0, 0x1p-100f}, {0x1p101f, 0, 0, 0x1p100f}, {0, 0x1p101f, 0, 0x1p100f}}, {1, 2, 3}},
    {"finite/guard_band", {{-1e6f, -1e6f, 0, 1}, {1e6f, 0, 0, 1}, {0, 1e6f, 0, 1}}, {1, 2, 3}},
    {"finite/attribute_range", {{0, 0, 0, 1}, {20, 0, 0, 1}, {0, 20, 0, 1}}, {FLT_MAX, -FLT_MAX, FLT_MAX}},
    {"finite/attribute_largest", {{0, 0, 0, 1}, {20, 0, 0, 1}, {0, 20, 0, 1}}, {FLT_MAX, FLT_MAX, FLT_MAX}},
    {"finite/attribute_smallest", {{0, 0, 0, 1}, {20, 0, 0, 1}, {0, 20, 0, 1}}, {1.4e-45f, 0, -1.4e-45f}},
    {"finite/steep", {{5.5f, 5.5f, 0, 1}, {5.5001f, 5.5f, 0, 1}, {5.5f, 5.5001f, 0, 1}}, {1e38f, -1e38f, 1e38f}},
};

/// No column contains NaN or infinity; barycentrics are in 0..1 and sum to 1; attributes stay between those of the
/// vertices.
void check_finite(const char* name, float low, float high) {
  const raster::Fragments& f = g->fragments;
  const ColumnList columns = columns_of(f);
  for (size_t i = 0; i < f.count; ++i) {
    for (size_t c = 0; c < kColumns; ++c) {
      const float value = columns.column[c][i];
      if (!std::isfinite(value)) fail_msg("%s: row %zu column %zu is %g", name, i, c, double{value});
    }
    double sum = 0.0;
    for (int k = 0; k < 3; ++k) {
      if (!(f.bary[k][i] >= 0.0f && f.bary[k][i] <= 1.0f)) fail_msg("%s: row %zu bary %g", name, i, f.bary[k][i]);
      sum += double{f.bary[k][i]};
    }
    shd_assert_close("sum of bary", i, sum, 1.0, 1.3e-7, 0.0);
    const double slack = 4e-7 * std::max(std::fabs(double{low}), std::fabs(double{high}));
    for (const float* column : {f.px, f.u, f.v}) {
      if (!(column[i] >= double{low} - slack && column[i] <= double{high} + slack)) {
        fail_msg("%s: row %zu attribute %g is not in %g..%g", name, i, column[i], low, high);
      }
    }
  }
}

void set_extreme(const float (*raster_rows)[4], const float* attribute) {
  for (size_t k = 0; k < 3; ++k) {
    memcpy(row(g->vertices.raster, k), raster_rows[k], 4 * sizeof(float));
    for (int c = 0; c < 4; ++c) row(g->vertices.world, k)[c] = attribute[k];
    const float normal[4] = {0.0f, 0.0f, k == 1 ? -1.0f : 1.0f, attribute[k]};
    memcpy(row(g->vertices.normal, k), normal, sizeof normal);
  }
}

void run_extreme(const char* name, const float* attribute) {
  const auto range = std::minmax({attribute[0], attribute[1], attribute[2]});
  const float low = range.first, high = range.second;
  for_each_target([&](const core::SimdTarget& target, bool first) {
    raster::interpolate(target, g->vertices, kEye, raster::kInterpolateAll, &g->fragments);
    check_finite(name, low, high);
    if (first) keep_rows();
    compare_rows(target.name);
    compare_lit(target);
  });
}

void test_extreme(void** state) {
  const auto* c = static_cast<const extreme_case*>(*state);
  set_extreme(c->raster, c->attribute);
  // The first and the last tile of the largest picture.
  for (const int32_t place : {0, 65536 - raster::kTile}) {
    g->fragments.left = g->fragments.top = place;
    const uint32_t pixels[] = {5 * kTile + 5, 0, kTile * kTile - 1, kTile - 1};
    for (size_t i = 0; i < 64; ++i) set_fragment(i, 0, pixels[i % 4]);
    finish(64);
    run_extreme(c->name, c->attribute);
  }
}

/// Finite floats with random bit patterns.
void test_random_bits(void**) {
  Random random = {41};
  for (int n = 0; n < 3000; ++n) {
    float v[3][4], attribute[3];
    for (auto& vertex : v) {
      for (float& c : vertex) c = random.scaled(-149.0, 127.99);
    }
    for (float& a : attribute) a = random.scaled(n % 2 ? 100.0 : -149.0, 127.99);
    set_extreme(v, attribute);
    choose_tile(&random);
    for (size_t i = 0; i < 64; ++i) {
      set_fragment(i, 0, static_cast<uint32_t>(random.whole(0, kTile * kTile - 1)));
    }
    finish(64);
    run_extreme("random", attribute);
  }
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  CMUnitTest tests[32];
  size_t n = 0;
  for (const extreme_case& c : k_extremes) {
    tests[n++] = {c.name, test_extreme, nullptr, nullptr, const_cast<extreme_case*>(&c)};
  }
  tests[n++] = {"finite/random_bits", test_random_bits, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.raster.interpolate_range", tests, n, set_up, tear_down);
}
