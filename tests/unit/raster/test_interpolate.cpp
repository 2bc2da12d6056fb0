// SPDX-License-Identifier: MIT
// Interpolation against 113-bit arithmetic with running error bounds; its tails and bits.
#include "ref/raster_ref.h"
#include "unit/raster/interpolate_fixture.h"

namespace shd::tests {
namespace {

using ref::Bounded;
using ref::Real;

/// Vertices 3t, 3t + 1, 3t + 2 around raster position (x, y).
using Scene = void (*)(Random* random, float x, float y, float (*v)[4]);

void place(float* v, double x, double y, double w) {
  v[0] = static_cast<float>(x * w);
  v[1] = static_cast<float>(y * w);
  v[2] = static_cast<float>(0.5 * w);
  v[3] = static_cast<float>(w);
}

void triangle_around(Random* random, float x, float y, double reach, double w_low, double w_high, float (*v)[4]) {
  const double turn = random->in(0.0, 6.28);
  for (int k = 0; k < 3; ++k) {
    const double angle = turn + 2.0944 * k + random->in(-0.5, 0.5), r = reach * random->in(0.5, 1.5);
    place(v[k], double{x} + r * std::cos(angle), double{y} + r * std::sin(angle), std::exp2(random->in(w_low, w_high)));
  }
}

void ordinary(Random* random, float x, float y, float (*v)[4]) {
  triangle_around(random, x, y, random->in(1.0, 300.0), 0.0, 2.0, v);
}
void pixel_sized(Random* random, float x, float y, float (*v)[4]) {
  triangle_around(random, x, y, random->in(0.1, 1.0), 0.0, 0.1, v);
}
void same_w(Random* random, float x, float y, float (*v)[4]) {
  triangle_around(random, x, y, 50.0, 0.0, 0.0, v);
}
/// Triangles of one w, small and large, with w of either sign and of sizes that only some of the kernels take.
void same_w_any_size(Random* random, float x, float y, float (*v)[4]) {
  const double w = std::ldexp(random->whole(0, 1) ? 1.0 : -1.0, random->whole(-20, 20));
  triangle_around(random, x, y, std::exp2(random->in(-2.0, 11.0)), 0.0, 0.0, v);
  for (int k = 0; k < 3; ++k) {
    for (int c = 0; c < 4; ++c) v[k][c] = static_cast<float>(v[k][c] * w);
  }
}
/// Triangles of one w among others.
void some_of_same_w(Random* random, float x, float y, float (*v)[4]) {
  (random->whole(0, 1) ? same_w_any_size : ordinary)(random, x, y, v);
}
void w_ratio_2_40(Random* random, float x, float y, float (*v)[4]) {
  triangle_around(random, x, y, 50.0, -20.0, 20.0, v);
}
void tiny_w(Random* random, float x, float y, float (*v)[4]) {
  triangle_around(random, x, y, 50.0, -52.0, -50.0, v);
}
void large_w(Random* random, float x, float y, float (*v)[4]) {
  triangle_around(random, x, y, 50.0, 30.0, 32.0, v);
}
/// One or two vertices behind the eye, in general position: any three points with W of either sign.
void behind_the_eye(Random* random, float x, float y, float (*v)[4]) {
  triangle_around(random, x, y, 200.0, 0.0, 3.0, v);
  const int count = random->whole(1, 2);
  for (int k = 0; k < count; ++k) {
    for (int c = 0; c < 4; ++c) v[k][c] = 0.0f - v[k][c];
  }
}
void w_exactly_zero(Random* random, float x, float y, float (*v)[4]) {
  triangle_around(random, x, y, 200.0, 0.0, 3.0, v);
  v[0][3] = 0.0f;
}
/// A needle through the pixel, 0.02 pixel wide.
void sliver(Random* random, float x, float y, float (*v)[4]) {
  const double angle = random->in(0.0, 6.28), c = std::cos(angle), s = std::sin(angle);
  const double along[3] = {-random->in(20.0, 200.0), random->in(20.0, 200.0), random->in(20.0, 200.0)};
  for (int k = 0; k < 3; ++k) {
    const double across = k == 0 ? 0.0 : k == 1 ? 0.01 : -0.01;
    place(v[k], double{x} + along[k] * c - across * s, double{y} + along[k] * s + across * c,
          std::exp2(random->in(0.0, 1.0)));
  }
}

struct scene_case {
  const char* name;
  Scene scene;
  double error;  // largest |error| of a barycentric coordinate, from measurements; 0 = only the running bound
};
const scene_case k_scenes[] = {
    {"oracle/ordinary", ordinary, 1e-4},
    {"oracle/pixel_sized", pixel_sized, 1e-2},
    {"oracle/same_w", same_w, 1e-6},
    {"oracle/same_w_any_size", same_w_any_size, 0.0},
    {"oracle/some_of_same_w", some_of_same_w, 0.0},
    {"oracle/w_ratio_2^40", w_ratio_2_40, 0.0},
    {"oracle/w_2^-52", tiny_w, 1e-5},
    {"oracle/w_2^32", large_w, 1e-5},
    {"oracle/behind_the_eye", behind_the_eye, 0.0},
    {"oracle/w_exactly_zero", w_exactly_zero, 0.0},
    {"oracle/sliver", sliver, 0.0},
};

void set_attributes(Random* random, size_t vertex, double size) {
  double n[3], length = 0.0;
  for (double& c : n) {
    c = random->in(-1.0, 1.0);
    length += c * c;
  }
  float *world = row(g->vertices.world, vertex), *normal = row(g->vertices.normal, vertex);
  for (int c = 0; c < 3; ++c) {
    world[c] = random->real(-size, size);
    normal[c] = static_cast<float>(n[c] / std::sqrt(length));
  }
  world[3] = random->real(-size, size);
  normal[3] = random->real(-size, size);
}

/// A whole batch of `scene`, a new triangle every `run` rows.
void make_batch(Random* random, Scene scene, size_t run) {
  for (size_t i = 0; i < kBatch; ++i) {
    const auto t = static_cast<uint32_t>(i / run);
    const auto x = static_cast<float>(random->whole(0, 2047)) + 0.5f;
    const auto y = static_cast<float>(random->whole(0, 2047)) + 0.5f;
    if (i % run == 0) {
      float v[3][4];
      scene(random, x, y, v);
      for (size_t k = 0; k < 3; ++k) {
        memcpy(row(g->vertices.raster, 3 * t + k), v[k], sizeof v[k]);
        set_attributes(random, 3 * t + k, 10.0);
      }
    }
    set_fragment(i, t, i % run == 0 ? x : g->fragments.x[i - 1] + 1.0f, i % run == 0 ? y : g->fragments.y[i - 1]);
  }
  finish(kBatch);
}

/// Barycentrics with their rounding bounds, in the kernel's order of operations.
struct BoundedWeights {
  Bounded b[3], dx[3], dy[3];
};
BoundedWeights bounded_weights(const float (*v)[4], float px, float py) {
  Bounded x[3], y[3], w[3], e[3], e_dx[3], e_dy[3];
  for (int k = 0; k < 3; ++k) {
    w[k] = ref::exactly(v[k][3]);
    x[k] = ref::exactly(v[k][0]) - ref::exactly(px) * w[k];
    y[k] = ref::exactly(v[k][1]) - ref::exactly(py) * w[k];
  }
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    e[k] = x[i] * y[j] - x[j] * y[i];
    e_dx[k] = w[j] * y[i] - w[i] * y[j];
    e_dy[k] = x[j] * w[i] - x[i] * w[j];
  }
  const Bounded scale = ref::inverse(e[0] + e[1] + e[2]);
  const Bounded sum_dx = e_dx[0] + e_dx[1] + e_dx[2], sum_dy = e_dy[0] + e_dy[1] + e_dy[2];
  BoundedWeights result;
  for (int k = 0; k < 3; ++k) {
    result.b[k] = e[k] * scale;
    result.dx[k] = (e_dx[k] - result.b[k] * sum_dx) * scale;
    result.dy[k] = (e_dy[k] - result.b[k] * sum_dy) * scale;
  }
  return result;
}

void check_within(const char* what, size_t i, double got, double want, double bound) {
  if (std::isfinite(bound)) {
    shd_assert_close(what, i, got, want, bound, 0.0);
  } else if (!std::isfinite(got)) {
    fail_msg("%s[%zu]: %g is not finite", what, i, got);
  }
}

double g_worst;  // largest error of a barycentric coordinate

/// Compares row i with the oracle.
void check_row(size_t i) {
  const raster::Fragments& f = g->fragments;
  float v[3][4];
  const float *world[3], *normal[3];
  for (size_t k = 0; k < 3; ++k) {
    memcpy(v[k], row(g->vertices.raster, f.vertex[k][i]), sizeof v[k]);
    world[k] = row(g->vertices.world, f.vertex[k][i]);
    normal[k] = row(g->vertices.normal, f.vertex[k][i]);
  }
  const bool any_zero = v[0][3] == 0.0f || v[1][3] == 0.0f || v[2][3] == 0.0f;
  const ref::Weights want =
      any_zero ? ref::homogeneous_weights(v, f.x[i], f.y[i]) : ref::perspective_weights(v, f.x[i], f.y[i]);
  const BoundedWeights bound = bounded_weights(v, f.x[i], f.y[i]);
  double b[3];
  b[1] = std::min(std::max(static_cast<double>(want.b[1]), 0.0), 1.0);
  b[2] = std::min(std::max(static_cast<double>(want.b[2]), 0.0), 1.0 - b[1]);
  b[0] = 1.0 - b[1] - b[2];
  const double error = bound.b[1].error + bound.b[2].error + 0x1p-23;
  for (int k = 0; k < 3; ++k) {
    check_within("bary", i, f.bary[k][i], b[k], k == 1 ? bound.b[1].error : error);
    g_worst = std::max(g_worst, std::fabs(double{f.bary[k][i]} - b[k]));
  }
  const auto attribute = [&](const float* const* values, int c, const float* got, const char* what) {
    const double a1 = double{values[1][c]} - values[0][c], a2 = double{values[2][c]} - values[0][c];
    const double size = std::fabs(double{values[0][c]}) + std::fabs(a1) + std::fabs(a2);
    check_within(what, i, got[i], values[0][c] + b[1] * a1 + b[2] * a2,
                 error * (std::fabs(a1) + std::fabs(a2)) + size * 0x1p-22);
  };
  attribute(world, 0, f.px, "px");
  attribute(world, 1, f.py, "py");
  attribute(world, 2, f.pz, "pz");
  attribute(world, 3, f.u, "u");
  attribute(normal, 3, f.v, "v");
  const auto derivative = [&](const float* const* values, const Real* want_d, const Bounded* bound_d, const float* got,
                              const char* what) {
    const double a1 = double{values[1][3]} - values[0][3], a2 = double{values[2][3]} - values[0][3];
    const double t1 = static_cast<double>(want_d[1]) * a1, t2 = static_cast<double>(want_d[2]) * a2;
    check_within(what, i, got[i], t1 + t2,
                 bound_d[1].error * std::fabs(a1) + bound_d[2].error * std::fabs(a2) +
                     (std::fabs(t1) + std::fabs(t2)) * 0x1p-22 + 0x1p-140);
  };
  derivative(world, want.dx, bound.dx, f.dudx, "dudx");
  derivative(world, want.dy, bound.dy, f.dudy, "dudy");
  derivative(normal, want.dx, bound.dx, f.dvdx, "dvdx");
  derivative(normal, want.dy, bound.dy, f.dvdy, "dvdy");
}

/// Fails unless three columns are unit vectors, or zero if allowed.
void check_unit(const char* what, const float* x, const float* y, const float* z, bool may_be_zero) {
  for (size_t i = 0; i < g->fragments.count; ++i) {
    const double length = std::sqrt(double{x[i]} * x[i] + double{y[i]} * y[i] + double{z[i]} * z[i]);
    if (may_be_zero && length == 0.0) continue;
    shd_assert_close(what, i, length, 1.0, 4e-7, 0.0);
  }
}

void test_oracle(void** state) {
  const auto* c = static_cast<const scene_case*>(*state);
  Random random = {static_cast<uint64_t>(c - k_scenes) + 1};
  g_worst = 0.0;
  for (int batch = 0; batch < 12; ++batch) {
    make_batch(&random, c->scene, batch % 2 ? 5 : 37);
    for_each_target([&](const core::SimdTarget& target, bool first) {
      raster::interpolate(target, g->vertices, kEye, raster::kInterpolateAll, &g->fragments);
      if (!first) return compare_blocks(target.name);
      keep_block();
      for (size_t i = 0; i < kBatch; ++i) check_row(i);
      check_unit("n", g->fragments.nx, g->fragments.ny, g->fragments.nz, false);
      check_unit("wo", g->fragments.ox, g->fragments.oy, g->fragments.oz, false);
    });
  }
  if (c->error > 0.0 && g_worst > c->error) fail_msg("largest error of a barycentric coordinate %g", g_worst);
  print_message("  largest error of a barycentric coordinate: %.3g\n", g_worst);
}

/// Rows of one triangle, whose vertices are loaded once, and of triangles that differ only in their number, gathered
/// per lane.
void test_uniform_and_gathered(void**) {
  Random random = {31};
  for (int batch = 0; batch < 10; ++batch) {
    make_batch(&random, batch % 3 == 0 ? same_w : batch % 3 == 1 ? ordinary : behind_the_eye, kBatch);
    for_each_target([&](const core::SimdTarget& target, bool) {
      for (size_t i = 0; i < kBatch; ++i) g->fragments.triangle[i] = 0;
      raster::interpolate(target, g->vertices, kEye, raster::kInterpolateAll, &g->fragments);
      keep_block();
      for (size_t i = 0; i < kBatch; ++i) g->first.triangle[i] = g->fragments.triangle[i] = static_cast<uint32_t>(i);
      raster::interpolate(target, g->vertices, kEye, raster::kInterpolateAll, &g->fragments);
      compare_blocks(target.name);
    });
  }
}

/// Rows of a triangle with rows of another one between them have the same bits as rows of separate triangles.
void test_interrupted(void**) {
  Random random = {41};
  for (uint32_t period = 2; period <= 17; ++period) {
    make_batch(&random, some_of_same_w, 7);
    for (uint32_t i = 0; i < kBatch; ++i) {
      set_fragment(i, i % period == period / 2 ? 1 : 0, g->fragments.x[i], g->fragments.y[i]);
    }
    for_each_target([&](const core::SimdTarget& target, bool) {
      uint32_t names[kBatch];
      memcpy(names, g->fragments.triangle, sizeof names);
      for (uint32_t i = 0; i < kBatch; ++i) g->fragments.triangle[i] = i;
      raster::interpolate(target, g->vertices, kEye, raster::kInterpolateAll, &g->fragments);
      memcpy(g->fragments.triangle, names, sizeof names);
      keep_block();
      raster::interpolate(target, g->vertices, kEye, raster::kInterpolateAll, &g->fragments);
      compare_blocks(target.name);
    });
  }
}

/// A row has the same bits in a batch of any size, and rows past the last vector do not change.
void test_counts(void**) {
  Random random = {37};
  make_batch(&random, some_of_same_w, 7);
  raster::interpolate(best_target(), g->vertices, kEye, raster::kInterpolateAll, &g->fragments);
  keep_block();
  float x[kBatch], y[kBatch];
  memcpy(x, g->first.x, sizeof x);
  memcpy(y, g->first.y, sizeof y);
  for_each_target([&](const core::SimdTarget& target, bool) {
    for (size_t count = 1; count <= kBatch; ++count) {
      raster::Fragments& f = g->fragments;
      for (size_t i = 0; i < count; ++i) set_fragment(i, static_cast<uint32_t>(i / 7), x[i], y[i]);
      finish(count);
      float* const columns[] = {f.bary[0], f.bary[1], f.bary[2], f.px, f.py, f.pz,   f.nx,   f.ny,   f.nz,
                                f.ox,      f.oy,      f.oz,      f.u,  f.v,  f.dudx, f.dvdx, f.dudy, f.dvdy};
      const float* const wanted[] = {g->first.bary[0], g->first.bary[1], g->first.bary[2], g->first.px, g->first.py,
                                     g->first.pz,      g->first.nx,      g->first.ny,      g->first.nz, g->first.ox,
                                     g->first.oy,      g->first.oz,      g->first.u,       g->first.v,  g->first.dudx,
                                     g->first.dvdx,    g->first.dudy,    g->first.dvdy};
      for (float* column : columns) std::fill_n(column, kBatch, -77.0f);
      raster::interpolate(target, g->vertices, kEye, raster::kInterpolateAll, &f);
      for (size_t c = 0; c < 18; ++c) {
        if (memcmp(columns[c], wanted[c], count * sizeof(float)) != 0)
          fail_msg("%s: count %zu column %zu", target.name, count, c);
        for (size_t i = data::padded(count); i < kBatch; ++i) {
          if (columns[c][i] != -77.0f) fail_msg("%s: count %zu column %zu row %zu written", target.name, count, c, i);
        }
      }
    }
  });
}

/// A constant attribute keeps its bits, wherever the triangle is.
void test_constant(void**) {
  Random random = {43};
  for (const Scene scene : {behind_the_eye, some_of_same_w}) {
    make_batch(&random, scene, 5);
    for (size_t v = 0; v < kVertices; ++v) row(g->vertices.world, v)[3] = 0.1f;
    for_each_target([&](const core::SimdTarget& target, bool) {
      raster::interpolate(target, g->vertices, kEye, raster::kInterpolateAll, &g->fragments);
      for (size_t i = 0; i < kBatch; ++i) {
        if (g->fragments.u[i] != 0.1f || g->fragments.dudx[i] != 0.0f)
          fail_msg("%s: row %zu u %a", target.name, i, double{g->fragments.u[i]});
      }
    });
  }
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  CMUnitTest tests[48];
  size_t n = 0;
  for (const scene_case& c : k_scenes)
    tests[n++] = {c.name, test_oracle, nullptr, nullptr, const_cast<scene_case*>(&c)};
  tests[n++] = {"bits/one_triangle_or_gathered", test_uniform_and_gathered, nullptr, nullptr, nullptr};
  tests[n++] = {"bits/interrupted", test_interrupted, nullptr, nullptr, nullptr};
  tests[n++] = {"bits/counts_1..kBatch", test_counts, nullptr, nullptr, nullptr};
  tests[n++] = {"constant", test_constant, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.raster.interpolate", tests, n, set_up, tear_down);
}
