// SPDX-License-Identifier: MIT
// Lobes of every model with lights in groups, at the limits of the formulas, and with non-finite input.
#include "unit/shade/lobe_fixture.h"

namespace shd::tests {
namespace {

const ModelCase k_models[] = {
    {"lambert", SHD_MODEL_LAMBERT, 0, 64, 0.5f},
    {"gooch", SHD_MODEL_GOOCH, 0, 64, 0.5f},
    {"phong", SHD_MODEL_PHONG, 0, 64, 0.5f},
    {"phong/ungated", SHD_MODEL_PHONG, SHD_MATERIAL_SPECULAR_UNGATED, 64, 0.5f},
    {"blinn_phong", SHD_MODEL_BLINN_PHONG, 0, 64, 0.5f},
    {"blinn_phong/ungated", SHD_MODEL_BLINN_PHONG, SHD_MATERIAL_SPECULAR_UNGATED, 64, 0.5f},
    {"blinn_phong/p=0", SHD_MODEL_BLINN_PHONG, 0, 0, 0.5f},
    {"combined", SHD_MODEL_COMBINED, 0, 64, 0.5f},
    {"normalized", SHD_MODEL_BLINN_PHONG_NORMALIZED, 0, 64, 0.5f},
    {"toon", SHD_MODEL_TOON, 0, 64, 0.5f},
    {"metallic_roughness", SHD_MODEL_METALLIC_ROUGHNESS, 0, 64, 0.3f},
    {"mirror", SHD_MODEL_METALLIC_ROUGHNESS, 0, 64, 0},
};

uint32_t lobe_count() {
  return material::info_of(g->material.model).lobes;
}

void random_columns(Random* random) {
  for (size_t i = 0; i < kBatch; ++i) {
    g->exponent[i] = random->real(0.0, 200.0);
    g->alpha_squared[i] = random->real(0.01, 1.0);
    g->gain[i] = random->real(0.0, 1.0);
    for (size_t k = 0; k < kMaxLights; ++k) {
      for (int c = 0; c < 3; ++c) g->factor[k][c][i] = random->real(0.0, 2.0);
    }
  }
  set_shape(true, true);
  for (size_t k = 0; k < g->count; k += 3)
    g->active[k] = {&g->light[k], {g->factor[k][0], g->factor[k][1], g->factor[k][2]}};
}

/// Lights one by one, in threes, and with empty groups give the bits of a single call.
void test_groups(void** state) {
  const auto* c = static_cast<const ModelCase*>(*state);
  Random random = {83};
  set_material(*c);
  random_lights(&random, 10, kMixed);
  random_points(&random, 64.0);
  random_columns(&random);
  illuminate_everywhere();
  for_each_target([&](const core::SimdTarget& target, bool) {
    for (size_t step : {size_t{1}, size_t{3}, size_t{10}}) {
      shade::LightGroup group = {false, false};
      shade::illuminate(target, g->material, g->shape, g->active, 0, g->points, group, &g->columns.lobes);
      group.continues = true;
      for (size_t k = 0; k < g->count; k += step) {
        const size_t count = std::min(step, g->count - k);
        shade::illuminate(target, g->material, g->shape, g->active + k, count, g->points, group, &g->columns.lobes);
      }
      group.finishes = true;
      shade::illuminate(target, g->material, g->shape, g->active, 0, g->points, group, &g->columns.lobes);
      for (uint32_t k = 0; k < 3 * lobe_count(); ++k) {
        assert_memory_equal(g->columns.lobes.lobe[k / 3][k % 3], g->first.lobes.lobe[k / 3][k % 3],
                            kBatch * sizeof(float));
      }
    }
  });
}

/// A row has the same bits in a table of any size; points past the last vector do not change.
void test_tails(void** state) {
  const auto* c = static_cast<const ModelCase*>(*state);
  Random random = {84};
  set_material(*c);
  random_lights(&random, 3, kMixed);
  random_points(&random, 64.0);
  random_columns(&random);
  illuminate_everywhere();
  for_each_target([&](const core::SimdTarget& target, bool) {
    for (size_t count = 0; count <= 2 * 64 + 3; ++count) {
      g->points.count = count;
      for (uint32_t k = 0; k < 9; ++k) std::fill_n(g->columns.lobes.lobe[k / 3][k % 3], kBatch, -77.0f);
      shade::illuminate(target, g->material, g->shape, g->active, g->count, g->points, {false, true},
                        &g->columns.lobes);
      for (uint32_t k = 0; k < 9; ++k) {
        const float* got = g->columns.lobes.lobe[k / 3][k % 3];
        const size_t points = k / 3 < lobe_count() ? count : 0;
        assert_memory_equal(got, g->first.lobes.lobe[k / 3][k % 3], points * sizeof(float));
        for (size_t i = points ? data::padded(count) : 0; i < kBatch; ++i) assert_true(got[i] == -77.0f);
      }
    }
  });
}

struct EdgeCase {
  const char* name;
  float p[3], n[3], o[3];
  float light;  // height of the light above the origin, on the y axis
};
const EdgeCase k_edges[] = {
    {"r=0", {0, 2, 0}, {0, 1, 0}, {0, 1, 0}, 2},
    {"r=1e-6", {0, 0, 0}, {0, 1, 0}, {0, 1, 0}, 1e-6f},
    {"wo+l=0", {0, 0, 0}, {0, 1, 0}, {0, -1, 0}, 2},
    {"zero_normal", {0, 0, 0}, {0, 0, 0}, {0, 1, 0}, 2},
    {"zero_wo", {0, 0, 0}, {0, 1, 0}, {0, 0, 0}, 2},
    {"n.v=0", {0, 0, 0}, {0, 1, 0}, {1, 0, 0}, 2},
    {"n.v<0", {0, 0, 0}, {0, 1, 0}, {0.8f, -0.6f, 0}, 2},
    {"straight", {0, 0, 0}, {0, 1, 0}, {0, 1, 0}, 2},
    {"grazing", {1e4f, 0, 0}, {0, 1, 0}, {0.70710678f, 0.70710678f, 0}, 2},
    {"behind", {0, 0, 0}, {0, 1, 0}, {0, 1, 0}, -2},
};

/// Every model at the limits, under a point light and a spot that points down.
void test_edges(void** state) {
  const auto* c = static_cast<const ModelCase*>(*state);
  for (const EdgeCase& e : k_edges) {
    for (shd_light_kind kind : {SHD_LIGHT_KIND_POINT, SHD_LIGHT_KIND_SPOT}) {
      set_material(*c);
      shd_light_desc desc = shd_light_desc_default();
      desc.kind = kind;
      desc.position[1] = e.light;
      desc.intensity[1] = 1e12f;
      g->count = 1;
      set_light(0, desc);
      g->points.count = 67;
      for (size_t i = 0; i < 128; ++i) set_point(i, ref::vector(e.p), ref::vector(e.n), ref::vector(e.o));
      illuminate_everywhere();
      check_lobes();
    }
  }
}

/// A light opposite to the eye has no half vector: the specular lobes of its point are exactly 0, and other points keep
/// the bits that they have without it.
void test_opposite(void** state) {
  const auto* c = static_cast<const ModelCase*>(*state);
  Random random = {86};
  set_material(*c);
  if (lobe_count() < 2 || c->model == SHD_MODEL_PHONG) return;  // no half vector
  random_lights(&random, 1, kDirections);
  random_points(&random, 64.0);
  illuminate_everywhere();
  float kept[9][kBatch];
  for (uint32_t k = 0; k < 3 * lobe_count(); ++k) memcpy(kept[k], g->first.lobes.lobe[k / 3][k % 3], sizeof kept[k]);
  const float* l = g->light[0].to_light;
  for (size_t i = 5; i < kBatch; i += 17) {
    g->points.ox[i] = -l[0], g->points.oy[i] = -l[1], g->points.oz[i] = -l[2];
    g->points.nx[i] = l[0], g->points.ny[i] = l[1], g->points.nz[i] = l[2];
  }
  illuminate_everywhere();
  for (uint32_t k = 0; k < 3 * lobe_count(); ++k) {
    for (size_t i = 0; i < kBatch; ++i) {
      const float got = g->first.lobes.lobe[k / 3][k % 3][i];
      if (i % 17 != 5) assert_true(got == kept[k][i]);
      if (i % 17 == 5 && k >= 3) assert_true(got == 0.0f);
    }
  }
}

/// Rows with a non-finite normal, position or direction, and non-finite cookie texels: other points keep the bits that
/// they have alone, and unlit points stay 0.
void test_nonfinite(void** state) {
  const auto* c = static_cast<const ModelCase*>(*state);
  if (c->model == SHD_MODEL_GOOCH) return;  // reads neither E nor texels
  const float bad[] = {NAN, INFINITY, -INFINITY};
  Random random = {85};
  set_material(*c);
  random_lights(&random, 4, kMixed);
  random_points(&random, 64.0);
  for (size_t k = 0; k < 4; ++k) {
    if (k % 2) continue;
    for (int channel = 0; channel < 3; ++channel) std::fill_n(g->factor[k][channel], kBatch, 1.0f);
    g->active[k] = {&g->light[k], {g->factor[k][0], g->factor[k][1], g->factor[k][2]}};
  }
  illuminate_everywhere();
  float kept[9][kBatch];
  for (uint32_t k = 0; k < 3 * lobe_count(); ++k) memcpy(kept[k], g->first.lobes.lobe[k / 3][k % 3], sizeof kept[k]);
  for (size_t i = 0; i < kBatch; ++i) {
    const float value = bad[i / 8 % 3];
    if (i % 8 == 1) g->points.px[i] = value;
    if (i % 8 == 3) g->points.ny[i] = value;
    if (i % 8 == 5) g->points.oz[i] = value;
    if (i % 8 == 7) {
      for (size_t k = 0; k < 4; ++k) std::fill_n(&g->factor[k][0][i], 1, value);
    }
  }
  illuminate_everywhere();
  for (size_t i = 0; i < kBatch; ++i) {
    for (uint32_t k = 0; k < 3 * lobe_count(); ++k) {
      const float got = g->first.lobes.lobe[k / 3][k % 3][i];
      if (i % 2 == 0 || (i % 8 == 7 && k % 3)) assert_true(got == kept[k][i]);
      if (i % 8 == 7 && kept[k][i] == 0.0f) assert_true(got == 0.0f);
    }
  }
}

struct ConeCase {
  const char* name;
  float inner, outer;
  double angle, want;
};
constexpr float kQuarter = 0.785398163f;
const ConeCase k_cones[] = {
    {"axis", 0, kQuarter, 0, 1},
    {"inside_inner", 0.5f, kQuarter, 0.4, 1},
    {"between/quarter", 0.5f, kQuarter, 0.72314883, 0.15625},
    {"between/middle", 0.5f, kQuarter, 0.65615362, 0.5},
    {"between/three_quarters", 0.5f, kQuarter, 0.58272967, 0.84375},
    {"outside", 0.5f, kQuarter, 0.8, 0},
    {"hard/inside", kQuarter, kQuarter, 0.78, 1},
    {"hard/outside", kQuarter, kQuarter, 0.79, 0},
    {"narrowest/axis", 0, 0.001f, 0, 1},
    {"narrowest/outside", 0, 0.001f, 0.0012, 0},
    {"narrowest/hard/axis", 0.001f, 0.001f, 0, 1},
    {"widest/hard/inside", 1.57079633f, 1.57079633f, 1.56, 1},
    {"widest/hard/outside", 1.57079633f, 1.57079633f, 1.58, 0},
};

/// E of a spot over its angle.
void test_cone(void** state) {
  const auto* c = static_cast<const ConeCase*>(*state);
  set_material({"", SHD_MODEL_LAMBERT, 0, 1, 0.5f});
  shd_light_desc desc = shd_light_desc_default();
  desc.kind = SHD_LIGHT_KIND_SPOT;
  desc.inner_angle = c->inner;
  desc.outer_angle = c->outer;
  g->count = 1;
  set_light(0, desc);
  g->points.count = 5;
  const Vector l = {sin(c->angle), -cos(c->angle), 0};
  for (size_t i = 0; i < 64; ++i) set_point(i, 1.0L * l, -1.0L * l, {0, 1, 0});
  illuminate_everywhere();
  shd_assert_close(c->name, 0, g->first.lobes.lobe[0][0][0], c->want, 1e-6, 0.0);
}

/// E is exactly 0 from the range on.
void test_range(void**) {
  set_material({"", SHD_MODEL_LAMBERT, 0, 1, 0.5f});
  shd_light_desc desc = shd_light_desc_default();
  desc.range = 2.0f;
  g->count = 1;
  set_light(0, desc);
  g->points.count = kBatch;
  for (size_t i = 0; i < kBatch; ++i) {
    const double r = 1.9 + 0.2 * static_cast<double>(i) / (kBatch - 1);
    set_point(i, {0, -r, 0}, {0, 1, 0}, {0, 1, 0});
  }
  illuminate_everywhere();
  for (size_t i = 0; i < kBatch; ++i) {
    const double r = -double{g->points.py[i]}, part = std::max(0.0, 1.0 - std::pow(r / 2.0, 4.0));
    shd_assert_close("E", i, g->first.lobes.lobe[0][0][i], part / (r * r), 1e-6, 0.0);
    if (r > 2.0) assert_true(g->first.lobes.lobe[0][0][i] == 0.0f);
  }
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  constexpr size_t kModels = sizeof k_models / sizeof k_models[0];
  static char names[5 * kModels][64];
  CMUnitTest tests[96];
  size_t n = 0;
  for (const ModelCase& c : k_models) {
    const struct {
      const char* name;
      CMUnitTestFunction body;
    } bodies[] = {{"groups", test_groups},
                  {"tails", test_tails},
                  {"edges", test_edges},
                  {"opposite", test_opposite},
                  {"nonfinite", test_nonfinite}};
    for (const auto& body : bodies) {
      snprintf(names[n], sizeof names[0], "%s/%s", body.name, c.name);
      tests[n] = {names[n], body.body, nullptr, nullptr, const_cast<ModelCase*>(&c)};
      ++n;
    }
  }
  for (const ConeCase& c : k_cones) tests[n++] = {c.name, test_cone, nullptr, nullptr, const_cast<ConeCase*>(&c)};
  tests[n++] = {"range", test_range, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.shade.lobe_edges", tests, n, set_up, tear_down);
}
