// SPDX-License-Identifier: MIT
// The vertex stage against arithmetic in long double: positions, normals, outcodes at their limits, snapping, invalid
// input.
#include "support/check.h"

#include <algorithm>
#include <cfloat>

#include <shd/render.h>

#include "data/data.h"
#include "geometry/vertex.h"
#include "support/random.h"
#include "support/targets.h"

namespace shd::tests {
namespace {

using geometry::Transform;

const core::Allocator g_allocator = {core::default_allocator()};
constexpr size_t kRows = 512;

struct Fixture {
  geometry::Mesh mesh = {};
  geometry::Vertices vertices, first;
};
Fixture* g;

int set_up(void**) {
  g = new Fixture;
  g->mesh.vertex_count = kRows;
  geometry::Mesh& m = g->mesh;
  for (core::Array<float>* column : {&m.px, &m.py, &m.pz, &m.nx, &m.ny, &m.nz, &m.u, &m.v}) {
    *column = core::Array<float>(g_allocator, kRows);
    column->fill_zero();
  }
  geometry::allocate(g_allocator, g->mesh, 0, &g->vertices);
  geometry::allocate(g_allocator, g->mesh, 0, &g->first);
  return 0;
}
int tear_down(void**) {
  delete g;
  return 0;
}

/// Transforms every row on every target; the bits must agree.
void transform_everywhere(const Transform& transform) {
  for_each_target([&](const core::SimdTarget& target, bool first) {
    geometry::Vertices& out = first ? g->first : g->vertices;
    for (size_t begin = 0; begin < kRows; begin += 3 * data::kRowPad) {
      geometry::transform_vertices(target, g->mesh, transform,
                                   {begin, std::min(kRows, begin + 3 * data::kRowPad), begin}, &out);
    }
    if (first) return;
    if (memcmp(out.screen.data(), g->first.screen.data(), kRows * sizeof out.screen[0]) != 0 ||
        memcmp(out.raster.data(), g->first.raster.data(), 4 * kRows * sizeof(float)) != 0 ||
        memcmp(out.world.data(), g->first.world.data(), 4 * kRows * sizeof(float)) != 0 ||
        memcmp(out.normal.data(), g->first.normal.data(), 4 * kRows * sizeof(float)) != 0) {
      fail_msg("%s: other bits", target.name);
    }
  });
}

/// An affine matrix of random columns with entries up to `size`.
void random_affine(Random* random, double size, float* m) {
  for (int i = 0; i < 16; ++i) m[i] = i % 4 == 3 ? (i == 15 ? 1.0f : 0.0f) : random->real(-size, size);
}

shd_view random_view(Random* random) {
  shd_view view = {};
  random_affine(random, 2.0, view.world_to_view);
  for (float& c : view.view_to_clip) c = random->real(-2.0, 2.0);
  return view;
}

/// Component `row` of m p with p = (x, y, z, 1), and the sum of the magnitudes of its terms.
long double product(const long double* m, int row, const float* p, long double* size) {
  long double sum = m[12 + row];
  *size = fabsl(sum);
  for (int c = 0; c < 3; ++c) {
    sum += m[4 * c + row] * static_cast<long double>(p[c]);
    *size += fabsl(m[4 * c + row] * static_cast<long double>(p[c]));
  }
  return sum;
}

void multiply(const long double* a, const long double* b, long double* out) {
  for (int c = 0; c < 4; ++c) {
    for (int r = 0; r < 4; ++r) {
      out[4 * c + r] = 0;
      for (int k = 0; k < 4; ++k) out[4 * c + r] += a[4 * k + r] * b[4 * c + k];
    }
  }
}

/// The matrix to (X, Y, Z, W), computed from its factors.
void raster_matrix(const shd_view& view, const float* world, uint32_t width, uint32_t height, long double* out) {
  long double to_world[16], to_view[16], to_clip[16], half[16], clip[16];
  for (int i = 0; i < 16; ++i) {
    to_world[i] = world[i];
    to_view[i] = view.world_to_view[i];
    to_clip[i] = view.view_to_clip[i];
  }
  multiply(to_view, to_world, half);
  multiply(to_clip, half, clip);
  const long double viewport[16] = {0.5L * width,  0, 0, 0, 0, -0.5L * height, 0, 0, 0, 0, 1, 0, 0.5L * width,
                                    0.5L * height, 0, 1};
  multiply(viewport, clip, out);
}

void random_vertices(Random* random, double size) {
  for (size_t i = 0; i < kRows; ++i) {
    geometry::Mesh& m = g->mesh;
    for (core::Array<float>* column : {&m.px, &m.py, &m.pz}) (*column)[i] = random->real(-size, size);
    float n[3];
    for (float& c : n) c = random->real(-1.0, 1.0);
    const float length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    m.nx[i] = n[0] / length, m.ny[i] = n[1] / length, m.nz[i] = n[2] / length;
    m.u[i] = random->real(-5.0, 5.0);
    m.v[i] = random->real(-5.0, 5.0);
  }
}

void check_positions(const long double* to_raster, const float* world) {
  long double to_world[16], size;
  for (int i = 0; i < 16; ++i) to_world[i] = world[i];
  for (size_t i = 0; i < kRows; ++i) {
    const float p[3] = {g->mesh.px[i], g->mesh.py[i], g->mesh.pz[i]};
    for (int r = 0; r < 4; ++r) {
      const long double want = product(to_raster, r, p, &size);
      // One rounding of the matrix, four of the sum of products.
      shd_assert_close("raster", i, g->first.raster[4 * i + r], want, 5 * 0x1p-24 * size, 0.0);
    }
    for (int r = 0; r < 3; ++r) {
      const long double want = product(to_world, r, p, &size);
      shd_assert_close("world", i, g->first.world[4 * i + r], want, 4 * 0x1p-24 * size, 0.0);
    }
    assert_true(g->first.world[4 * i + 3] == g->mesh.u[i]);
    assert_true(g->first.normal[4 * i + 3] == g->mesh.v[i]);
  }
}

/// For usable vertices, x and y are the nearest fixed-point numbers to X / W and Y / W, and depth is Z / W rounded.
void check_screen(size_t* usable) {
  for (size_t i = 0; i < kRows; ++i) {
    const geometry::ScreenVertex& s = g->first.screen[i];
    if (s.outcode & (geometry::kMustClip | geometry::kOutNonfinite)) continue;
    ++*usable;
    const float* r = &g->first.raster[4 * i];
    const long double x = 256.0L * r[0] / r[3], y = 256.0L * r[1] / r[3];
    shd_assert_close("x", i, s.x, x, 0.5 + 0x1p-24 * fabsl(x), 0.0);
    shd_assert_close("y", i, s.y, y, 0.5 + 0x1p-24 * fabsl(y), 0.0);
    shd_assert_close("z", i, s.z, static_cast<double>(static_cast<long double>(r[2]) / r[3]), 1e-45, 0x1p-24);
  }
}

void test_positions(void**) {
  Random random = {3};
  size_t usable = 0;
  for (int n = 0; n < 300; ++n) {
    shd_view view = random_view(&random);
    if (n % 2) view.view_to_clip[15] += 30.0f;  // most vertices are in front
    float world[16];
    random_affine(&random, 2.0, world);
    random_vertices(&random, 3.0);
    const uint32_t width = static_cast<uint32_t>(random.whole(1, 65536)),
                   height = static_cast<uint32_t>(random.whole(1, 4096));
    const Transform transform =
        geometry::make_transform(view, world, {0, 0, width, height}, geometry::viewport_box(width, height));
    long double to_raster[16];
    raster_matrix(view, world, width, height, to_raster);
    transform_everywhere(transform);
    check_positions(to_raster, world);
    check_screen(&usable);
  }
  assert_true(usable > 10000);
}

/// A transform that maps vertex p to raster coordinates p, with W = 1.
Transform plain_transform(float width, float height) {
  Transform t = {};
  t.raster[0] = t.raster[5] = t.raster[10] = t.raster[15] = 1.0f;
  for (int i = 0; i < 16; i += 5) t.world[i] = 1.0f;
  for (int i = 0; i < 9; i += 4) t.normal[i] = 1.0f;
  t.orientation = 1.0f;
  t.right = width;
  t.bottom = height;
  return t;
}

struct outcode_case {
  const char* name;
  float x, y, z, w;
  uint32_t outcode;
};
constexpr uint32_t kBehindAll = geometry::kOutBehind | geometry::kOutGuard;
const outcode_case k_outcodes[] = {
    {"outcode/inside", 10, 20, 0.5f, 1, 0},
    {"outcode/on_left", 0, 20, 0.5f, 1, 0},
    {"outcode/minus_zero", -0.0f, -0.0f, -0.0f, 1, 0},
    {"outcode/left", -1.4e-45f, 20, 0.5f, 1, geometry::kOutLeft},
    {"outcode/on_right", 640, 20, 0.5f, 1, 0},
    {"outcode/right", 640.0001f, 20, 0.5f, 1, geometry::kOutRight},
    {"outcode/on_top", 10, 0, 0.5f, 1, 0},
    {"outcode/top", 10, -1.4e-45f, 0.5f, 1, geometry::kOutTop},
    {"outcode/on_bottom", 10, 480, 0.5f, 1, 0},
    {"outcode/bottom", 10, 480.0001f, 0.5f, 1, geometry::kOutBottom},
    {"outcode/on_near", 10, 20, 0, 1, 0},
    {"outcode/near", 10, 20, -1.4e-45f, 1, geometry::kOutNear},
    {"outcode/on_far", 10, 20, 1, 1, 0},
    {"outcode/far", 10, 20, 1.0000001f, 1, geometry::kOutFar},
    {"outcode/smallest_w", 0, 0, 0, 0x1p-100f, 0},
    {"outcode/below_smallest_w", 0, 0, 0, 0x1.fffffep-101f, geometry::kOutBehind},
    {"outcode/w_zero", 1, 1, 0, 0, geometry::kOutRight | geometry::kOutBottom | kBehindAll},
    {"outcode/all_zero", 0, 0, 0, 0, geometry::kOutBehind},
    {"outcode/behind_the_eye", 0, 0, 0, -1,
     geometry::kOutRight | geometry::kOutBottom | geometry::kOutFar | kBehindAll},
    {"outcode/on_guard", 1048576, 20, 0.5f, 1, geometry::kOutRight},
    {"outcode/guard", 1048576.125f, 20, 0.5f, 1, geometry::kOutRight | geometry::kOutGuard},
    {"outcode/on_guard_left", -1048576, 20, 0.5f, 1, geometry::kOutLeft},
    {"outcode/guard_top", 10, -1048576.125f, 0.5f, 1, geometry::kOutTop | geometry::kOutGuard},
    {"outcode/large_w", 1e38f, 1e38f, 1e38f, 1e38f, 0},
    {"outcode/largest", FLT_MAX, FLT_MAX, FLT_MAX, FLT_MAX, 0},
    {"outcode/nan_x", NAN, 20, 0.5f, 1, geometry::kOutNonfinite},
    {"outcode/nan_y", 10, NAN, 0.5f, 1, geometry::kOutNonfinite},
    {"outcode/nan_z", 10, 20, NAN, 1, geometry::kOutNonfinite},
    {"outcode/nan_w", 10, 20, 0.5f, NAN, geometry::kOutNonfinite},
    {"outcode/infinite_x", INFINITY, 20, 0.5f, 1, geometry::kOutNonfinite},
    {"outcode/infinite_y", 10, -INFINITY, 0.5f, 1, geometry::kOutNonfinite},
    {"outcode/infinite_z", 10, 20, INFINITY, 1, geometry::kOutNonfinite},
    {"outcode/infinite_w", 10, 20, 0.5f, INFINITY, geometry::kOutNonfinite},
};

/// (X, Y, Z) comes from the vertex, W from the matrix; the neighbours stay inside and must not be affected.
void test_outcode(void** state) {
  const auto* c = static_cast<const outcode_case*>(*state);
  Transform transform = plain_transform(640, 480);
  transform.raster[15] = c->w;
  for (size_t i = 0; i < kRows; ++i) {
    const bool here = i % 5 == 3;
    g->mesh.px[i] = here ? c->x : 0.0f;
    g->mesh.py[i] = here ? c->y : 0.0f;
    g->mesh.pz[i] = here ? c->z : 0.0f;
  }
  const bool finite = !(c->outcode & geometry::kOutNonfinite);
  transform_everywhere(transform);
  for (size_t i = 3; i < kRows; i += 5) {
    const geometry::ScreenVertex& s = g->first.screen[i];
    const uint32_t got = finite ? s.outcode : s.outcode & geometry::kOutNonfinite;
    if (got != c->outcode) fail_msg("row %zu: outcode %u, want %u", i, s.outcode, c->outcode);
    assert_true(std::isfinite(s.z));
    if (std::isfinite(c->w) && c->w > 0x1p-100f && c->w <= 1.0f && g->first.screen[i + 1].outcode != 0) {
      fail_msg("row %zu: the neighbour's outcode is %u", i, g->first.screen[i + 1].outcode);
    }
  }
}

struct nonfinite_case {
  const char* name;
  float position[3];
  float scale;  // scale of the draw's matrix
  bool nonfinite;
};
const nonfinite_case k_nonfinite[] = {
    {"bad/nan", {NAN, 0, 0}, 1, true},
    {"bad/infinity", {0, INFINITY, 0}, 1, true},
    {"bad/minus_infinity", {0, 0, -INFINITY}, 1, true},
    {"bad/infinity_times_zero", {INFINITY, 0, 0}, 0, true},
    {"bad/overflow_in_world", {FLT_MAX, 0, 0}, 2, true},
    {"bad/overflow_in_raster", {FLT_MAX, 0, 0}, 1, true},
    {"bad/matrix_overflow", {1, 0, 0}, 3e38f, true},
    {"good/1e30", {1e30f, 1e30f, 1e30f}, 1, false},
    {"good/denormal", {1e-45f, -1e-45f, 1e-45f}, 1, false},
};

void test_nonfinite(void** state) {
  const auto* c = static_cast<const nonfinite_case*>(*state);
  shd_view view = shd_render_desc_default().view;
  float world[16] = {};
  world[0] = world[5] = world[10] = c->scale;
  world[15] = 1.0f;
  Random random = {1};
  random_vertices(&random, 1.0);
  g->mesh.px[7] = c->position[0], g->mesh.py[7] = c->position[1], g->mesh.pz[7] = c->position[2];
  transform_everywhere(geometry::make_transform(view, world, {0, 0, 640, 480}, geometry::viewport_box(640, 480)));
  if ((g->first.screen[7].outcode & geometry::kOutNonfinite ? 1 : 0) != c->nonfinite) {
    fail_msg("outcode %u", g->first.screen[7].outcode);
  }
}

struct matrix_case {
  const char* name;
  float m[9];  // columns
};
const matrix_case k_matrices[] = {
    {"normal/identity", {1, 0, 0, 0, 1, 0, 0, 0, 1}},
    {"normal/uniform_scale", {7, 0, 0, 0, 7, 0, 0, 0, 7}},
    {"normal/uneven_scale", {2, 0, 0, 0, 3, 0, 0, 0, 50}},
    {"normal/shear", {1, 0, 0, 3, 1, 0, -2, 5, 1}},
    {"normal/mirror_x", {-1, 0, 0, 0, 1, 0, 0, 0, 1}},
    {"normal/mirror_all", {-1, 0, 0, 0, -2, 0, 0, 0, -3}},
    {"normal/rotation", {0.6f, 0.8f, 0, -0.8f, 0.6f, 0, 0, 0, 1}},
    {"normal/general", {1, 2, 3, -4, 5, 6, 7, 8, -9}},
    {"normal/scale_1e15", {1e15f, 0, 0, 0, 2e15f, 0, 0, 0, 1e15f}},
    {"normal/scale_1e-15", {1e-15f, 0, 0, 0, 2e-15f, 0, 0, 0, 1e-15f}},
    {"normal/scale_3e38", {3e38f, 0, 0, 0, 1e38f, 0, 0, 0, 3e38f}},
    {"normal/scale_1e-44", {1e-44f, 0, 0, 0, 2e-44f, 0, 0, 0, 1e-44f}},
};

/// Compares with the inverse transpose, up to length.
void test_normal(void** state) {
  const auto* c = static_cast<const matrix_case*>(*state);
  float world[16] = {};
  for (int i = 0; i < 9; ++i) world[i / 3 * 4 + i % 3] = c->m[i];
  world[15] = 1.0f;
  Random random = {5};
  random_vertices(&random, 1.0);
  const Transform transform =
      geometry::make_transform(shd_render_desc_default().view, world, {0, 0, 64, 64}, geometry::viewport_box(64, 64));
  transform_everywhere(transform);

  const float* m = c->m;
  const auto at = [&](int r, int k) { return static_cast<long double>(m[3 * (k % 3) + r % 3]); };
  long double inverse[3][3], det = 0;  // inverse[r][k]
  for (int r = 0; r < 3; ++r) {
    det += at(r, 0) * (at(r + 1, 1) * at(r + 2, 2) - at(r + 2, 1) * at(r + 1, 2));
  }
  for (int r = 0; r < 3; ++r) {
    for (int k = 0; k < 3; ++k) {
      inverse[r][k] = (at(k + 1, r + 1) * at(k + 2, r + 2) - at(k + 1, r + 2) * at(k + 2, r + 1)) / det;
    }
  }
  assert_true(transform.orientation == (det < 0 ? -1.0f : 1.0f));
  for (size_t i = 0; i < kRows; ++i) {
    const long double n[3] = {g->mesh.nx[i], g->mesh.ny[i], g->mesh.nz[i]};
    long double want[3], length = 0, largest = 0;
    for (int r = 0; r < 3; ++r) {
      want[r] = inverse[0][r] * n[0] + inverse[1][r] * n[1] + inverse[2][r] * n[2];
      length += want[r] * want[r];
      for (int k = 0; k < 3; ++k) largest = std::max(largest, fabsl(inverse[r][k]));
    }
    length = sqrtl(length);
    // A normal that the matrix nearly flattens loses precision by the ratio of the matrix's largest entry to its
    // length.
    const auto bound = static_cast<double>(6 * 0x1p-24L * (1 + largest / length));
    for (int r = 0; r < 3; ++r) {
      shd_assert_close("normal", i, g->first.normal[4 * i + r], static_cast<double>(want[r] / length), bound, 0.0);
    }
  }
}

struct singular_case {
  const char* name;
  float m[9];
  float n[3], want[3];
};
const singular_case k_singular[] = {
    {"singular/flat_along_normal", {1, 0, 0, 0, 1, 0, 0, 0, 0}, {0, 0, 1}, {0, 0, 1}},
    {"singular/flat_across_normal", {1, 0, 0, 0, 1, 0, 0, 0, 0}, {1, 0, 0}, {0, 0, 0}},
    {"singular/oblique", {1, 0, 0, 0, 1, 0, 0, 0, 0}, {0.6f, 0, 0.8f}, {0, 0, 1}},
    {"singular/line", {1, 0, 0, 0, 0, 0, 0, 0, 0}, {0, 0, 1}, {0, 0, 0}},
    {"singular/zero", {0, 0, 0, 0, 0, 0, 0, 0, 0}, {0, 0, 1}, {0, 0, 0}},
    {"singular/zero_normal", {1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0}, {0, 0, 0}},
};

void test_singular(void** state) {
  const auto* c = static_cast<const singular_case*>(*state);
  float world[16] = {};
  for (int i = 0; i < 9; ++i) world[i / 3 * 4 + i % 3] = c->m[i];
  world[15] = 1.0f;
  for (size_t i = 0; i < kRows; ++i) g->mesh.nx[i] = c->n[0], g->mesh.ny[i] = c->n[1], g->mesh.nz[i] = c->n[2];
  transform_everywhere(
      geometry::make_transform(shd_render_desc_default().view, world, {0, 0, 64, 64}, geometry::viewport_box(64, 64)));
  for (size_t i = 0; i < kRows; ++i) {
    for (int r = 0; r < 3; ++r) shd_assert_close("normal", i, g->first.normal[4 * i + r], c->want[r], 2e-7, 0.0);
  }
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  CMUnitTest tests[80];
  size_t n = 0;
  tests[n++] = {"positions", test_positions, nullptr, nullptr, nullptr};
  for (const outcode_case& c : k_outcodes) {
    tests[n++] = {c.name, test_outcode, nullptr, nullptr, const_cast<outcode_case*>(&c)};
  }
  for (const nonfinite_case& c : k_nonfinite) {
    tests[n++] = {c.name, test_nonfinite, nullptr, nullptr, const_cast<nonfinite_case*>(&c)};
  }
  for (const matrix_case& c : k_matrices) {
    tests[n++] = {c.name, test_normal, nullptr, nullptr, const_cast<matrix_case*>(&c)};
  }
  for (const singular_case& c : k_singular) {
    tests[n++] = {c.name, test_singular, nullptr, nullptr, const_cast<singular_case*>(&c)};
  }
  return _cmocka_run_group_tests("unit.geometry.vertex", tests, n, set_up, tear_down);
}
