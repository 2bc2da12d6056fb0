// SPDX-License-Identifier: MIT
// Lines and points against ideal rectangles: coverage, depth, clipping, shared edges, and counts.
#include "support/check.h"

#include <algorithm>

#include "geometry/assemble.h"
#include "ref/outline_ref.h"
#include "ref/raster_ref.h"
#include "support/random.h"
#include "support/targets.h"

namespace shd::tests {
namespace {

using geometry::ScreenTriangle;

const core::Allocator g_allocator = {core::default_allocator()};
constexpr size_t kRows = 64;
constexpr uint32_t kMaxTriangles = 512;
constexpr int32_t kSize = 96;  // edge length of the picture
constexpr double kSubpixel = 1.0 / 256;

struct Fixture {
  geometry::Mesh mesh = {};
  geometry::Vertices vertices, one;
  core::Buffer<ScreenTriangle> out;
};
Fixture* g;

int set_up(void**) {
  g = new Fixture;
  geometry::Mesh& m = g->mesh;
  m.vertex_count = kRows;
  for (core::Array<float>* column : {&m.px, &m.py, &m.pz, &m.nx, &m.ny, &m.nz, &m.u, &m.v}) {
    *column = core::Array<float>(g_allocator, kRows);
    column->fill_zero();
  }
  m.indices = core::Array<uint32_t>(g_allocator, 3 * size_t{kMaxTriangles});
  geometry::allocate(g_allocator, m, 0, &g->vertices);
  geometry::allocate(g_allocator, m, 0, &g->one);
  g->out.attach(g_allocator);
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
  transform.right = transform.bottom = static_cast<float>(kSize);
  geometry::transform_vertices(best_target(), g->mesh, transform, {0, kRows, 0}, &g->one);
  g->vertices.screen[index] = g->one.screen[0];
  memcpy(&g->vertices.raster[4 * index], &g->one.raster[0], 4 * sizeof(float));
}

constexpr geometry::SampleExtent kAnywhere = {0, 255, 0, 255};

shd_render_stats assemble(shd_fill fill, float width, shd_cull cull, size_t count) {
  shd_render_stats stats = shd_render_stats_default();
  geometry::Assembly assembly = {&g->vertices, 5, cull, geometry::viewport_box(kSize, kSize), kAnywhere, {}};
  assembly.outline = {fill, geometry::outline_reach(width)};
  g->out.clear();
  geometry::assemble(assembly, 0, count, &g->out, &stats);
  assert_int_equal(stats.triangle_count, count);
  assert_int_equal(stats.nonfinite_triangle_count + stats.outside_triangle_count + stats.culled_triangle_count +
                       stats.empty_triangle_count + stats.rasterized_triangle_count,
                   count);
  return stats;
}

void set_triangle(size_t which, uint32_t a, uint32_t b, uint32_t c) {
  uint32_t* index = &g->mesh.indices[3 * which];
  index[0] = a;
  index[1] = b;
  index[2] = c;
}

/// Draws the line between two vertices, as a triangle without other edges.
shd_render_stats draw_line(const float* a, const float* b, float width) {
  set_vertex(0, a);
  set_vertex(1, b);
  set_triangle(0, 0, 1, 1);
  return assemble(SHD_FILL_WIREFRAME, width, SHD_CULL_NONE, 1);
}

/// The piece at a sample in 1/256 pixel, or null. There must not be more than one.
const ScreenTriangle* piece_at(int32_t x, int32_t y) {
  const ScreenTriangle* found = nullptr;
  for (size_t i = 0; i < g->out.size(); ++i) {
    if (!ref::covers(g->out[i], x >> 8, y >> 8, x & 255, y & 255)) continue;
    if (found) fail_msg("sample %d %d is hit twice", x, y);
    found = &g->out[i];
  }
  return found;
}

/// Tests samples near the line and in the whole picture against the rectangle. `slack` bounds the error of its border.
void check_line(const ref::Segment& s, double width, double slack, Random* random) {
  const double dx = s.x[1] - s.x[0], dy = s.y[1] - s.y[0], length = std::hypot(dx, dy);
  for (int i = 0; i < 400; ++i) {
    double x = random->in(0, kSize), y = random->in(0, kSize);
    if (i % 4) {
      const double t = random->in(-0.1, 1.1), across = random->in(-0.6, 0.6) * width / length;
      x = s.x[0] + t * dx - across * dy;
      y = s.y[0] + t * dy + across * dx;
      if (!(x >= 0 && y >= 0 && x < kSize && y < kSize)) continue;
    }
    const auto sx = static_cast<int32_t>(x * 256), sy = static_cast<int32_t>(y * 256);
    const ref::LinePlace place = ref::place_at(s, width, sx / 256.0, sy / 256.0);
    const ScreenTriangle* piece = piece_at(sx, sy);
    if ((place.inside > slack && !piece) || (place.inside < -slack && piece)) {
      fail_msg("(%.9g %.9g)-(%.9g %.9g) width %g: sample %d/256 %d/256 is %s, but %g inside", s.x[0], s.y[0], s.x[1],
               s.y[1], width, sx, sy, piece ? "covered" : "not covered", place.inside);
    }
    if (!piece) continue;
    const double z = s.z[0] + (s.z[1] - s.z[0]) * std::clamp(place.along, 0.0, 1.0);
    const ref::Depth depth = ref::depth_at(*piece, sx >> 8, sy >> 8, sx & 255, sy & 255);
    const double slope = std::fabs(s.z[1] - s.z[0]) / length;
    shd_assert_close("depth", 0, depth.value, z, 1e-6 + 2 * slack * slope, 0.0);
  }
}

struct line_case {
  const char* name;
  double length;  // pixels
  double reach;   // distance of its first end from the picture
};
const line_case k_lines[] = {
    {"line/part_of_a_pixel", 0.3, 0}, {"line/a_pixel", 1, 0},          {"line/short", 10, 0},
    {"line/across", 150, 40},         {"line/off_screen", 5000, 2500}, {"line/far", 9e5, 1e5},
};
constexpr float kWidths[] = {0.0625f, 0.5f, 1.0f, 1.7f, 8.0f, 64.0f};

/// Lines of every width in 32 or more directions.
void test_line(void** state) {
  const auto* c = static_cast<const line_case*>(*state);
  Random random = {static_cast<uint64_t>(c - k_lines) + 1};
  for (int i = 0; i < 480; ++i) {
    const float width = kWidths[i % 6];
    const double angle = i < 192 ? i / 6 * (M_PI / 16) : random.in(0, 2 * M_PI);
    const double x = random.in(-c->reach, kSize + c->reach), y = random.in(-c->reach, kSize + c->reach);
    // Some axis-parallel lines lie on pixel corners and centres.
    const double snap = i % 3 ? 0 : 0.5;
    const auto at = [&](double v) { return static_cast<float>(snap > 0 ? std::floor(v / snap) * snap : v); };
    const float a[4] = {at(x), at(y), random.real(0, 1), 1};
    const float b[4] = {at(x + c->length * std::cos(angle)), at(y + c->length * std::sin(angle)), random.real(0, 1), 1};
    const shd_render_stats stats = draw_line(a, b, width);
    assert_int_equal(stats.clipped_triangle_count, 0);
    const geometry::ScreenVertex &p = g->vertices.screen[0], &q = g->vertices.screen[1];
    if (p.x == q.x && p.y == q.y) {
      assert_int_equal(stats.culled_triangle_count, 1);
      assert_int_equal(g->out.size(), 0);
      continue;
    }
    const ref::Segment snapped = {true,
                                  {p.x * kSubpixel, q.x * kSubpixel},
                                  {p.y * kSubpixel, q.y * kSubpixel},
                                  {static_cast<double>(p.z), static_cast<double>(q.z)}};
    check_line(snapped, static_cast<double>(width), kSubpixel, &random);
  }
}

/// Ends behind the eye, before and beyond the planes and the guard band.
void test_clipped_line(void**) {
  Random random = {40};
  int seen = 0, gone = 0;
  for (int i = 0; i < 4000; ++i) {
    float v[2][4];
    for (float* p : {v[0], v[1]}) {
      const double w = random.in(-1, 3), wide = i % 4 == 0 ? 1e9 : i % 4 == 1 ? 1e5 : kSize;
      p[0] = random.real(-wide, 2 * wide);
      p[1] = random.real(-wide, 2 * wide);
      p[2] = random.real(-0.5, 1.5) * static_cast<float>(w);
      p[3] = static_cast<float>(i % 8 == 0 ? std::fabs(w) * 1e-6 : w);
    }
    const float width = kWidths[i % 6];
    const ref::Segment s = ref::clip_segment(v[0], v[1]);
    const shd_render_stats stats = draw_line(v[0], v[1], width);
    if (!s.any) {
      assert_int_equal(stats.rasterized_triangle_count, 0);
      ++gone;
      continue;
    }
    const double length = std::hypot(s.x[1] - s.x[0], s.y[1] - s.y[0]);
    if (length < 0.5) continue;
    // Snapping the ends to the pixel grid, and the single precision of distant vertices, rotate and shift the line.
    const double far = std::max({std::fabs(s.x[0]), std::fabs(s.x[1]), std::fabs(s.y[0]), std::fabs(s.y[1])});
    const double turn = 1.0 + static_cast<double>(width) / length;
    check_line(s, static_cast<double>(width), (kSubpixel + far * 0x1p-22) * turn, &random);
    seen += stats.rasterized_triangle_count != 0;
  }
  assert_true(seen > 500 && gone > 500);
}

struct edge_case {
  const char* name;
  float a[4], b[4];
  uint64_t outside, culled, rasterised;
};
const edge_case k_edges[] = {
    {"one/plain", {10, 10, 0, 1}, {20, 30, 0, 1}, 0, 0, 1},
    {"one/no_length", {10, 10, 0, 1}, {10, 10, 0, 1}, 0, 1, 0},
    {"one/no_length_on_the_grid", {10, 10, 0, 1}, {10.001f, 10, 0, 1}, 0, 1, 0},
    {"one/straight_into_the_picture", {10, 10, 0, 1}, {10, 10, 1, 1}, 0, 1, 0},
    {"one/behind_the_eye", {10, 10, 0, -1}, {20, 30, 0, -2}, 1, 0, 0},
    {"one/w_zero", {10, 10, 0, 0}, {20, 30, 0, 0}, 1, 0, 0},
    {"one/through_the_eye", {10, 10, 0.5f, 1}, {30, 30, 0.5f, -1}, 0, 0, 1},
    {"one/before_the_near_plane", {10, 10, -0.1f, 1}, {20, 30, -0.1f, 1}, 1, 0, 0},
    {"one/beyond_the_far_plane", {10, 10, 1.1f, 1}, {20, 30, 1.1f, 1}, 1, 0, 0},
    {"one/through_both_planes", {10, 10, -1, 1}, {20, 30, 2, 1}, 0, 0, 1},
    {"one/beside_the_picture", {-30, 10, 0, 1}, {-20, 90, 0, 1}, 1, 0, 0},
    {"one/reaching_in", {-3, 10, 0, 1}, {-3, 90, 0, 1}, 0, 0, 1},
    {"one/guard_band", {-2e6f, 50, 0, 1}, {3e6f, 50, 0, 1}, 0, 0, 1},
    {"one/beyond_the_guard_band", {2e6f, 50, 0, 1}, {3e6f, 50, 0, 1}, 1, 0, 0},
};

/// Lines of width 8.
void test_edge(void** state) {
  const auto* c = static_cast<const edge_case*>(*state);
  const shd_render_stats stats = draw_line(c->a, c->b, 8.0f);
  assert_int_equal(stats.outside_triangle_count, c->outside);
  assert_int_equal(stats.culled_triangle_count, c->culled);
  assert_int_equal(stats.rasterized_triangle_count, c->rasterised);
  assert_int_equal(g->out.size(), 2 * c->rasterised);
}

/// The square of a point, at every subpixel position; vertices beyond the planes have none.
void test_points(void**) {
  Random random = {50};
  for (int i = 0; i < 2000; ++i) {
    const float width = kWidths[i % 6];
    const float v[4] = {random.real(-40, kSize + 40), random.real(-40, kSize + 40), random.real(-0.2, 1.2), 1};
    set_vertex(0, v);
    set_triangle(0, 0, 0, 0);
    assemble(SHD_FILL_POINTS, width, SHD_CULL_NONE, 1);
    const geometry::ScreenVertex& p = g->vertices.screen[0];
    const int32_t reach = geometry::outline_reach(width);
    const bool is_there = v[2] >= 0 && v[2] <= 1;
    for (int k = 0; k < 60; ++k) {
      const int32_t x = k % 2 ? p.x + random.whole(-reach - 2, reach + 2) : random.whole(0, kSize * 256 - 1);
      const int32_t y = k % 2 ? p.y + random.whole(-reach - 2, reach + 2) : random.whole(0, kSize * 256 - 1);
      if (x < 0 || y < 0 || x >= kSize * 256 || y >= kSize * 256) continue;
      const bool want = is_there && x >= p.x - reach && x < p.x + reach && y >= p.y - reach && y < p.y + reach;
      const ScreenTriangle* piece = piece_at(x, y);
      if (want != (piece != nullptr)) fail_msg("point %d %d reach %d at %d %d", p.x, p.y, reach, x, y);
      if (piece) assert_true(piece->z[0] == v[2] && piece->z[1] == v[2] && piece->z[2] == v[2]);
    }
  }
}

/// Vertices of every kind: in the picture, far outside, behind the eye, coincident, some non-finite.
void make_soup(Random* random, double wide) {
  for (size_t i = 0; i < kRows; ++i) {
    const float w = i % 5 ? 1.0f : random->real(-0.5, 2);
    const float v[4] = {i % 31 ? random->real(-wide, wide + kSize) : NAN, random->real(-wide, wide + kSize),
                        random->real(-0.2, 1.2) * w, w};
    set_vertex(i, v);
  }
  for (size_t i = 0; i < 3 * size_t{kMaxTriangles}; ++i) {
    const bool repeats = i % 3 && random->bits() % 10 == 0;
    g->mesh.indices[i] = repeats ? g->mesh.indices[i - 1] : static_cast<uint32_t>(random->whole(0, kRows - 1));
  }
}

/// Every triangle has one outcome; culling is as for solid triangles; pieces are valid for the raster stage.
void test_soup(void**) {
  Random random = {60};
  uint64_t back = 0, front = 0;
  for (int n = 0; n < 60; ++n) {
    make_soup(&random, n % 3 == 0 ? 10.0 : n % 3 == 1 ? 500.0 : 3e6);
    const shd_fill fill = n % 2 ? SHD_FILL_POINTS : SHD_FILL_WIREFRAME;
    const float width = kWidths[n % 6];
    uint64_t pieces[3];
    shd_render_stats stats[3];
    for (const shd_cull cull : {SHD_CULL_NONE, SHD_CULL_BACK, SHD_CULL_FRONT}) {
      stats[cull] = assemble(fill, width, cull, kMaxTriangles);
      pieces[cull] = g->out.size();
      uint64_t primitives = 0;
      for (size_t i = 0; i < g->out.size(); ++i) {
        const ScreenTriangle& t = g->out[i];
        assert_true(ref::Wide{t.x[1] - t.x[0]} * (t.y[2] - t.y[0]) > ref::Wide{t.x[2] - t.x[0]} * (t.y[1] - t.y[0]));
        for (int k = 0; k < 3; ++k) {
          assert_true(abs(t.x[k]) <= (1 << 28) + 8192 && abs(t.y[k]) <= (1 << 28) + 8192);
          assert_true(t.z[k] >= 0.0f && t.z[k] <= 1.0f);
        }
        if (i > 0) assert_true(t.primitive >= g->out[i - 1].primitive);
        primitives += i == 0 || t.primitive != g->out[i - 1].primitive;
      }
      assert_int_equal(primitives, stats[cull].rasterized_triangle_count);
    }
    assert_true(pieces[1] + pieces[2] <= pieces[0]);  // triangles without area are in neither
    back += pieces[1];
    front += pieces[2];
  }
  assert_true(back > 1000 && front > 1000);
}

/// The pieces of an edge that two triangles share in opposite directions are equal.
void test_shared(void**) {
  Random random = {70};
  for (int n = 0; n < 500; ++n) {
    for (uint32_t i = 0; i < 2; ++i) {
      const float w = n % 2 ? 1.0f : random.real(-0.5, 2);
      const float v[4] = {random.real(-50, 150), random.real(-50, 150), random.real(-0.2, 1.2), w};
      set_vertex(i, v);
      set_vertex(3 - i, v);
    }
    const uint32_t ends[4][2] = {{0, 1}, {1, 0}, {3, 2}, {0, 2}};
    ScreenTriangle first[2] = {};
    size_t count = 0;
    for (int k = 0; k < 4; ++k) {
      set_triangle(0, ends[k][0], ends[k][1], ends[k][1]);
      assemble(SHD_FILL_WIREFRAME, 3.0f, SHD_CULL_NONE, 1);
      if (k == 0) {
        count = g->out.size();
        for (size_t i = 0; i < count; ++i) first[i] = g->out[i];
      }
      assert_int_equal(g->out.size(), count);
      for (size_t i = 0; i < count; ++i) assert_memory_equal(&first[i], &g->out[i], sizeof first[i]);
    }
  }
}

/// A triangle draws its three edges, or its three vertices, once each; the winding determines the mode that culls it.
void test_triangle(void**) {
  const float v[3][4] = {{10, 10, 0, 1}, {80, 15, 0.5f, 1}, {20, 70, 1, 1}};
  for (uint32_t i = 0; i < 3; ++i) set_vertex(i, v[i]);
  for (const bool clockwise : {true, false}) {
    set_triangle(0, 0, clockwise ? 1 : 2, clockwise ? 2 : 1);
    for (const shd_fill fill : {SHD_FILL_WIREFRAME, SHD_FILL_POINTS}) {
      assert_int_equal(assemble(fill, 1.0f, SHD_CULL_NONE, 1).rasterized_triangle_count, 1);
      assert_int_equal(g->out.size(), 6);
      assert_int_equal(assemble(fill, 1.0f, SHD_CULL_BACK, 1).culled_triangle_count, clockwise);
      assert_int_equal(assemble(fill, 1.0f, SHD_CULL_FRONT, 1).culled_triangle_count, !clockwise);
    }
  }
}

/// A triangle that names a vertex twice draws its point once.
void test_repeated_point(void**) {
  const float v[2][4] = {{10, 10, 0, 1}, {80, 15, 0.5f, 1}};
  for (uint32_t i = 0; i < 2; ++i) set_vertex(i, v[i]);
  const uint32_t rows[][3] = {{0, 1, 1}, {0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {1, 0, 1}};
  for (const uint32_t(&row)[3] : rows) {
    set_triangle(0, row[0], row[1], row[2]);
    assert_int_equal(assemble(SHD_FILL_POINTS, 4.0f, SHD_CULL_NONE, 1).rasterized_triangle_count, 1);
    assert_int_equal(g->out.size(), 4);  // two squares of two triangles
  }
  set_triangle(0, 1, 1, 1);
  assemble(SHD_FILL_POINTS, 4.0f, SHD_CULL_NONE, 1);
  assert_int_equal(g->out.size(), 2);
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  static CMUnitTest tests[64];
  size_t n = 0;
  for (const line_case& c : k_lines) {
    tests[n++] = {c.name, test_line, nullptr, nullptr, const_cast<line_case*>(&c)};
  }
  for (const edge_case& c : k_edges) {
    tests[n++] = {c.name, test_edge, nullptr, nullptr, const_cast<edge_case*>(&c)};
  }
  tests[n++] = {"line/clipped", test_clipped_line, nullptr, nullptr, nullptr};
  tests[n++] = {"points", test_points, nullptr, nullptr, nullptr};
  tests[n++] = {"points/repeated", test_repeated_point, nullptr, nullptr, nullptr};
  tests[n++] = {"soup", test_soup, nullptr, nullptr, nullptr};
  tests[n++] = {"shared_edge", test_shared, nullptr, nullptr, nullptr};
  tests[n++] = {"triangle", test_triangle, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.geometry.outline", tests, n, set_up, tear_down);
}
