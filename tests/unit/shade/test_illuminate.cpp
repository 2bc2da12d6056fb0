// SPDX-License-Identifier: MIT
// Lobes of every model and light kind against the formulas in long double; edges; tails; bits on every target.
#include "support/check.h"

#include <algorithm>
#include <cfloat>

#include "data/data.h"
#include "ref/shade_ref.h"
#include "shade/illuminate.h"
#include "support/random.h"
#include "support/targets.h"

namespace shd::tests {
namespace {

using raster::kBatch;
using ref::Vector;

const core::Allocator g_allocator = {core::default_allocator()};

struct Fixture {
  material::Material material;
  shade::LightTable lights;
  shade::ActiveLight active[16];
  raster::Fragments points;
  shade::Columns columns, first;
};
Fixture* g;

int set_up(void**) {
  g = new Fixture;
  g->lights.lights = core::Array<light::Light>(g_allocator, 16);
  raster::allocate(g_allocator, &g->points);
  shade::allocate(g_allocator, 1, &g->columns);
  shade::allocate(g_allocator, 1, &g->first);
  return 0;
}
int tear_down(void**) {
  delete g;
  return 0;
}

light::Light point_light(const float* position, float intensity) {
  shd_light_desc desc = shd_light_desc_default();
  for (int c = 0; c < 3; ++c) {
    desc.position[c] = position[c];
    desc.intensity[c] = intensity * (1.0f + 0.25f * static_cast<float>(c));
  }
  return light::make_light(desc, nullptr, nullptr);
}
light::Light directional_light(const float* direction, float intensity) {
  shd_light_desc desc = shd_light_desc_default();
  desc.kind = SHD_LIGHT_KIND_DIRECTIONAL;
  for (int c = 0; c < 3; ++c) {
    desc.direction[c] = direction[c];
    desc.intensity[c] = intensity * (1.0f + 0.25f * static_cast<float>(c));
  }
  return light::make_light(desc, nullptr, nullptr);
}

void set_point(size_t i, Vector p, Vector n, Vector wo) {
  raster::Fragments& f = g->points;
  f.px[i] = static_cast<float>(p.x), f.py[i] = static_cast<float>(p.y), f.pz[i] = static_cast<float>(p.z);
  f.nx[i] = static_cast<float>(n.x), f.ny[i] = static_cast<float>(n.y), f.nz[i] = static_cast<float>(n.z);
  f.ox[i] = static_cast<float>(wo.x), f.oy[i] = static_cast<float>(wo.y), f.oz[i] = static_cast<float>(wo.z);
}

Vector random_unit(Random* random) {
  for (;;) {
    const Vector v = {random->in(-1.0, 1.0), random->in(-1.0, 1.0), random->in(-1.0, 1.0)};
    if (ref::length(v) > 0.1L && ref::length(v) < 1.0L) return ref::unit(v);
  }
}

/// Computes the lobes of the fixture's points under its lights.
void illuminate(const core::SimdTarget& target, material::Lobes* out) {
  for (size_t k = 0; k < g->lights.count; ++k) g->active[k] = {&g->lights.lights[k], {nullptr, nullptr, nullptr}};
  shade::illuminate(target, g->material, {}, g->active, g->lights.count, g->points, {false, true}, out);
}

struct model_case {
  const char* name;
  shd_model model;
  uint32_t flags;
  float exponent;
};
const model_case k_models[] = {
    {"lambert", SHD_MODEL_LAMBERT, 0, 64.0f},
    {"blinn_phong/0", SHD_MODEL_BLINN_PHONG, 0, 0.0f},
    {"blinn_phong/1", SHD_MODEL_BLINN_PHONG, 0, 1.0f},
    {"blinn_phong/64", SHD_MODEL_BLINN_PHONG, 0, 64.0f},
    {"blinn_phong/1e4", SHD_MODEL_BLINN_PHONG, 0, 1e4f},
    {"blinn_phong/1e6", SHD_MODEL_BLINN_PHONG, 0, 1e6f},
    {"ungated/0", SHD_MODEL_BLINN_PHONG, SHD_MATERIAL_SPECULAR_UNGATED, 0.0f},
    {"ungated/1", SHD_MODEL_BLINN_PHONG, SHD_MATERIAL_SPECULAR_UNGATED, 1.0f},
    {"ungated/64", SHD_MODEL_BLINN_PHONG, SHD_MATERIAL_SPECULAR_UNGATED, 64.0f},
    {"ungated/1e4", SHD_MODEL_BLINN_PHONG, SHD_MATERIAL_SPECULAR_UNGATED, 1e4f},
    {"ungated/1e6", SHD_MODEL_BLINN_PHONG, SHD_MATERIAL_SPECULAR_UNGATED, 1e6f},
};

void set_material(const model_case& c) {
  g->material.model = material::key_of(c.model);
  g->material.flags = c.flags;
  g->material.exponent = c.exponent;
}

enum Mix { kPoint, kDirectional, kBoth };

void random_lights(Random* random, size_t count, Mix mix) {
  g->lights.count = count;
  for (size_t k = 0; k < count; ++k) {
    const float at[3] = {random->real(-5.0, 5.0), random->real(-5.0, 5.0), random->real(-5.0, 5.0)};
    const float intensity = static_cast<float>(std::exp2(random->in(-3.0, 6.0)));
    const bool point = mix == kPoint || (mix == kBoth && k % 2);
    g->lights.lights[k] = point ? point_light(at, intensity) : directional_light(at, intensity);
  }
}

/// Random rows; every other row shows the highlight of a light, with its normal near the half vector.
void random_points(Random* random, float exponent) {
  g->points.count = kBatch;
  for (size_t i = 0; i < kBatch; ++i) {
    const Vector p = {random->in(-3.0, 3.0), random->in(-3.0, 3.0), random->in(-3.0, 3.0)};
    const Vector wo = random_unit(random);
    Vector n = random_unit(random);
    if (i % 2 && g->lights.count) {
      const light::Light& light = g->lights.lights[i / 2 % g->lights.count];
      const Vector l =
          light.kind == SHD_LIGHT_KIND_POINT ? ref::unit(ref::vector(light.position) - p) : ref::vector(light.to_light);
      n = ref::unit(ref::unit(wo + l) + sqrtl(random->in(0.0, 2.0) / (1.0 + double{exponent})) * n);
    }
    set_point(i, p, n, wo);
  }
}

double g_diffuse, g_specular;  // largest errors per unit of illumination; the specular error also per (2 + exponent)

/// Compares row i with the formulas. Stated bounds: 2e-6 of the light for diffuse; 2e-6 + 2.5e-7 exponent
/// (1 + 2 / |v + l|) for specular, because a short v + l magnifies its own rounding.
void check_point(size_t i, const model_case& c) {
  const raster::Fragments& f = g->points;
  const float p[3] = {f.px[i], f.py[i], f.pz[i]}, n[3] = {f.nx[i], f.ny[i], f.nz[i]},
              o[3] = {f.ox[i], f.oy[i], f.oz[i]};
  long double diffuse = 0, specular = 0, diffuse_bound = 1e-40L, specular_bound = 1e-40L;
  bool ambiguous = false;
  for (size_t k = 0; k < g->lights.count; ++k) {
    const light::Light& light = g->lights.lights[k];
    const ref::Term t = ref::light_term(light, ref::vector(p), ref::vector(n), ref::vector(o), c.exponent,
                                        !(c.flags & SHD_MATERIAL_SPECULAR_UNGATED));
    const long double received = light.intensity[0] * t.falloff;
    diffuse += light.intensity[0] * t.diffuse;
    specular += light.intensity[0] * t.specular;
    // The contribution of the light, and the loss where 1 / r^2 leaves the range of float.
    diffuse_bound += 2e-6L * received + 3e-39L * light.intensity[0];
    specular_bound +=
        (2e-6L + 2.5e-7L * c.exponent * (1 + 2 / std::max(t.half, 1e-9L))) * received + 3e-39L * light.intensity[0];
    ambiguous |= fabsl(t.n_dot_l) < 1e-6L || t.half < 1e-6L;
    if (t.half > 0.5L && t.falloff > 1e-30L && g->lights.count == 1) {
      g_diffuse = std::max(g_diffuse, static_cast<double>(fabsl(g->first.lobes.lobe[0][0][i] - diffuse) / received));
      if (c.model == SHD_MODEL_BLINN_PHONG && !ambiguous) {
        g_specular = std::max(g_specular, static_cast<double>(fabsl(g->first.lobes.lobe[1][0][i] - specular) /
                                                              received / (2 + c.exponent)));
      }
    }
  }
  for (int channel = 0; channel < 3; ++channel) {
    const double scale = 1.0 + 0.25 * channel;
    shd_assert_close("diffuse", i, g->first.lobes.lobe[0][channel][i] / scale, static_cast<double>(diffuse),
                     static_cast<double>(diffuse_bound), 0.0);
    if (c.model != SHD_MODEL_BLINN_PHONG) continue;
    if (ambiguous) {
      assert_true(std::isfinite(g->first.lobes.lobe[1][channel][i]));
    } else {
      shd_assert_close("specular", i, g->first.lobes.lobe[1][channel][i] / scale, static_cast<double>(specular),
                       static_cast<double>(specular_bound), 0.0);
    }
  }
}

/// Runs every target into `columns`, the first also into `first`; all bits must agree.
void illuminate_everywhere(const model_case& c) {
  for_each_target([&](const core::SimdTarget& target, bool first) {
    shade::Columns& out = first ? g->first : g->columns;
    illuminate(target, &out.lobes);
    if (first) return;
    for (int channel = 0; channel < 3; ++channel) {
      const size_t bytes = g->points.count * sizeof(float);
      if (memcmp(out.lobes.lobe[0][channel], g->first.lobes.lobe[0][channel], bytes) != 0 ||
          (c.model == SHD_MODEL_BLINN_PHONG &&
           memcmp(out.lobes.lobe[1][channel], g->first.lobes.lobe[1][channel], bytes) != 0)) {
        fail_msg("%s: other bits", target.name);
      }
    }
  });
}

void test_model(void** state) {
  const auto* c = static_cast<const model_case*>(*state);
  set_material(*c);
  g_diffuse = g_specular = 0.0;
  Random random = {51};
  for (Mix mix : {kPoint, kDirectional, kBoth}) {
    for (size_t count : {0, 1, 2, 8}) {
      for (int n = 0; n < 4; ++n) {
        random_lights(&random, count, mix);
        random_points(&random, c->exponent);
        illuminate_everywhere(*c);
        for (size_t i = 0; i < kBatch; ++i) check_point(i, *c);
      }
    }
  }
  print_message("  errors: diffuse %.2e, specular %.2e (2 + exponent)\n", g_diffuse, g_specular);
}

struct edge_case {
  const char* name;
  shd_light_kind kind;
  float light[3];  // position, or direction of travel
  float intensity;
  float p[3], n[3], o[3];
  double diffuse, specular;  // per unit of intensity; specular for exponent 64, gated
};
constexpr float kDiagonal = 0.70710678f;
const edge_case k_edges[] = {
    {"edge/straight_down", SHD_LIGHT_KIND_POINT, {0, 2, 0}, 8, {0, 0, 0}, {0, 1, 0}, {0, 1, 0}, 0.25, 0.25},
    {"edge/directional", SHD_LIGHT_KIND_DIRECTIONAL, {0, -3, 0}, 8, {9, 0, 0}, {0, 1, 0}, {0, 1, 0}, 1, 1},
    {"edge/light_at_the_point", SHD_LIGHT_KIND_POINT, {1, 2, 3}, 8, {1, 2, 3}, {0, 1, 0}, {0, 1, 0}, 0, 0},
    {"edge/light_1e-4_away", SHD_LIGHT_KIND_POINT, {0, 1e-4f, 0}, 8, {0, 0, 0}, {0, 1, 0}, {0, 1, 0}, 1e8, 1e8},
    {"edge/light_1e-6_away", SHD_LIGHT_KIND_POINT, {0, 1e-6f, 0}, 8, {0, 0, 0}, {0, 1, 0}, {0, 1, 0}, 1e8, 1e8},
    {"edge/light_1e-30_away", SHD_LIGHT_KIND_POINT, {0, 1e-30f, 0}, 8, {0, 0, 0}, {0, 1, 0}, {0, 1, 0}, 0, 0},
    {"edge/light_1e18_away", SHD_LIGHT_KIND_POINT, {0, 1e18f, 0}, 1e12f, {0, 0, 0}, {0, 1, 0}, {0, 1, 0}, 1e-36, 1e-36},
    {"edge/light_1e20_away", SHD_LIGHT_KIND_POINT, {0, 1e20f, 0}, 1e12f, {0, 0, 0}, {0, 1, 0}, {0, 1, 0}, 0, 0},
    {"edge/light_3e38_away",
     SHD_LIGHT_KIND_POINT,
     {3e38f, 3e38f, 3e38f},
     1e12f,
     {-3e38f, 0, 0},
     {0, 1, 0},
     {0, 1, 0},
     0,
     0},
    {"edge/zero_normal", SHD_LIGHT_KIND_POINT, {0, 2, 0}, 8, {0, 0, 0}, {0, 0, 0}, {0, 1, 0}, 0, 0},
    {"edge/zero_wo", SHD_LIGHT_KIND_POINT, {0, 2, 0}, 8, {0, 0, 0}, {0, 1, 0}, {0, 0, 0}, 0.25, 0.25},
    {"edge/eye_opposite_the_light", SHD_LIGHT_KIND_POINT, {0, 2, 0}, 8, {0, 0, 0}, {0, 1, 0}, {0, -1, 0}, 0.25, 0},
    {"edge/light_behind", SHD_LIGHT_KIND_POINT, {0, -2, 0}, 8, {0, 0, 0}, {0, 1, 0}, {0, 1, 0}, 0, 0},
    {"edge/grazing", SHD_LIGHT_KIND_DIRECTIONAL, {-1, 0, 0}, 8, {0, 0, 0}, {0, 1, 0}, {0, 1, 0}, 0, 0},
    {"edge/mirror",
     SHD_LIGHT_KIND_DIRECTIONAL,
     {1, -1, 0},
     8,
     {0, 0, 0},
     {0, 1, 0},
     {kDiagonal, kDiagonal, 0},
     0.70710678,
     1},
    {"edge/brightest", SHD_LIGHT_KIND_POINT, {0, 1e-5f, 0}, 1e12f, {0, 0, 0}, {0, 1, 0}, {0, 1, 0}, 1e8, 1e8},
};

void test_edge(void** state) {
  const auto* c = static_cast<const edge_case*>(*state);
  const model_case model = {"", SHD_MODEL_BLINN_PHONG, 0, 64.0f};
  set_material(model);
  g->lights.count = 1;
  g->lights.lights[0] =
      c->kind == SHD_LIGHT_KIND_POINT ? point_light(c->light, c->intensity) : directional_light(c->light, c->intensity);
  g->points.count = 67;
  for (size_t i = 0; i < 128; ++i) set_point(i, ref::vector(c->p), ref::vector(c->n), ref::vector(c->o));
  illuminate_everywhere(model);
  for (size_t i = 0; i < g->points.count; ++i) {
    const double intensity = double{c->intensity};
    shd_assert_close("diffuse", i, g->first.lobes.lobe[0][0][i], intensity * c->diffuse, 1e-30, 2e-6);
    shd_assert_close("specular", i, g->first.lobes.lobe[1][0][i], intensity * c->specular, 1e-30, 2e-5);
  }
}

/// The ungated and gated forms with the light behind the surface: only the ungated one has a specular term.
void test_gating(void**) {
  const float below[3] = {0.8f, -0.6f, 0.0f};  // direction upwards: n.l < 0, n.h > 0
  for (uint32_t flags : {0u, static_cast<uint32_t>(SHD_MATERIAL_SPECULAR_UNGATED)}) {
    const model_case model = {"", SHD_MODEL_BLINN_PHONG, flags, 2.0f};
    set_material(model);
    const float up[3] = {0.0f - below[0], 0.6f, 0.0f};
    g->lights.count = 1;
    g->lights.lights[0] = directional_light(up, 1.0f);
    g->points.count = 40;
    for (size_t i = 0; i < 64; ++i) set_point(i, {0, 0, 0}, {0, 1, 0}, {0, 1, 0});
    illuminate_everywhere(model);
    // l = (0.8, -0.6, 0), v + l = (0.8, 0.4, 0): (n.h)^2 = 0.16 / 0.8.
    for (size_t i = 0; i < 40; ++i) {
      assert_true(g->first.lobes.lobe[0][0][i] == 0.0f);
      shd_assert_close("specular", i, g->first.lobes.lobe[1][0][i], flags ? 0.2 : 0.0, 0.0, 2e-6);
    }
  }
}

/// Lights are added in the order of the table: 1e8 absorbs each later 3, but not the sum of earlier ones.
void test_order(void**) {
  const model_case model = {"", SHD_MODEL_BLINN_PHONG, 0, 1.0f};
  set_material(model);
  const float down[3] = {0, -1, 0};
  for (bool large_first : {true, false}) {
    g->lights.count = 8;
    for (size_t k = 0; k < 8; ++k)
      g->lights.lights[k] = directional_light(down, k == (large_first ? 0u : 7u) ? 1e8f : 3.0f);
    g->points.count = 64;
    for (size_t i = 0; i < 64; ++i) set_point(i, {0, 0, 0}, {0, 1, 0}, {0, 1, 0});
    illuminate_everywhere(model);
    const float want = large_first ? 1e8f : 1e8f + 21.0f;
    assert_true(g->first.lobes.lobe[0][0][0] == want);
    assert_true(g->first.lobes.lobe[1][0][63] == want);
  }
}

/// A row has the same bits in a table of any size; points past the last vector do not change.
void test_tails(void**) {
  const model_case model = {"", SHD_MODEL_BLINN_PHONG, 0, 64.0f};
  set_material(model);
  Random random = {53};
  random_lights(&random, 2, kBoth);
  random_points(&random, 64.0f);
  illuminate_everywhere(model);
  for_each_target([&](const core::SimdTarget& target, bool) {
    for (size_t count = 0; count <= 2 * 64 + 3; ++count) {
      g->points.count = count;
      std::fill_n(g->columns.lobes.lobe[0][0], 6 * kBatch, -77.0f);
      illuminate(target, &g->columns.lobes);
      for (int channel = 0; channel < 3; ++channel) {
        assert_memory_equal(g->columns.lobes.lobe[0][channel], g->first.lobes.lobe[0][channel], count * sizeof(float));
        assert_memory_equal(g->columns.lobes.lobe[1][channel], g->first.lobes.lobe[1][channel], count * sizeof(float));
        for (size_t i = data::padded(count); i < kBatch; ++i) {
          assert_true(g->columns.lobes.lobe[0][channel][i] == -77.0f);
          assert_true(g->columns.lobes.lobe[1][channel][i] == -77.0f);
        }
      }
    }
  });
}

/// Finite points of any magnitude, with lights in and beyond range, give finite lobes.
void test_finite(void** state) {
  const auto* c = static_cast<const model_case*>(*state);
  set_material(*c);
  Random random = {57};
  for (int n = 0; n < 40; ++n) {
    g->lights.count = 8;
    for (size_t k = 0; k < 8; ++k) {
      const float at[3] = {random.scaled(-149, 127.9), random.scaled(-149, 127.9), random.scaled(-149, 127.9)};
      g->lights.lights[k] = k % 2 ? point_light(at, 6e11f) : directional_light(at, 6e11f);
    }
    g->points.count = kBatch;
    for (size_t i = 0; i < kBatch; ++i) {
      const bool on_light = i % 16 == 3;
      const float* at = g->lights.lights[i % 8].position;
      const Vector anywhere = {random.scaled(-149, 127.9), random.scaled(-149, 127.9), random.scaled(-149, 127.9)};
      set_point(i, on_light ? ref::vector(at) : anywhere, random_unit(&random),
                i % 5 ? random_unit(&random) : Vector{0, 0, 0});
    }
    illuminate_everywhere(*c);
    for (size_t i = 0; i < kBatch; ++i) {
      for (int channel = 0; channel < 3; ++channel) {
        const float d = g->first.lobes.lobe[0][channel][i];
        const float s = c->model == SHD_MODEL_BLINN_PHONG ? g->first.lobes.lobe[1][channel][i] : 0.0f;
        if (!std::isfinite(d) || !std::isfinite(s) || d < 0.0f || s < 0.0f)
          fail_msg("row %zu: %g %g", i, double{d}, double{s});
      }
    }
  }
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  constexpr size_t kModels = sizeof k_models / sizeof k_models[0];
  static char names[2 * kModels][64];
  CMUnitTest tests[64];
  size_t n = 0;
  for (size_t i = 0; i < kModels; ++i) {
    void* model = const_cast<model_case*>(&k_models[i]);
    snprintf(names[2 * i], sizeof names[0], "oracle/%s", k_models[i].name);
    snprintf(names[2 * i + 1], sizeof names[0], "finite/%s", k_models[i].name);
    tests[n++] = {names[2 * i], test_model, nullptr, nullptr, model};
    tests[n++] = {names[2 * i + 1], test_finite, nullptr, nullptr, model};
  }
  for (const edge_case& c : k_edges) tests[n++] = {c.name, test_edge, nullptr, nullptr, const_cast<edge_case*>(&c)};
  tests[n++] = {"gating", test_gating, nullptr, nullptr, nullptr};
  tests[n++] = {"order", test_order, nullptr, nullptr, nullptr};
  tests[n++] = {"tails", test_tails, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.shade.illuminate", tests, n, set_up, tear_down);
}
