// SPDX-License-Identifier: MIT
// The kernel of varyings: values against double, bits on every target, tails.
#include "raster/varyings.h"
#include "ref/varying_ref.h"
#include "unit/raster/interpolate_fixture.h"

namespace shd::tests {
namespace {

constexpr uint32_t kMax = SHD_MAX_VARYINGS;
constexpr float kCanary = -77.0f;

struct Table {
  raster::Varyings got, kept;
};
Table* g_table;

int set_up_table(void** state) {
  g_table = new Table;
  raster::allocate(g_allocator, kMax, &g_table->got);
  raster::allocate(g_allocator, kMax, &g_table->kept);
  return set_up(state);
}
int tear_down_table(void** state) {
  delete g_table;
  return tear_down(state);
}

/// Vertices of triangle `i` around raster position (x, y).
void make_triangle(Random* random, uint32_t i, float x, float y, bool behind) {
  const double turn = random->in(0.0, 6.28), reach = random->in(5.0, 300.0);
  for (int k = 0; k < 3; ++k) {
    const double angle = turn + 2.0944 * k, w = random->in(0.25, 8.0);
    float* v = row(g->vertices.raster, 3 * i + static_cast<uint32_t>(k));
    v[0] = static_cast<float>((double{x} + reach * std::cos(angle)) * w);
    v[1] = static_cast<float>((double{y} + reach * std::sin(angle)) * w);
    v[2] = 0.5f;
    v[3] = static_cast<float>(w);
    if (behind && k == static_cast<int>(i % 3)) v[0] = -v[0], v[1] = -v[1], v[3] = -v[3];
  }
}

/// A batch with a new triangle every `run` rows, and `count` varyings per vertex.
void make_batch(uint64_t seed, size_t run, uint32_t count, bool behind) {
  Random random = {seed};
  g->vertices.varying = core::Array<float>(g_allocator, kVertices * count);
  g->vertices.varying_count = count;
  for (float& value : g->vertices.varying) value = random.real(-10.0, 10.0);
  for (size_t v = 0; v < 4 * kVertices; ++v) g->vertices.world[v] = g->vertices.normal[v] = 0.5f;
  for (size_t i = 0; i < kBatch; ++i) {
    const auto triangle = static_cast<uint32_t>(i / run);
    const float x = i % run ? g->fragments.x[i - 1] + 1.0f : static_cast<float>(random.whole(0, 2047)) + 0.5f;
    const float y = i % run ? g->fragments.y[i - 1] : static_cast<float>(random.whole(0, 2047)) + 0.5f;
    if (i % run == 0) make_triangle(&random, triangle, x, y, behind);
    set_fragment(i, triangle, x, y);
  }
  finish(kBatch);
  raster::interpolate(best_target(), g->vertices, kEye, raster::kInterpolateAll, &g->fragments);
}

void set_modes(shd_interpolation (&modes)[kMax], uint32_t first) {
  for (uint32_t c = 0; c < kMax; ++c) modes[c] = static_cast<shd_interpolation>((first + c) % 3);
}

void run(const core::SimdTarget& target, const shd_interpolation* modes, raster::Varyings* out) {
  for (size_t i = 0; i < kMax * kBatch; ++i) out->block[i] = kCanary;
  raster::interpolate_varyings(target, g->vertices, modes, g->fragments, out);
}

void check_row(size_t i, const shd_interpolation* modes) {
  const raster::Fragments& f = g->fragments;
  double v[12];
  for (size_t k = 0; k < 12; ++k) v[k] = double{row(g->vertices.raster, f.vertex[k / 4][i])[k % 4]};
  for (uint32_t c = 0; c < g->vertices.varying_count; ++c) {
    float a[3];
    for (size_t k = 0; k < 3; ++k) a[k] = g->vertices.varying[size_t{f.vertex[k][i]} * g->vertices.varying_count + c];
    const double want = shd_ref_varying(v, a, double{f.x[i]}, double{f.y[i]}, modes[c]);
    const double error = modes[c] == SHD_INTERPOLATION_FLAT ? 0.0 : 5e-3;
    shd_assert_close("varying", kMax * i + c, double{g_table->got.column[c][i]}, want, error, 0.0);
  }
}

void test_oracle(void**) {
  for (uint32_t count : {1u, 3u, 7u, kMax}) {
    for (size_t length : {size_t{1}, size_t{5}, size_t{64}, kBatch}) {
      shd_interpolation modes[kMax];
      set_modes(modes, count);
      make_batch(3 * count + length, length, count, length == 5);
      for_each_target([&](const core::SimdTarget& target, bool first) {
        run(target, modes, &g_table->got);
        for (size_t i = 0; i < kBatch; ++i) check_row(i, modes);
        if (first) memcpy(g_table->kept.block.data(), g_table->got.block.data(), sizeof(float) * kMax * kBatch);
        if (memcmp(g_table->kept.block.data(), g_table->got.block.data(), sizeof(float) * kMax * kBatch) != 0)
          fail_msg("%s: other bits", target.name);
      });
      for (size_t i = count * kBatch; i < kMax * kBatch; ++i) assert_true(g_table->got.block[i] == kCanary);
    }
  }
}

/// Rows of one triangle, and of triangles that differ only in their number.
void test_uniform_and_gathered(void**) {
  shd_interpolation modes[kMax];
  set_modes(modes, 1);
  make_batch(5, kBatch, kMax, false);
  for_each_target([&](const core::SimdTarget& target, bool) {
    for (size_t i = 0; i < kBatch; ++i) g->fragments.triangle[i] = 0;
    run(target, modes, &g_table->kept);
    for (size_t i = 0; i < kBatch; ++i) g->fragments.triangle[i] = static_cast<uint32_t>(i);
    run(target, modes, &g_table->got);
    if (memcmp(g_table->kept.block.data(), g_table->got.block.data(), sizeof(float) * kMax * kBatch) != 0)
      fail_msg("%s: other bits", target.name);
  });
}

/// Rows of a triangle with rows of another one between them.
void test_interrupted(void**) {
  shd_interpolation modes[kMax];
  set_modes(modes, 2);
  for (uint32_t period = 2; period <= 17; ++period) {
    make_batch(19, 7, kMax, false);
    for (uint32_t i = 0; i < kBatch; ++i) {
      set_fragment(i, i % period == period / 2 ? 1 : 0, g->fragments.x[i], g->fragments.y[i]);
    }
    for_each_target([&](const core::SimdTarget& target, bool) {
      run(target, modes, &g_table->got);
      uint32_t names[kBatch];
      memcpy(names, g->fragments.triangle, sizeof names);
      for (uint32_t i = 0; i < kBatch; ++i) g->fragments.triangle[i] = i;
      run(target, modes, &g_table->kept);
      memcpy(g->fragments.triangle, names, sizeof names);
      if (memcmp(g_table->kept.block.data(), g_table->got.block.data(), sizeof(float) * kMax * kBatch) != 0)
        fail_msg("%s: other bits, period %u", target.name, period);
    });
  }
}

/// A row has the same bits in a batch of any size, and rows past the last vector do not change.
void test_counts(void**) {
  shd_interpolation modes[kMax];
  set_modes(modes, 0);
  make_batch(7, 7, 4, false);
  run(best_target(), modes, &g_table->kept);
  float x[kBatch], y[kBatch];
  memcpy(x, g->fragments.x, sizeof x);
  memcpy(y, g->fragments.y, sizeof y);
  for_each_target([&](const core::SimdTarget& target, bool) {
    for (size_t count = 1; count <= 200; ++count) {
      for (size_t i = 0; i < count; ++i) set_fragment(i, static_cast<uint32_t>(i / 7), x[i], y[i]);
      finish(count);
      raster::interpolate(target, g->vertices, kEye, raster::kInterpolateAll, &g->fragments);
      run(target, modes, &g_table->got);
      for (size_t c = 0; c < 4; ++c) {
        if (memcmp(g_table->got.column[c], g_table->kept.column[c], count * sizeof(float)) != 0)
          fail_msg("%s: count %zu column %zu", target.name, count, c);
        for (size_t i = data::padded(count); i < kBatch; ++i) assert_true(g_table->got.column[c][i] == kCanary);
      }
    }
  });
}

/// Tiny, huge and zero W, and positions at the limits of float: rows stay finite and between the vertices' values.
void test_extremes(void**) {
  static const float k_w[] = {0.0f, -0.0f, 1e-38f, 0x1p-100f, 0x1p-101f, 1e-30f, 1e20f, 3e38f, -3e38f};
  static const float k_x[] = {0.0f, 1e-40f, 1e10f, -1e30f, 3e38f};
  shd_interpolation modes[kMax];
  set_modes(modes, 0);
  make_batch(11, 1, kMax, false);
  Random random = {13};
  for (size_t v = 0; v < 3 * kBatch; ++v) {
    float* r = row(g->vertices.raster, v);
    if (random.whole(0, 1)) r[3] = k_w[random.whole(0, 8)];
    if (random.whole(0, 1)) r[random.whole(0, 1)] = k_x[random.whole(0, 4)];
  }
  raster::interpolate(best_target(), g->vertices, kEye, raster::kInterpolateAll, &g->fragments);
  for_each_target([&](const core::SimdTarget& target, bool first) {
    run(target, modes, first ? &g_table->kept : &g_table->got);
    for (size_t i = 0; i < kMax * kBatch && first; ++i) {
      if (!(std::fabs(g_table->kept.block[i]) <= 10.001f)) fail_msg("row %zu: %g", i, double{g_table->kept.block[i]});
    }
    if (!first && memcmp(g_table->kept.block.data(), g_table->got.block.data(), sizeof(float) * kMax * kBatch) != 0)
      fail_msg("%s: other bits", target.name);
  });
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  const CMUnitTest tests[] = {
      {"oracle", test_oracle, nullptr, nullptr, nullptr},
      {"bits/one_triangle_or_gathered", test_uniform_and_gathered, nullptr, nullptr, nullptr},
      {"bits/interrupted", test_interrupted, nullptr, nullptr, nullptr},
      {"bits/counts_1..200", test_counts, nullptr, nullptr, nullptr},
      {"extremes", test_extremes, nullptr, nullptr, nullptr},
  };
  return _cmocka_run_group_tests("unit.raster.varyings", tests, sizeof tests / sizeof tests[0], set_up_table,
                                 tear_down_table);
}
