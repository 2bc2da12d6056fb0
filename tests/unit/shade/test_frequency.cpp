// SPDX-License-Identifier: MIT
// Corners and centroids against long double, and the three shading frequencies through whole batches.
#include "support/check.h"

#include <algorithm>
#include <cfloat>

#include "raster/interpolate.h"
#include "ref/shade_ref.h"
#include "shade/frequency.h"
#include "shade/run.h"
#include "support/random.h"
#include "support/targets.h"

namespace shd::tests {
namespace {

using raster::kBatch;
using ref::Vector;

const core::Allocator g_allocator = {core::default_allocator()};
constexpr uint32_t kTriangles = 170;
constexpr size_t kVertices = 3 * kTriangles;
constexpr float kEye[3] = {1.0f, 2.0f, 9.0f};

struct Fixture {
  geometry::Mesh mesh = {};
  geometry::Vertices vertices;
  material::Material material;
  shade::LightTable lights = {};
  shade::Workspace workspace, first;
};
Fixture* g;

int set_up(void**) {
  g = new Fixture;
  g->lights.lights = core::Array<light::Light>(g_allocator, 4);
  g->mesh.vertex_count = kVertices;
  g->mesh.triangle_count = kTriangles;
  g->mesh.indices = core::Array<uint32_t>(g_allocator, kVertices);
  for (uint32_t i = 0; i < kVertices; ++i) g->mesh.indices[i] = i;
  geometry::allocate(g_allocator, g->mesh, 0, &g->vertices);
  shade::allocate(g_allocator, {0, 1, 4}, &g->workspace);
  shade::allocate(g_allocator, {0, 1, 4}, &g->first);
  return 0;
}
int tear_down(void**) {
  delete g;
  return 0;
}

void set_vertex(size_t i, const float* p, const float* n, float u, float v) {
  const float world[4] = {p[0], p[1], p[2], u}, normal[4] = {n[0], n[1], n[2], v};
  memcpy(&g->vertices.world[4 * i], world, sizeof world);
  memcpy(&g->vertices.normal[4 * i], normal, sizeof normal);
}

struct centroid_case {
  const char* name;
  float p[3][3];
  float orientation;
  bool has_normal;
};
const centroid_case k_centroids[] = {
    {"centroid/unit", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 1, true},
    {"centroid/mirrored", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, -1, true},
    {"centroid/oblique", {{1, 2, 3}, {-4, 5, 0.5f}, {7, -8, 9}}, 1, true},
    {"centroid/far_away", {{1e6f, 1e6f, 1e6f}, {1000001, 1e6f, 1e6f}, {1e6f, 1000001, 1e6f}}, 1, true},
    {"centroid/1e-20", {{0, 0, 0}, {1e-20f, 0, 0}, {0, 1e-20f, 1e-20f}}, 1, true},
    {"centroid/1e20", {{0, 0, 0}, {1e20f, 0, 0}, {0, 1e20f, 1e20f}}, 1, true},
    {"centroid/needle", {{0, 0, 0}, {1, 0, 0}, {0.5f, 1e-6f, 0}}, 1, true},
    {"centroid/point", {{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, 1, false},
    {"centroid/line", {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, 1, false},
    {"centroid/whole_range", {{FLT_MAX, 0, 0}, {-FLT_MAX, FLT_MAX, 0}, {-FLT_MAX, -FLT_MAX, 0}}, 1, true},
    {"centroid/all_largest",
     {{FLT_MAX, FLT_MAX, FLT_MAX}, {FLT_MAX, FLT_MAX, FLT_MAX}, {FLT_MAX, FLT_MAX, FLT_MAX}},
     1,
     false},
    {"centroid/denormal", {{0, 0, 0}, {1e-44f, 0, 0}, {0, 1e-44f, 0}}, 1, true},
};

void test_centroid(void** state) {
  const auto* c = static_cast<const centroid_case*>(*state);
  const float normal[3] = {0, 0, 1};
  for (size_t k = 0; k < 3; ++k) set_vertex(k, c->p[k], normal, c->p[k][0], c->p[k][1]);
  raster::Fragments& points = g->workspace.points;
  shade::set_centroid(g->vertices, kEye, c->orientation, 0, 7, &points);
  const Vector a = ref::vector(c->p[0]), b = ref::vector(c->p[1]), d = ref::vector(c->p[2]);
  const Vector centre = 1.0L / 3 * (a + b + d);
  const Vector n = c->has_normal ? c->orientation * ref::unit(ref::cross(b - a, d - a)) : Vector{0, 0, 0};
  const long double size = std::max({fabsl(a.x), fabsl(b.x), fabsl(d.x), fabsl(a.y), fabsl(b.y), fabsl(d.y)});
  const auto bound = static_cast<double>(4 * 0x1p-24L * size) + 1.5e-45;
  shd_assert_close("px", 0, points.px[7], static_cast<double>(centre.x), bound, 0.0);
  shd_assert_close("py", 0, points.py[7], static_cast<double>(centre.y), bound, 0.0);
  shd_assert_close("pz", 0, points.pz[7], static_cast<double>(centre.z), bound, 1e-6);
  shd_assert_close("u", 0, points.u[7], static_cast<double>(centre.x), bound, 0.0);
  shd_assert_close("v", 0, points.v[7], static_cast<double>(centre.y), bound, 0.0);
  shd_assert_close("nx", 0, points.nx[7], static_cast<double>(n.x), 1e-6, 0.0);
  shd_assert_close("ny", 0, points.ny[7], static_cast<double>(n.y), 1e-6, 0.0);
  shd_assert_close("nz", 0, points.nz[7], static_cast<double>(n.z), 1e-6, 0.0);
  assert_int_equal(points.triangle[7], 0);
  for (const float* o : {points.ox, points.oy, points.oz}) assert_true(std::isfinite(o[7]));
}

/// Random triangles: corners equal the vertices, the centroid has the normal of the face, wo is unit.
void test_random_rows(void**) {
  Random random = {71};
  for (size_t i = 0; i < kVertices; ++i) {
    const float p[3] = {random.real(-5, 5), random.real(-5, 5), random.real(-5, 5)};
    const float n[3] = {0.0f, 0.6f, 0.8f};
    set_vertex(i, p, n, random.real(0, 1), random.real(0, 1));
  }
  raster::Fragments& points = g->workspace.points;
  for (uint32_t t = 0; t < kTriangles; ++t) shade::set_corners(g->vertices, kEye, t, 3 * t, &points);
  for (size_t i = 0; i < kVertices; ++i) {
    const float* p = &g->vertices.world[4 * i];
    assert_true(points.px[i] == p[0] && points.py[i] == p[1] && points.pz[i] == p[2] && points.u[i] == p[3]);
    assert_true(points.nx[i] == 0.0f && points.ny[i] == 0.6f && points.nz[i] == 0.8f);
    assert_true(points.v[i] == g->vertices.normal[4 * i + 3]);
    assert_int_equal(points.triangle[i], i / 3);
    const Vector o = ref::unit(ref::vector(kEye) - ref::vector(p));
    shd_assert_close("ox", i, points.ox[i], static_cast<double>(o.x), 3e-7, 0.0);
    shd_assert_close("oy", i, points.oy[i], static_cast<double>(o.y), 3e-7, 0.0);
    shd_assert_close("oz", i, points.oz[i], static_cast<double>(o.z), 3e-7, 0.0);
  }
}

void corner(size_t i, float x, float y, float w) {
  float* r = &g->vertices.raster[4 * i];
  r[0] = x * w, r[1] = y * w, r[2] = 0.5f * w, r[3] = w;
}

/// Triangles in a plane with one normal, seen in perspective; every batch row is inside its triangle.
void make_scene(Random* random, size_t fragments) {
  const float normal[3] = {0.0f, 0.6f, 0.8f};
  for (uint32_t t = 0; t < kTriangles; ++t) {
    const float x = random->real(2, 62), y = random->real(2, 62), place[3][2] = {{-9, -7}, {8, -6}, {1, 12}};
    for (size_t k = 0; k < 3; ++k) {
      const float p[3] = {random->real(-2, 2), random->real(-2, 2), 0.0f};
      const float on_plane[3] = {p[0], p[1], -0.75f * p[1]};
      set_vertex(3 * t + k, on_plane, normal, random->real(0, 1), random->real(0, 1));
      corner(3 * t + k, x + place[k][0], y + place[k][1], random->real(1, 3));
    }
    // The triangles are seen from the side that the normal points to.
    float *b = &g->vertices.world[4 * size_t{3 * t + 1}], *c = &g->vertices.world[4 * size_t{3 * t + 2}];
    const Vector a = ref::vector(&g->vertices.world[4 * size_t{3 * t}]);
    if (ref::cross(ref::vector(b) - a, ref::vector(c) - a).z < 0) std::swap_ranges(b, b + 4, c);
    for (size_t i = fragments * t / kTriangles; i < fragments * (t + 1) / kTriangles; ++i) {
      raster::Fragments& f = g->workspace.fragments;
      f.x[i] = x + random->real(-2, 2), f.y[i] = y + random->real(-2, 2);
      f.depth[i] = 0.5f;
      f.triangle[i] = t;
    }
  }
  g->workspace.fragments.count = fragments;
}

void set_light(const float* direction) {
  shd_light_desc desc = shd_light_desc_default();
  desc.kind = SHD_LIGHT_KIND_DIRECTIONAL;
  for (int c = 0; c < 3; ++c) desc.direction[c] = direction[c];
  g->lights.count = 1;
  g->lights.lights[0] = light::make_light(desc, nullptr, nullptr);
}

void set_material(shd_model model) {
  shd_material_desc desc = shd_material_desc_default();
  desc.model = model;
  desc.exponent = 1.0f;
  const material::SlotInput slots[material::kSlotCount] = {};
  material::build(desc, slots, &g->material);
}

void shade_everywhere(shd_frequency frequency, size_t fragments, uint64_t seed) {
  for_each_target([&](const core::SimdTarget& target, bool first) {
    Random random = {seed};
    make_scene(&random, fragments);
    const shade::DrawShading shading = {&g->vertices,          &g->material, frequency, 1.0f, 3, 0,
                                        raster::kBarycentrics, nullptr,      nullptr};
    shd_view view = {};
    for (int c = 0; c < 3; ++c) view.eye[c] = kEye[c];
    shade::shade_batch(target, shading, g->lights, view, &g->workspace);
    for (int c = 0; c < 4; ++c) {
      float *got = g->workspace.columns.radiance.channel[c], *kept = g->first.columns.radiance.channel[c];
      if (first) memcpy(kept, got, fragments * sizeof(float));
      if (memcmp(kept, got, fragments * sizeof(float)) != 0)
        fail_msg("%s: other bits, %zu points", target.name, fragments);
    }
  });
}

struct frequency_case {
  const char* name;
  shd_frequency frequency;
  shd_model model;
};
const frequency_case k_frequencies[] = {
    {"lambert/phong", SHD_FREQUENCY_PHONG, SHD_MODEL_LAMBERT},
    {"lambert/gouraud", SHD_FREQUENCY_GOURAUD, SHD_MODEL_LAMBERT},
    {"lambert/flat", SHD_FREQUENCY_FLAT, SHD_MODEL_LAMBERT},
    {"blinn_phong/phong", SHD_FREQUENCY_PHONG, SHD_MODEL_BLINN_PHONG},
    {"blinn_phong/gouraud", SHD_FREQUENCY_GOURAUD, SHD_MODEL_BLINN_PHONG},
    {"blinn_phong/flat", SHD_FREQUENCY_FLAT, SHD_MODEL_BLINN_PHONG},
};

/// k_d n.l + k_s n.h at a point of the plane.
long double plane_radiance(shd_model model, Vector p) {
  const Vector n = {0, 0.6L, 0.8L}, wo = ref::unit(ref::vector(kEye) - p);
  const ref::Term t = ref::light_term(g->lights.lights[0], p, n, wo, 1.0f, true);
  return 0.8f * t.diffuse + (model == SHD_MODEL_BLINN_PHONG ? 0.5f * t.specular : 0.0L);
}

/// Each frequency evaluates the model at its points: at the fragment, at the corners, at the centroid.
void test_frequency(void** state) {
  const auto* c = static_cast<const frequency_case*>(*state);
  const float way[3] = {0.3f, -1.0f, -1.5f};
  set_light(way);
  set_material(c->model);
  for (size_t fragments : {size_t{kBatch}, size_t{171}, size_t{130}, size_t{64}, size_t{33}, size_t{1}}) {
    shade_everywhere(c->frequency, fragments, 73 + fragments);
    const raster::Fragments& f = g->workspace.fragments;
    for (size_t i = 0; i < fragments; ++i) {
      Vector corners[3], p = {0, 0, 0};
      long double gouraud = 0;
      for (size_t k = 0; k < 3; ++k) {
        corners[k] = ref::vector(&g->vertices.world[4 * (3 * size_t{f.triangle[i]} + k)]);
        gouraud += f.bary[k][i] * plane_radiance(c->model, corners[k]);
        p = p + static_cast<long double>(f.bary[k][i]) * corners[k];
      }
      const Vector centroid = 1.0L / 3 * (corners[0] + corners[1] + corners[2]);
      const long double want = c->frequency == SHD_FREQUENCY_PHONG     ? plane_radiance(c->model, p)
                               : c->frequency == SHD_FREQUENCY_GOURAUD ? gouraud
                                                                       : plane_radiance(c->model, centroid);
      for (int channel = 0; channel < 3; ++channel) {
        shd_assert_close("radiance", i, g->workspace.columns.radiance.channel[channel][i], static_cast<double>(want),
                         5e-6, 0.0);
      }
      assert_true(g->workspace.columns.radiance.channel[3][i] == 1.0f);
    }
  }
}

size_t g_rows;

/// Writes its inputs; counts its points.
void copy_program(const shd_fragments* in, shd_radiance* out, void*) {
  g_rows += in->count;
  for (size_t i = 0; i < in->count; ++i) {
    out->r[i] = in->u[i];
    out->g[i] = static_cast<float>(in->triangle[i]);
    out->b[i] = in->draw == 3 && in->struct_size == sizeof *in ? in->nz[i] : -1.0f;
  }
}

/// A program is called with one row per fragment, three per triangle, or one per triangle.
void test_program(void** state) {
  const auto* c = static_cast<const frequency_case*>(*state);
  set_material(SHD_MODEL_PROGRAM);
  g->material.program.fragment = copy_program;
  g_rows = 0;
  shade_everywhere(c->frequency, kBatch, 79);
  size_t targets = 0;
  for_each_target([&](const core::SimdTarget&, bool) { ++targets; });
  const size_t want = c->frequency == SHD_FREQUENCY_PHONG     ? kBatch
                      : c->frequency == SHD_FREQUENCY_GOURAUD ? kVertices
                                                              : kTriangles;
  assert_int_equal(g_rows, want * targets);
  const raster::Fragments& f = g->workspace.fragments;
  for (size_t i = 0; i < kBatch; ++i) {
    const float* const* out = g->workspace.columns.radiance.channel;
    double u = 0.0, flat = 0.0;
    for (size_t k = 0; k < 3; ++k) {
      const double corner_u = g->vertices.world[4 * (3 * size_t{f.triangle[i]} + k) + 3];
      u += f.bary[k][i] * corner_u;
      flat += corner_u / 3.0;
    }
    shd_assert_close("u", i, out[0][i], c->frequency == SHD_FREQUENCY_FLAT ? flat : u, 1e-6, 0.0);
    shd_assert_close("triangle", i, out[1][i], f.triangle[i], 0.0, 0.0);
    shd_assert_close("nz", i, out[2][i], 0.8, 1e-3, 0.0);  // corners rounded to float lie in a plane only approximately
    assert_true(out[3][i] == 1.0f);
  }
}

const frequency_case k_programs[] = {
    {"program/phong", SHD_FREQUENCY_PHONG, SHD_MODEL_PROGRAM},
    {"program/gouraud", SHD_FREQUENCY_GOURAUD, SHD_MODEL_PROGRAM},
    {"program/flat", SHD_FREQUENCY_FLAT, SHD_MODEL_PROGRAM},
};

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  CMUnitTest tests[32];
  size_t n = 0;
  for (const centroid_case& c : k_centroids) {
    tests[n++] = {c.name, test_centroid, nullptr, nullptr, const_cast<centroid_case*>(&c)};
  }
  tests[n++] = {"points/random", test_random_rows, nullptr, nullptr, nullptr};
  for (const frequency_case& c : k_frequencies) {
    tests[n++] = {c.name, test_frequency, nullptr, nullptr, const_cast<frequency_case*>(&c)};
  }
  for (const frequency_case& c : k_programs) {
    tests[n++] = {c.name, test_program, nullptr, nullptr, const_cast<frequency_case*>(&c)};
  }
  return _cmocka_run_group_tests("unit.shade.frequency", tests, n, set_up, tear_down);
}
