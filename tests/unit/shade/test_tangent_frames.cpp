// SPDX-License-Identifier: MIT
// Tangent frames of triangles from their texture coordinates, and the side of a triangle that faces the eye.
#include "support/check.h"

#include <algorithm>

#include "data/data.h"
#include "ref/shade_ref.h"
#include "shade/tangent_frames.h"
#include "support/random.h"

namespace shd::tests {
namespace {

using raster::kBatch;
using ref::Vector;

const core::Allocator g_allocator = {core::default_allocator()};
constexpr uint32_t kTriangles = 90;
constexpr size_t kVertices = 3 * kTriangles;
constexpr uint32_t kFirst = 7;  // first triangle of the part of a mesh

struct Fixture {
  geometry::Vertices vertices, single;  // `single` has no second uv set
  uint32_t indices[kVertices];
  raster::Fragments points;
  shade::Columns columns;
};
Fixture* g;

int set_up(void**) {
  g = new Fixture;
  for (uint32_t i = 0; i < kVertices; ++i) g->indices[i] = kVertices - 1 - i + 5;
  for (geometry::Vertices* v : {&g->vertices, &g->single}) {
    geometry::allocate_rows(g_allocator, data::padded(kVertices), 0, v);
    v->indices = g->indices;
    v->first_triangle = kFirst;
    v->first_index = 5;
  }
  g->vertices.texture1 = core::Array<float>(g_allocator, 4 * data::padded(kVertices));
  raster::allocate(g_allocator, &g->points);
  shade::allocate(g_allocator, 1, &g->columns);
  return 0;
}
int tear_down(void**) {
  delete g;
  return 0;
}

/// Sets a corner of a triangle of the mesh, with equal uv in both sets except for their sign.
void set_corner(uint32_t triangle, size_t k, const Vector& p, const float uv[2]) {
  for (geometry::Vertices* v : {&g->vertices, &g->single}) {
    const size_t row = 4 * size_t{geometry::row_of(*v, triangle, k)};
    const float world[4] = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z), uv[0]};
    memcpy(&v->world[row], world, sizeof world);
    v->normal[row + 3] = uv[1];
  }
  const size_t row = 4 * size_t{geometry::row_of(g->vertices, triangle, k)};
  g->vertices.texture1[row] = -uv[0];
  g->vertices.texture1[row + 1] = uv[1];
}

Vector position(uint32_t triangle, size_t k) {
  return ref::vector(&g->vertices.world[4 * size_t{geometry::row_of(g->vertices, triangle, k)}]);
}

/// Rows sorted by triangle, one to seven per triangle; a canary follows the last whole vector.
void make_points(Random* random, size_t count) {
  g->points.count = count;
  uint32_t triangle = kFirst;
  for (size_t i = 0; i < kBatch; ++i) {
    if (i && random->whole(0, 6) == 0 && triangle + 1 < kFirst + kTriangles) ++triangle;
    g->points.triangle[i] = triangle;
  }
  for (float* column : {g->points.tx, g->points.ty, g->points.tz, g->points.tw}) std::fill_n(column, kBatch, -77.0f);
  for (float* column : g->columns.tangent_frame) std::fill_n(column, kBatch, -77.0f);
}

Vector frame_at(int first, size_t i) {
  float* const* f = g->columns.tangent_frame;
  const float v[3] = {f[first][i], f[first + 1][i], f[first + 2][i]};
  return ref::vector(v);
}

struct FrameCase {
  const char* name;
  uint32_t uv_set;
  float orientation;
  bool sets_tangents;
};
const FrameCase k_frames[] = {
    {"frames/uv", 0, 1, true},
    {"frames/uv1", 1, 1, true},
    {"frames/mirrored_matrix", 0, -1, true},
    {"frames/uv1/mirrored_matrix", 1, -1, true},
    {"frames/alone", 0, 1, false},
};

/// dp/du and dp/dv map differences of uv to differences of points; tangents run with u, w (n x t) runs against v.
void check_frame(const FrameCase& c, size_t i, const float uv[3][2]) {
  const uint32_t t = g->points.triangle[i];
  const Vector dpdu = frame_at(0, i), dpdv = frame_at(3, i);
  const long double sign = c.uv_set ? -1 : 1;
  for (size_t k = 1; k < 3; ++k) {
    const Vector edge = position(t, k) - position(t, 0);
    const long double du = sign * (static_cast<long double>(uv[k][0]) - uv[0][0]);
    const long double dv = static_cast<long double>(uv[k][1]) - uv[0][1];
    const Vector off = du * dpdu + dv * dpdv - edge;
    const long double size = ref::length(du * dpdu) + ref::length(dv * dpdv);
    assert_true(ref::length(off) <= 3e-7L * size);
  }
  if (!c.sets_tangents) return;
  const float tangent[3] = {g->points.tx[i], g->points.ty[i], g->points.tz[i]};
  const Vector want = ref::unit(dpdu), off = ref::vector(tangent) - want;
  assert_true(ref::length(off) <= 3e-7L);
  const Vector n = static_cast<long double>(c.orientation) *
                   ref::cross(position(t, 1) - position(t, 0), position(t, 2) - position(t, 0));
  assert_true(fabsf(g->points.tw[i]) == 1.0f);
  assert_true(g->points.tw[i] * ref::dot(ref::cross(n, want), dpdv) < 0);
}

void test_frames(void** state) {
  const auto* c = static_cast<const FrameCase*>(*state);
  Random random = {121};
  static float uv[kFirst + kTriangles][3][2];
  for (uint32_t t = kFirst; t < kFirst + kTriangles; ++t) {
    double area;
    do {
      for (auto& corner : uv[t]) corner[0] = random.real(-2, 2), corner[1] = random.real(-2, 2);
      area = (uv[t][1][0] - uv[t][0][0]) * double{uv[t][2][1] - uv[t][0][1]} -
             (uv[t][2][0] - uv[t][0][0]) * double{uv[t][1][1] - uv[t][0][1]};
    } while (fabs(area) < 0.05);
    const double size = std::exp2(random.in(-20, 20));
    for (size_t k = 0; k < 3; ++k) {
      set_corner(t, k, {size * random.in(-3, 3), size * random.in(-3, 3), size * random.in(-3, 3)}, uv[t][k]);
    }
  }
  for (size_t count : {size_t{1}, size_t{63}, size_t{64}, size_t{65}, size_t{131}, kBatch}) {
    make_points(&random, count);
    shade::make_tangent_frames(g->vertices, c->orientation, c->uv_set, c->sets_tangents, &g->points, &g->columns);
    for (size_t i = 0; i < count; ++i) check_frame(*c, i, uv[g->points.triangle[i]]);
    for (size_t i = count; i < data::padded(count); ++i) {
      for (const float* column : g->columns.tangent_frame) assert_true(column[i] == column[count - 1]);
      if (c->sets_tangents) assert_true(g->points.tx[i] == g->points.tx[count - 1]);
    }
    for (size_t i = data::padded(count); i < kBatch; ++i) assert_true(g->columns.tangent_frame[0][i] == -77.0f);
    for (size_t i = 0; i < kBatch && !c->sets_tangents; ++i) assert_true(g->points.tx[i] == -77.0f);
  }
}

struct DegenerateCase {
  const char* name;
  float p[3][3], uv[3][2];
  uint32_t uv_set;
  bool has_texture1;
};
const DegenerateCase k_degenerate[] = {
    {"degenerate/one_uv", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0.5f, 0.5f}, {0.5f, 0.5f}, {0.5f, 0.5f}}, 0, true},
    {"degenerate/line_of_uv", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0}, {1, 1}, {2, 2}}, 0, true},
    {"degenerate/point", {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 0}, {1, 0}, {0, 1}}, 0, true},
    {"degenerate/no_uv1", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0}, {1, 0}, {0, 1}}, 1, false},
    {"degenerate/1e20", {{0, 0, 0}, {1e20f, 0, 0}, {0, 1e20f, 0}}, {{0, 0}, {1, 0}, {0, 1}}, 0, true},
    {"degenerate/uv_1e-30", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0}, {1e-30f, 0}, {0, 1e-30f}}, 0, true},
    {"degenerate/nan_uv", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{NAN, 0}, {1, 0}, {0, 1}}, 0, true},
    {"degenerate/infinite_uv", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0}, {INFINITY, 0}, {0, 1}}, 0, true},
};

/// Frames that uv do not determine are 0.
void test_degenerate(void** state) {
  const auto* c = static_cast<const DegenerateCase*>(*state);
  Random random = {122};
  for (size_t k = 0; k < 3; ++k) set_corner(kFirst, k, ref::vector(c->p[k]), c->uv[k]);
  make_points(&random, 1);
  shade::make_tangent_frames(c->has_texture1 ? g->vertices : g->single, 1.0f, c->uv_set, true, &g->points, &g->columns);
  for (const float* column : g->columns.tangent_frame) assert_true(column[0] == 0.0f && column[63] == 0.0f);
  assert_true(g->points.tx[0] == 0.0f && g->points.ty[0] == 0.0f && g->points.tz[0] == 0.0f);
}

/// Triangles around an eye, some corners behind it: normals turn where their back faces the eye.
void test_sides(void**) {
  Random random = {123};
  const Vector eye = {0.3L, -0.2L, 0.7L};
  for (float orientation : {1.0f, -1.0f}) {
    bool behind[kFirst + kTriangles];
    size_t backs = 0;
    for (uint32_t t = kFirst; t < kFirst + kTriangles; ++t) {
      long double facing;
      do {
        for (size_t k = 0; k < 3; ++k) {
          const float uv[2] = {0, 0};
          set_corner(t, k, {random.in(-3, 3), random.in(-3, 3), random.in(-3, 3)}, uv);
        }
        const Vector a = position(t, 0), n = ref::cross(position(t, 1) - a, position(t, 2) - a);
        facing = orientation * ref::dot(n, eye - a);
      } while (fabsl(facing) < 0.01L);
      behind[t] = facing < 0;
      backs += behind[t];
      for (size_t k = 0; k < 3; ++k) {
        // The camera looks along -z: x right, y up, w = -z of view space; 640 x 480 pixels.
        const Vector v = position(t, k) - eye;
        const long double w = 0 - v.z, x = 320 * (w + 1.5L * v.x), y = 240 * (w - 2 * v.y);
        float* raster = &g->vertices.raster[4 * size_t{geometry::row_of(g->vertices, t, k)}];
        raster[0] = static_cast<float>(x), raster[1] = static_cast<float>(y), raster[3] = static_cast<float>(w);
      }
    }
    assert_in_range(backs, kTriangles / 4, 3 * kTriangles / 4);
    make_points(&random, 301);
    for (float* column : {g->points.nx, g->points.ny, g->points.nz}) std::fill_n(column, kBatch, 0.5f);
    shade::face_normals(g->vertices, orientation, &g->points);
    for (size_t i = 0; i < 301; ++i) {
      const float want = behind[g->points.triangle[i]] ? -0.5f : 0.5f;
      assert_true(g->points.nx[i] == want && g->points.ny[i] == want && g->points.nz[i] == want);
    }
  }
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  CMUnitTest tests[32];
  size_t n = 0;
  for (const FrameCase& c : k_frames) tests[n++] = {c.name, test_frames, nullptr, nullptr, const_cast<FrameCase*>(&c)};
  for (const DegenerateCase& c : k_degenerate) {
    tests[n++] = {c.name, test_degenerate, nullptr, nullptr, const_cast<DegenerateCase*>(&c)};
  }
  tests[n++] = {"sides", test_sides, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.shade.tangent_frames", tests, n, set_up, tear_down);
}
