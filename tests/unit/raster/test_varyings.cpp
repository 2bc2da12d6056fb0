// SPDX-License-Identifier: MIT
// The kernel of varyings: values against double, bits on every target, tails.
#include "raster/varyings.h"
#include "ref/raster_ref.h"
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
  choose_tile(&random);
  uint32_t pixel = 0;
  for (size_t i = 0; i < kBatch; ++i, ++pixel) {
    const auto triangle = static_cast<uint32_t>(i / run);
    if (i % run == 0) {
      pixel = static_cast<uint32_t>(random.whole(0, kTile * kTile - 1));
      make_triangle(&random, triangle, centre_of(pixel).x, centre_of(pixel).y, behind);
    }
    set_fragment(i, triangle, pixel);
  }
  finish(kBatch);
  raster::interpolate(best_target(), g->vertices, kEye, raster::kInterpolateAll, &g->fragments);
}

void set_modes(shd_interpolation (&modes)[kMax], uint32_t first) {
  for (uint32_t c = 0; c < kMax; ++c) modes[c] = static_cast<shd_interpolation>((first + c) % 3);
}

void run(const core::SimdTarget& target, const shd_interpolation* modes, raster::Varyings* out) {
  for (float& value : out->block) value = kCanary;
  raster::interpolate_varyings(target, g->vertices, modes, g->fragments, out);
}

/// Fails unless the rows of the table equal those that were kept.
void compare_table(const char* name) {
  for (size_t c = 0; c < kMax; ++c) {
    if (memcmp(g_table->kept.column[c], g_table->got.column[c], sizeof(float) * g->fragments.count) != 0)
      fail_msg("%s: other bits in column %zu", name, c);
  }
}

/// Compares a row with the oracle, if its point is in front of the eye.
void check_row(size_t i, const shd_interpolation* modes) {
  const raster::Fragments& f = g->fragments;
  float corners[3][4];
  for (size_t k = 0; k < 3; ++k)
    memcpy(corners[k], row(g->vertices.raster, vertex_of(f.triangle[i], k)), sizeof corners[k]);
  const ref::Weights weights = ref::homogeneous_weights(corners, f.x[i], f.y[i]);
  if (!(ref::interpolated_w(corners, weights) > 0)) return;
  double v[12];
  for (size_t k = 0; k < 12; ++k) v[k] = double{row(g->vertices.raster, vertex_of(f.triangle[i], k / 4))[k % 4]};
  for (uint32_t c = 0; c < g->vertices.varying_count; ++c) {
    float a[3];
    for (size_t k = 0; k < 3; ++k)
      a[k] = g->vertices.varying[size_t{vertex_of(f.triangle[i], k)} * g->vertices.varying_count + c];
    const double want = shd_ref_varying(v, a, double{f.x[i]}, double{f.y[i]}, modes[c]);
    const double errors[] = {2e-5, 5e-3, 0.0};  // by shd_interpolation
    const double error = errors[modes[c]];
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
        if (first)
          memcpy(g_table->kept.block.data(), g_table->got.block.data(), sizeof(float) * kMax * raster::kColumn);
        compare_table(target.name);
      });
      for (size_t i = count * raster::kColumn; i < kMax * raster::kColumn; ++i) {
        assert_true(g_table->got.block[i] == kCanary);
      }
    }
  }
}

/// Rows of one triangle have the same bits one by one, and with rows of another triangle between them.
void test_spans(void**) {
  shd_interpolation modes[kMax];
  set_modes(modes, 1);
  make_batch(5, kBatch, kMax, false);
  for (size_t i = 3; i < kVertices; ++i) g->indices[i] = g->indices[i % 3];
  for_each_target([&](const core::SimdTarget& target, bool) {
    for (size_t i = 0; i < kBatch; ++i) g->fragments.triangle[i] = 0;
    run(target, modes, &g_table->kept);
    for (uint32_t period = 1; period <= 17; ++period) {
      for (uint32_t i = 0; i < kBatch; ++i) g->fragments.triangle[i] = period == 1 ? i : i % period == period / 2;
      run(target, modes, &g_table->got);
      compare_table(target.name);
    }
  });
  for (uint32_t i = 0; i < kVertices; ++i) g->indices[i] = i;
}

/// A row has the same bits in a batch of any size, and rows past the last vector do not change.
void test_counts(void**) {
  shd_interpolation modes[kMax];
  set_modes(modes, 0);
  make_batch(7, 7, 4, false);
  run(best_target(), modes, &g_table->kept);
  uint32_t pixel[kBatch];
  memcpy(pixel, g->fragments.pixel, sizeof pixel);
  for_each_target([&](const core::SimdTarget& target, bool) {
    for (size_t count = 1; count <= 200; ++count) {
      for (size_t i = 0; i < count; ++i) set_fragment(i, static_cast<uint32_t>(i / 7), pixel[i]);
      finish(count);
      raster::interpolate(target, g->vertices, kEye, raster::kInterpolateAll, &g->fragments);
      run(target, modes, &g_table->got);
      compare_table(target.name);
      for (size_t c = 0; c < 4; ++c) {
        for (size_t i = data::padded(count) + 16; i < kBatch; ++i) assert_true(g_table->got.column[c][i] == kCanary);
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
      const double value = double{g_table->kept.column[i / kBatch][i % kBatch]};
      if (!(std::fabs(value) <= 10.001)) fail_msg("row %zu: %g", i % kBatch, value);
    }
    if (!first) compare_table(target.name);
  });
  g->vertices.affine = true;
  for_each_target([&](const core::SimdTarget& target, bool first) {
    raster::interpolate(target, g->vertices, kEye, raster::kInterpolateAll, &g->fragments);
    if (first) keep_rows();
    compare_rows(target.name);
    for (size_t i = 0; i < kBatch; ++i) {
      for (const float* bary : g->fragments.bary) assert_true(bary[i] >= 0.0f && bary[i] <= 1.0f);
      assert_true(std::isfinite(g->fragments.u[i]) && std::isfinite(g->fragments.dudx[i]));
    }
  });
  g->vertices.affine = false;
}

/// Compares the attributes of a row with the oracle, if its point is in front of the eye: their weights, and a texture
/// coordinate with its derivatives, which are the same at all pixels.
void check_affine_row(size_t i) {
  const raster::Fragments& f = g->fragments;
  double v[12], b[3], a[3], u = 0.0, px = 0.0;
  float corners[3][4];
  bool on_screen = true;
  for (size_t k = 0; k < 3; ++k) {
    memcpy(corners[k], row(g->vertices.raster, vertex_of(f.triangle[i], k)), sizeof corners[k]);
    for (size_t c = 0; c < 4; ++c) v[4 * k + c] = double{corners[k][c]};
    on_screen = on_screen && corners[k][3] > 0.0f;
  }
  if (!(ref::interpolated_w(corners, ref::homogeneous_weights(corners, f.x[i], f.y[i])) > 0)) return;
  shd_ref_weights(v, double{f.x[i]}, double{f.y[i]}, SHD_INTERPOLATION_AFFINE, b);
  for (size_t k = 0; k < 3; ++k) {
    const float* world = row(g->vertices.world, vertex_of(f.triangle[i], k));
    a[k] = double{world[3]};
    u += b[k] * a[k];
    px += b[k] * double{world[0]};
    shd_assert_close("bary", i, double{f.bary[k][i]}, b[k], 2e-6, 0.0);
  }
  shd_assert_close("px", i, double{f.px[i]}, px, 1e-5, 0.0);
  if (!on_screen) return;
  if (b[0] > 0.01 && b[1] > 0.01 && b[2] > 0.01) shd_assert_close("u", i, double{f.u[i]}, u, 1e-5, 0.0);
  double x[3], y[3];
  for (size_t k = 0; k < 3; ++k) x[k] = v[4 * k] / v[4 * k + 3], y[k] = v[4 * k + 1] / v[4 * k + 3];
  const double x1 = x[1] - x[0], y1 = y[1] - y[0], x2 = x[2] - x[0], y2 = y[2] - y[0];
  const double area = x1 * y2 - x2 * y1, a1 = a[1] - a[0], a2 = a[2] - a[0];
  shd_assert_close("dudx", i, double{f.dudx[i]}, (a1 * y2 - a2 * y1) / area, 1e-6, 1e-5);
  shd_assert_close("dudy", i, double{f.dudy[i]}, (a2 * x1 - a1 * x2) / area, 1e-6, 1e-5);
}

/// Attributes of a draw with SHD_DRAW_AFFINE.
void test_affine_draw(void**) {
  const shd_interpolation modes[2] = {SHD_INTERPOLATION_PERSPECTIVE, SHD_INTERPOLATION_AFFINE};
  for (const bool behind : {false, true}) {
    Random random = {29};
    make_batch(17, 5, 2, behind);
    for (float& value : g->vertices.world) value = random.real(-2.0, 2.0);
    for (float& value : g->vertices.normal) value = random.real(-2.0, 2.0);
    for (size_t i = 0; i < kVertices; ++i) g->vertices.varying[2 * i + 1] = g->vertices.varying[2 * i];
    g->vertices.affine = true;
    for_each_target([&](const core::SimdTarget& target, bool first) {
      raster::interpolate(target, g->vertices, kEye, raster::kInterpolateAll, &g->fragments);
      if (first) keep_rows();
      compare_rows(target.name);
      for (size_t i = 0; i < kBatch && first; ++i) check_affine_row(i);
      run(target, modes, &g_table->got);
      for (size_t i = 0; i < kBatch && !behind; ++i) {
        shd_assert_close("varying", i, double{g_table->got.column[0][i]}, double{g_table->got.column[1][i]}, 5e-3, 0.0);
      }
      compare_lit(target);
    });
    g->vertices.affine = false;
  }
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  const CMUnitTest tests[] = {
      {"oracle", test_oracle, nullptr, nullptr, nullptr},
      {"bits/spans", test_spans, nullptr, nullptr, nullptr},
      {"bits/counts_1..200", test_counts, nullptr, nullptr, nullptr},
      {"extremes", test_extremes, nullptr, nullptr, nullptr},
      {"affine_draw", test_affine_draw, nullptr, nullptr, nullptr},
  };
  return _cmocka_run_group_tests("unit.raster.varyings", tests, sizeof tests / sizeof tests[0], set_up_table,
                                 tear_down_table);
}
