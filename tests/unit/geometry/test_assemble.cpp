// SPDX-License-Identifier: MIT
// Assembly: every triangle has one outcome, culling depends on the winding, and the output is valid for the raster
// stage.
#include "support/check.h"

#include <algorithm>

#include "geometry/assemble.h"
#include "support/random.h"
#include "support/targets.h"

namespace shd::tests {
namespace {

using geometry::ScreenTriangle;

const core::Allocator g_allocator = {core::default_allocator()};
constexpr size_t kRows = 1024;
constexpr uint32_t kTriangles = 4000;
constexpr uint32_t kWidth = 300, kHeight = 200;

struct Fixture {
  geometry::Mesh mesh = {};
  geometry::Vertices vertices;
  core::Buffer<ScreenTriangle> out;
};
Fixture* g;

int set_up(void**) {
  g = new Fixture;
  geometry::Mesh& m = g->mesh;
  m.vertex_count = kRows;
  m.triangle_count = kTriangles;
  for (core::Array<float>* column : {&m.px, &m.py, &m.pz, &m.nx, &m.ny, &m.nz, &m.u, &m.v}) {
    *column = core::Array<float>(g_allocator, kRows);
    column->fill_zero();
  }
  m.indices = core::Array<uint32_t>(g_allocator, 3 * size_t{kTriangles});
  m.indices.fill_zero();
  geometry::allocate(g_allocator, m, 0, &g->vertices);
  g->out.attach(g_allocator);
  return 0;
}
int tear_down(void**) {
  delete g;
  return 0;
}

/// Raster coordinates are p.x and p.y, depth p.z; with `perspective`, W is p.z + 1/2.
void transform(bool perspective) {
  geometry::Transform t = {};
  t.raster[0] = t.raster[5] = t.raster[10] = 1.0f;
  t.raster[15] = perspective ? 0.5f : 1.0f;
  t.raster[11] = perspective ? 1.0f : 0.0f;
  t.right = static_cast<float>(kWidth);
  t.bottom = static_cast<float>(kHeight);
  const core::SimdTarget target = best_target();
  geometry::transform_vertices(target, g->mesh, t, {0, kRows, 0}, &g->vertices);
}

shd_render_stats assemble(shd_cull cull, size_t begin, size_t end) {
  shd_render_stats stats = shd_render_stats_default();
  const geometry::Assembly assembly = {
      &g->vertices, 5, cull, geometry::viewport_box(kWidth, kHeight), {128, 128, 128, 128}};
  geometry::assemble(assembly, begin, end, &g->out, &stats);
  return stats;
}

void set_vertex(size_t i, float x, float y, float z) {
  g->mesh.px[i] = x;
  g->mesh.py[i] = y;
  g->mesh.pz[i] = z;
}

/// Triangles between vertices of every kind: in the frame, far outside, on pixel corners, NaN, behind the eye.
void make_soup(Random* random, double reach) {
  for (size_t i = 0; i < kRows; ++i) {
    set_vertex(i, random->real(-reach, reach), random->real(-reach, reach), random->real(-0.9, 1.5));
    if (i % 7 == 0) set_vertex(i, std::floor(g->mesh.px[i]), std::floor(g->mesh.py[i]), 0.5f);
    if (i % 50 == 0) g->mesh.px[i] = NAN;
    if (i % 61 == 0) g->mesh.pz[i] = INFINITY;
  }
  for (size_t i = 0; i < 3 * size_t{kTriangles}; ++i) {
    g->mesh.indices[i] =
        i % 3 && random->bits() % 10 == 0 ? g->mesh.indices[i - 1] : static_cast<uint32_t>(random->whole(0, kRows - 1));
  }
}

void check_kept(const shd_render_stats& stats) {
  uint64_t primitives = 0;
  for (size_t i = 0; i < g->out.size(); ++i) {
    const ScreenTriangle& t = g->out[i];
    const int64_t area = (int64_t{t.x[1]} - t.x[0]) * (int64_t{t.y[2]} - t.y[0]) -
                         (int64_t{t.x[2]} - t.x[0]) * (int64_t{t.y[1]} - t.y[0]);
    assert_true(area > 0);
    assert_int_equal(t.draw, 5);
    assert_true(t.primitive < kTriangles);
    for (int k = 0; k < 3; ++k) {
      assert_true(abs(t.x[k]) <= 1 << 28 && abs(t.y[k]) <= 1 << 28 && t.z[k] >= 0.0f && t.z[k] <= 1.0f);
    }
    // Pieces of one triangle are adjacent, in the order of the triangles.
    if (i > 0) assert_true(t.primitive >= g->out[i - 1].primitive);
    primitives += i == 0 || t.primitive != g->out[i - 1].primitive;
  }
  assert_int_equal(primitives, stats.rasterized_triangle_count);
}

uint64_t sum(const shd_render_stats& s) {
  return s.nonfinite_triangle_count + s.outside_triangle_count + s.culled_triangle_count + s.empty_triangle_count +
         s.rasterized_triangle_count;
}

struct soup_case {
  const char* name;
  double reach;
  bool perspective;
};
const soup_case k_soups[] = {
    {"soup/small", 400.0, false},      {"soup/sub_pixel", 1.5, false},        {"soup/guard_band", 3e6, false},
    {"soup/perspective", 400.0, true}, {"soup/perspective_guard", 1e6, true}, {"soup/huge", 1e30, true},
};

void test_soup(void** state) {
  const auto* c = static_cast<const soup_case*>(*state);
  Random random = {19};
  make_soup(&random, c->reach);
  transform(c->perspective);
  shd_render_stats stats[3];
  for (shd_cull cull : {SHD_CULL_NONE, SHD_CULL_BACK, SHD_CULL_FRONT}) {
    g->out.clear();
    stats[cull] = assemble(cull, 0, kTriangles);
    assert_int_equal(stats[cull].triangle_count, kTriangles);
    assert_int_equal(sum(stats[cull]), kTriangles);
    assert_true(stats[cull].clipped_triangle_count + stats[cull].nonfinite_triangle_count <= kTriangles);
    check_kept(stats[cull]);
  }
  assert_int_equal(stats[0].nonfinite_triangle_count, stats[1].nonfinite_triangle_count);
  assert_int_equal(stats[0].clipped_triangle_count, stats[2].clipped_triangle_count);
  assert_true(stats[0].nonfinite_triangle_count > 0 && stats[0].rasterized_triangle_count > 0);
  // Triangles kept by one mode are culled by the other; slivers of a clipped triangle may face either way.
  const uint64_t both = stats[1].rasterized_triangle_count + stats[2].rasterized_triangle_count;
  assert_true(both >= stats[0].rasterized_triangle_count &&
              both <= stats[0].rasterized_triangle_count + stats[0].clipped_triangle_count);
}

/// Parts append to one list and to the counts, for any division into parts.
void test_parts(void**) {
  Random random = {20};
  make_soup(&random, 400.0);
  transform(true);
  g->out.clear();
  const shd_render_stats whole = assemble(SHD_CULL_BACK, 0, kTriangles);
  const size_t kept = g->out.size();
  const uint64_t hash = shd_hash(SHD_HASH_START, g->out.data(), kept * sizeof(ScreenTriangle));
  g->out.clear();
  shd_render_stats parts = shd_render_stats_default();
  for (size_t begin = 0; begin < kTriangles; begin += 333) {
    const shd_render_stats s = assemble(SHD_CULL_BACK, begin, std::min<size_t>(kTriangles, begin + 333));
    parts.triangle_count += s.triangle_count;
    parts.rasterized_triangle_count += s.rasterized_triangle_count;
    parts.clipped_triangle_count += s.clipped_triangle_count;
  }
  assert_int_equal(parts.triangle_count, whole.triangle_count);
  assert_int_equal(parts.rasterized_triangle_count, whole.rasterized_triangle_count);
  assert_int_equal(parts.clipped_triangle_count, whole.clipped_triangle_count);
  assert_int_equal(g->out.size(), kept);
  assert_true(hash == shd_hash(SHD_HASH_START, g->out.data(), kept * sizeof(ScreenTriangle)));
}

struct outcome_case {
  const char* name;
  float v[3][3];
  shd_cull cull;
  const char* outcome;
};
const outcome_case k_outcomes[] = {
    {"outcome/clockwise_with_y_down_is_back", {{10, 10, 0}, {50, 10, 0}, {10, 50, 0}}, SHD_CULL_BACK, "culled"},
    {"outcome/clockwise_kept_by_front", {{10, 10, 0}, {50, 10, 0}, {10, 50, 0}}, SHD_CULL_FRONT, "rasterised"},
    {"outcome/counter_clockwise_is_front", {{10, 10, 0}, {10, 50, 0}, {50, 10, 0}}, SHD_CULL_FRONT, "culled"},
    {"outcome/counter_clockwise_kept_by_back", {{10, 10, 0}, {10, 50, 0}, {50, 10, 0}}, SHD_CULL_BACK, "rasterised"},
    {"outcome/both_kept_by_none", {{10, 10, 0}, {10, 50, 0}, {50, 10, 0}}, SHD_CULL_NONE, "rasterised"},
    {"outcome/point", {{10, 10, 0}, {10, 10, 0}, {10, 10, 0}}, SHD_CULL_NONE, "culled"},
    {"outcome/line", {{10, 10, 0}, {20, 20, 0}, {30, 30, 0}}, SHD_CULL_NONE, "culled"},
    {"outcome/repeated_vertex", {{10, 10, 0}, {20, 10, 0}, {10, 10, 0}}, SHD_CULL_NONE, "culled"},
    {"outcome/no_area_on_the_grid", {{10, 10, 0}, {20, 10, 0}, {15, 10.001f, 0}}, SHD_CULL_NONE, "culled"},
    {"outcome/between_centres", {{10.6f, 10.6f, 0}, {11.4f, 10.6f, 0}, {10.6f, 11.4f, 0}}, SHD_CULL_NONE, "empty"},
    {"outcome/between_rows", {{10, 10.6f, 0}, {90, 10.6f, 0}, {10, 11.4f, 0}}, SHD_CULL_NONE, "empty"},
    {"outcome/one_centre", {{10.4f, 10.4f, 0}, {10.9f, 10.4f, 0}, {10.4f, 10.9f, 0}}, SHD_CULL_NONE, "rasterised"},
    {"outcome/left_of_frame", {{-50, 10, 0}, {-10, 10, 0}, {-50, 90, 0}}, SHD_CULL_NONE, "outside"},
    {"outcome/below_frame", {{10, 201, 0}, {90, 201, 0}, {10, 290, 0}}, SHD_CULL_NONE, "outside"},
    {"outcome/left_edge_before_first_centre", {{-10, 10, 0}, {0.4f, 10, 0}, {-10, 90, 0}}, SHD_CULL_NONE, "outside"},
    {"outcome/past_a_corner", {{-50, 20, 0}, {-40, 900, 0}, {-1, 250, 0}}, SHD_CULL_NONE, "outside"},
    {"outcome/near", {{10, 10, -0.5f}, {50, 10, -0.1f}, {10, 50, -0.2f}}, SHD_CULL_NONE, "outside"},
    {"outcome/far", {{10, 10, 1.5f}, {50, 10, 1.1f}, {10, 50, 1.2f}}, SHD_CULL_NONE, "outside"},
    {"outcome/crosses_near", {{10, 10, -0.5f}, {50, 10, 0.5f}, {10, 50, 0.5f}}, SHD_CULL_NONE, "rasterised"},
    {"outcome/on_near_and_far", {{10, 10, 0}, {50, 10, 1}, {10, 50, 1}}, SHD_CULL_NONE, "rasterised"},
    {"outcome/nan", {{10, 10, 0}, {50, NAN, 0}, {10, 50, 0}}, SHD_CULL_NONE, "nonfinite"},
    {"outcome/infinite", {{10, 10, 0}, {50, 10, 0}, {-INFINITY, 50, 0}}, SHD_CULL_NONE, "nonfinite"},
    {"outcome/nan_and_outside", {{-10, 10, 0}, {-50, NAN, 0}, {-10, 50, 0}}, SHD_CULL_NONE, "nonfinite"},
};

void test_outcome(void** state) {
  const auto* c = static_cast<const outcome_case*>(*state);
  for (uint32_t k = 0; k < 3; ++k) {
    set_vertex(k, c->v[k][0], c->v[k][1], c->v[k][2]);
    g->mesh.indices[k] = k;
  }
  transform(false);
  g->out.clear();
  const shd_render_stats s = assemble(c->cull, 0, 1);
  const char* got = s.nonfinite_triangle_count    ? "nonfinite"
                    : s.outside_triangle_count    ? "outside"
                    : s.culled_triangle_count     ? "culled"
                    : s.empty_triangle_count      ? "empty"
                    : s.rasterized_triangle_count ? "rasterised"
                                                  : "none";
  assert_int_equal(sum(s), 1);
  assert_string_equal(got, c->outcome);
  assert_int_equal(g->out.size() > 0, s.rasterized_triangle_count);
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  CMUnitTest tests[40];
  size_t n = 0;
  for (const soup_case& c : k_soups) tests[n++] = {c.name, test_soup, nullptr, nullptr, const_cast<soup_case*>(&c)};
  tests[n++] = {"parts", test_parts, nullptr, nullptr, nullptr};
  for (const outcome_case& c : k_outcomes)
    tests[n++] = {c.name, test_outcome, nullptr, nullptr, const_cast<outcome_case*>(&c)};
  return _cmocka_run_group_tests("unit.geometry.assemble", tests, n, set_up, tear_down);
}
