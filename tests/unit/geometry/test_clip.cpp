// SPDX-License-Identifier: MIT
// Clipping against a long double clipper that uses the planes in another order, and the agreement of neighbours.
#include "support/check.h"

#include <algorithm>

#include "geometry/clip.h"
#include "support/random.h"
#include "support/targets.h"

namespace shd::tests {
namespace {

using geometry::kMaxClipped;
using geometry::ScreenVertex;

const core::Allocator g_allocator = {core::default_allocator()};
constexpr size_t kRows = 64;
constexpr int32_t kGuard = 1 << 28;  // fixed point

struct Fixture {
  geometry::Mesh mesh = {};
  geometry::Vertices vertices, one;
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
  geometry::allocate(g_allocator, g->mesh, 0, &g->one);
  return 0;
}
int tear_down(void**) {
  delete g;
  return 0;
}

/// Sets (X, Y, Z, W) of vertex `index`, through the vertex stage.
void set_vertex(size_t index, const float* v) {
  geometry::Transform transform = {};
  for (int c = 0; c < 4; ++c) transform.raster[12 + c] = v[c];
  transform.right = 640.0f;
  transform.bottom = 480.0f;
  const core::SimdTarget target = best_target();
  geometry::transform_vertices(target, g->mesh, transform, {0, kRows, 0}, &g->one);
  g->vertices.screen[index] = g->one.screen[0];
  memcpy(&g->vertices.raster[4 * index], &g->one.raster[0], 4 * sizeof(float));
}

int clip(uint32_t a, uint32_t b, uint32_t c, ScreenVertex* out) {
  const uint32_t index[3] = {a, b, c};
  return geometry::clip_triangle(g->vertices, index, out);
}

struct Point {
  long double v[4];
};

/// Distance to one of the seven planes.
long double distance(int plane, const Point& p) {
  const long double guard = 1048576, w = p.v[3];
  const long double all[7] = {
      w - 0x1p-100L,     p.v[2], w - p.v[2], p.v[0] + guard * w, guard * w - p.v[0], p.v[1] + guard * w,
      guard * w - p.v[1]};
  return all[plane];
}

/// Clips a polygon by the planes from last to first. Returns the number of vertices.
int oracle_clip(Point* polygon, int count) {
  for (int plane = 6; plane >= 0 && count > 0; --plane) {
    Point next[64];
    int n = 0;
    for (int i = 0; i < count; ++i) {
      const Point &a = polygon[i], &b = polygon[(i + 1) % count];
      const long double da = distance(plane, a), db = distance(plane, b);
      if (da >= 0) next[n++] = a;
      if ((da >= 0) != (db >= 0)) {
        for (int c = 0; c < 4; ++c) next[n].v[c] = (a.v[c] * db - b.v[c] * da) / (db - da);
        ++n;
      }
    }
    count = n;
    std::copy_n(next, n, polygon);
  }
  return count;
}

/// Twice the signed area in pixels^2.
long double oracle_area(const Point* polygon, int count) {
  long double sum = 0;
  for (int i = 0; i < count; ++i) {
    const long double *a = polygon[i].v, *b = polygon[(i + 1) % count].v;
    sum += a[0] / a[3] * (b[1] / b[3]) - b[0] / b[3] * (a[1] / a[3]);
  }
  return sum;
}
long double area(const ScreenVertex* v, int count) {
  long double sum = 0;
  for (int i = 0; i < count; ++i) {
    const ScreenVertex &a = v[i], &b = v[(i + 1) % count];
    sum += static_cast<long double>(a.x) * b.y - static_cast<long double>(b.x) * a.y;
  }
  return sum / 65536;
}
long double perimeter(const ScreenVertex* v, int count) {
  long double sum = 0;
  for (int i = 0; i < count; ++i) {
    const ScreenVertex &a = v[i], &b = v[(i + 1) % count];
    sum += hypotl(static_cast<long double>(a.x) - b.x, static_cast<long double>(a.y) - b.y) / 256;
  }
  return sum;
}

/// Random vertices of some kind.
using Kind = void (*)(Random* random, float* v);

void around_near(Random* random, float* v) {
  v[3] = random->real(-2.0, 4.0);
  v[0] = random->real(-500.0, 1000.0) * v[3];
  v[1] = random->real(-500.0, 1000.0) * v[3];
  v[2] = v[3] - 0.5f;
}
void around_far(Random* random, float* v) {
  v[3] = random->real(0.5, 4.0);
  v[0] = random->real(-500.0, 1000.0) * v[3];
  v[1] = random->real(-500.0, 1000.0) * v[3];
  v[2] = random->real(0.5, 1.5) * v[3];
}
void around_guard(Random* random, float* v) {
  v[3] = random->real(0.5, 2.0);
  v[0] = random->real(-3e6, 3e6) * v[3];
  v[1] = random->real(-3e6, 3e6) * v[3];
  v[2] = 0.5f * v[3];
}
void around_the_eye(Random* random, float* v) {
  for (int c = 0; c < 4; ++c) v[c] = random->real(-1.0, 1.0);
}
void anywhere(Random* random, float* v) {
  v[0] = random->real(-4e6, 4e6), v[1] = random->real(-4e6, 4e6);
  v[2] = random->real(-2.0, 3.0), v[3] = random->real(-1.0, 2.0);
}

struct kind_case {
  const char* name;
  Kind kind;
};
const kind_case k_kinds[] = {
    {"near", around_near},       {"far", around_far},    {"guard_band", around_guard},
    {"the_eye", around_the_eye}, {"anywhere", anywhere},
};

void make_vertices(Random* random, Kind kind, int count) {
  for (int i = 0; i < count; ++i) {
    float v[4];
    kind(random, v);
    set_vertex(static_cast<size_t>(i), v);
  }
}

Point point(size_t index) {
  const float* v = &g->vertices.raster[4 * index];
  return {{v[0], v[1], v[2], v[3]}};
}

/// The area equals the area of the oracle's polygon up to snapping; all vertices are inside the planes.
void test_area(void** state) {
  const auto* c = static_cast<const kind_case*>(*state);
  Random random = {23};
  int kept = 0;
  for (int n = 0; n < 5000; ++n) {
    make_vertices(&random, c->kind, 3);
    Point polygon[64] = {point(0), point(1), point(2)};
    const int want = oracle_clip(polygon, 3);
    ScreenVertex out[kMaxClipped];
    const int count = clip(0, 1, 2, out);
    if (count != 0 && (count < 3 || count > 10)) fail_msg("triangle %d: %d vertices", n, count);
    for (int i = 0; i < count; ++i) {
      if (abs(out[i].x) > kGuard || abs(out[i].y) > kGuard || !(out[i].z >= 0.0f && out[i].z <= 1.0f)) {
        fail_msg("triangle %d vertex %d: %d %d %g is outside", n, i, out[i].x, out[i].y, out[i].z);
      }
    }
    const long double want_area = want ? oracle_area(polygon, want) : 0, got_area = count ? area(out, count) : 0;
    // Rounding to the grid moves a vertex by 1/512 pixel per axis; rounding X / W to float moves it by 2^-24 of its
    // value.
    int32_t farthest = 0;
    for (int i = 0; i < count; ++i) farthest = std::max({farthest, abs(out[i].x), abs(out[i].y)});
    const long double moved = 1.5L * (1.0L / 512 + 0x1p-24L * farthest / 256);
    const long double bound = count ? 2 * moved * perimeter(out, count) + 1e-3L : 1.0L;
    if (fabsl(got_area - want_area) > bound) {
      fail_msg("triangle %d: area %Lg, want %Lg", n, got_area, want_area);
    }
    kept += count != 0;
  }
  assert_true(kept > 500);
}

bool is_near(const ScreenVertex& v, const Point& p) {
  return fabsl(v.x - 256 * p.v[0] / p.v[3]) < 64 && fabsl(v.y - 256 * p.v[1] / p.v[3]) < 64;
}

enum Agreement { kAbsent, kSame, kDifferent };

/// Whether two polygons have the same vertex within a quarter of a pixel of a point.
Agreement agree_at(const Point& p, const ScreenVertex* a, int a_count, const ScreenVertex* b, int b_count) {
  Agreement result = kAbsent;
  for (int i = 0; i < a_count; ++i) {
    for (int j = 0; j < b_count; ++j) {
      if (!is_near(a[i], p) || !is_near(b[j], p)) continue;
      if (a[i].x == b[j].x && a[i].y == b[j].y && memcmp(&a[i].z, &b[j].z, 4) == 0) return kSame;
      result = kDifferent;
    }
  }
  return result;
}

/// Two triangles on both sides of an edge, in every rotation and both windings, cut it at equal points.
void test_neighbours(void** state) {
  const auto* c = static_cast<const kind_case*>(*state);
  Random random = {29};
  int compared = 0;
  for (int n = 0; n < 5000; ++n) {
    make_vertices(&random, c->kind, 4);
    Point edge[64] = {point(0), point(1)};
    const int ends = oracle_clip(edge, 2);
    ScreenVertex first[kMaxClipped], other[kMaxClipped];
    const int first_count = clip(0, 1, 2, first);
    const uint32_t others[6][3] = {{1, 0, 3}, {0, 3, 1}, {3, 1, 0}, {0, 1, 3}, {1, 3, 0}, {3, 0, 1}};
    for (const uint32_t* t : others) {
      const int other_count = clip(t[0], t[1], t[2], other);
      for (int i = 0; i < ends; ++i) {
        const Agreement agreement = agree_at(edge[i], first, first_count, other, other_count);
        compared += agreement == kSame;
        if (agreement == kDifferent) fail_msg("edge %d end %d of triangle %u %u %u", n, i, t[0], t[1], t[2]);
      }
    }
  }
  assert_true(compared > 1000);
}

struct whole_case {
  const char* name;
  float v[3][4];
  int count;  // -1 = at least 3
};
const whole_case k_whole[] = {
    {"inside", {{10, 10, 0, 1}, {90, 10, 1, 1}, {10, 90, 0.5f, 1}}, 3},
    {"on_every_plane", {{-1048576, -1048576, 0, 1}, {1048576, -1048576, 1, 1}, {1048576, 1048576, 0, 1}}, 3},
    {"smallest_w", {{0, 0, 0, 0x1p-100f}, {0x1p-90f, 0, 0, 0x1p-100f}, {0, 0x1p-90f, 0, 0x1p-100f}}, 3},
    {"all_planes", {{-9e6f, -8e6f, -0.4f, 1}, {9e6f, -7e6f, 1.3f, 1}, {1e5f, 9e6f, 0.5f, 0.1f}}, -1},
    {"two_behind", {{10, 10, 0.5f, 1}, {90, 10, 0.5f, -1}, {10, 90, 0.5f, -1}}, -1},
    {"one_behind", {{10, 10, 0.5f, 1}, {90, 10, 0.5f, 1}, {10, 90, 0.5f, -1}}, -1},
    {"outside/behind", {{10, 10, 0, -1}, {90, 10, 0, -1}, {10, 90, 0, -1}}, 0},
    {"outside/w_zero", {{10, 10, 0, 0}, {90, 10, 0, 0}, {10, 90, 0, 0}}, 0},
    {"outside/near", {{10, 10, -0.1f, 1}, {90, 10, -0.1f, 1}, {10, 90, -1, 1}}, 0},
    {"outside/far", {{10, 10, 1.1f, 1}, {90, 10, 1.1f, 1}, {10, 90, 2, 1}}, 0},
    {"outside/left", {{-2e6f, 10, 0.5f, 1}, {-3e6f, 10, 0.5f, 1}, {-2e6f, 90, 0.5f, 1}}, 0},
    {"outside/right", {{2e6f, 10, 0.5f, 1}, {3e6f, 10, 0.5f, 1}, {2e6f, 90, 0.5f, 1}}, 0},
    {"outside/top", {{10, -2e6f, 0.5f, 1}, {90, -3e6f, 0.5f, 1}, {10, -2e6f, 0.5f, 1}}, 0},
    {"outside/bottom", {{10, 2e6f, 0.5f, 1}, {90, 3e6f, 0.5f, 1}, {10, 2e6f, 0.5f, 1}}, 0},
    {"outside/past_a_corner", {{2e6f, 0, 0.5f, 1}, {2e6f, 9e6f, 0.5f, 1}, {1.2e6f, 9e6f, 0.5f, 1}}, 0},
};

void test_whole(void** state) {
  const auto* c = static_cast<const whole_case*>(*state);
  for (size_t k = 0; k < 3; ++k) set_vertex(k, c->v[k]);
  ScreenVertex out[kMaxClipped];
  const int count = clip(0, 1, 2, out);
  if (c->count >= 0 ? count != c->count : count < 3) fail_msg("%d vertices", count);
  if (c->count == 3) {
    for (int k = 0; k < 3; ++k)
      assert_memory_equal(&out[k], &g->vertices.screen[static_cast<size_t>(k)], sizeof out[k]);
  }
}

/// Needles and points with edges along the planes, where rounding decides the side of a vertex.
void test_needles(void**) {
  Random random = {31};
  int maximum = 0;
  for (int n = 0; n < 20000; ++n) {
    float v[3][4];
    for (float* p : v) {
      p[3] = random.scaled(-3.0, 3.0);
      const double limit = 1048576.0 * std::fabs(double{p[3]});
      for (int c = 0; c < 2; ++c)
        p[c] = static_cast<float>(random.whole(-2, 2) * limit * (random.bits() % 3 ? 1.0 : random.in(0.99, 1.01)));
      p[2] = random.bits() % 2 ? p[3] * static_cast<float>(random.whole(0, 2)) : random.real(-1.0, 1.0);
    }
    const float t = random.real(0.0, 1.0);
    if (n % 2) {
      for (int c = 0; c < 4; ++c) v[2][c] = v[0][c] + t * (v[1][c] - v[0][c]);
    }
    for (size_t k = 0; k < 3; ++k) set_vertex(k, v[k]);
    ScreenVertex out[kMaxClipped];
    maximum = std::max(maximum, clip(0, 1, 2, out));
  }
  print_message("  most vertices: %d\n", maximum);
  assert_true(maximum <= 10);
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  static char names[2 * 5][64];
  CMUnitTest tests[40];
  size_t n = 0;
  for (const kind_case& c : k_kinds) {
    snprintf(names[n], sizeof names[n], "area/%s", c.name);
    tests[n] = {names[n], test_area, nullptr, nullptr, const_cast<kind_case*>(&c)};
    ++n;
    snprintf(names[n], sizeof names[n], "neighbours/%s", c.name);
    tests[n] = {names[n], test_neighbours, nullptr, nullptr, const_cast<kind_case*>(&c)};
    ++n;
  }
  for (const whole_case& c : k_whole) tests[n++] = {c.name, test_whole, nullptr, nullptr, const_cast<whole_case*>(&c)};
  tests[n++] = {"needles_along_planes", test_needles, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.geometry.clip", tests, n, set_up, tear_down);
}
