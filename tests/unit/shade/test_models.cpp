// SPDX-License-Identifier: MIT
// Lobes of every model under every kind of light against the formulas in long double, on every target.
#include "unit/shade/lobe_fixture.h"

namespace shd::tests {
namespace {

const ModelCase k_models[] = {
    {"lambert", SHD_MODEL_LAMBERT, 0, 64, 0.5f},
    {"gooch", SHD_MODEL_GOOCH, 0, 64, 0.5f},
    {"phong/0", SHD_MODEL_PHONG, 0, 0, 0.5f},
    {"phong/1", SHD_MODEL_PHONG, 0, 1, 0.5f},
    {"phong/64", SHD_MODEL_PHONG, 0, 64, 0.5f},
    {"phong/1e4", SHD_MODEL_PHONG, 0, 1e4f, 0.5f},
    {"phong/1e6", SHD_MODEL_PHONG, 0, 1e6f, 0.5f},
    {"phong/ungated/64", SHD_MODEL_PHONG, SHD_MATERIAL_SPECULAR_UNGATED, 64, 0.5f},
    {"blinn_phong/0", SHD_MODEL_BLINN_PHONG, 0, 0, 0.5f},
    {"blinn_phong/64", SHD_MODEL_BLINN_PHONG, 0, 64, 0.5f},
    {"blinn_phong/1e6", SHD_MODEL_BLINN_PHONG, 0, 1e6f, 0.5f},
    {"blinn_phong/ungated/64", SHD_MODEL_BLINN_PHONG, SHD_MATERIAL_SPECULAR_UNGATED, 64, 0.5f},
    {"combined/64", SHD_MODEL_COMBINED, 0, 64, 0.5f},
    {"normalized/0", SHD_MODEL_BLINN_PHONG_NORMALIZED, 0, 0, 0.5f},
    {"normalized/1", SHD_MODEL_BLINN_PHONG_NORMALIZED, 0, 1, 0.5f},
    {"normalized/64", SHD_MODEL_BLINN_PHONG_NORMALIZED, 0, 64, 0.5f},
    {"normalized/1e4", SHD_MODEL_BLINN_PHONG_NORMALIZED, 0, 1e4f, 0.5f},
    {"normalized/1e6", SHD_MODEL_BLINN_PHONG_NORMALIZED, 0, 1e6f, 0.5f},
    {"normalized/ungated/64", SHD_MODEL_BLINN_PHONG_NORMALIZED, SHD_MATERIAL_SPECULAR_UNGATED, 64, 0.5f},
    {"toon/0", SHD_MODEL_TOON, 0, 0, 0.5f},
    {"toon/64", SHD_MODEL_TOON, 0, 64, 0.5f},
    {"toon/1e4", SHD_MODEL_TOON, 0, 1e4f, 0.5f},
    {"toon/ungated/64", SHD_MODEL_TOON, SHD_MATERIAL_SPECULAR_UNGATED, 64, 0.5f},
    {"metallic_roughness/0", SHD_MODEL_METALLIC_ROUGHNESS, 0, 64, 0},
    {"metallic_roughness/0.03", SHD_MODEL_METALLIC_ROUGHNESS, 0, 64, 0.03f},
    {"metallic_roughness/0.3", SHD_MODEL_METALLIC_ROUGHNESS, 0, 64, 0.3f},
    {"metallic_roughness/1", SHD_MODEL_METALLIC_ROUGHNESS, 0, 64, 1},
};

double sharpness(const ModelCase& c) {
  const double alpha = std::max(double{c.roughness} * double{c.roughness}, 1e-3);
  return c.model == SHD_MODEL_METALLIC_ROUGHNESS ? 2.0 / (alpha * alpha) : double{c.exponent};
}

void test_model(void** state) {
  const auto* c = static_cast<const ModelCase*>(*state);
  Random random = {81};
  std::fill_n(g_used, 3, 0.0);
  for (int mix = 0; mix < kMixCount; ++mix) {
    for (size_t count : {size_t{1}, size_t{6}}) {
      set_material(*c);
      random_lights(&random, count, static_cast<LightMix>(mix));
      random_points(&random, sharpness(*c));
      illuminate_everywhere();
      assert_in_range(check_lobes(), kBatch / 3, kBatch);
    }
  }
  print_message("  of the bounds: %.2f, %.2f, %.2f\n", g_used[0], g_used[1], g_used[2]);
}

/// Columns that replace the constants, and lights with the factors of a cookie.
void test_columns(void** state) {
  const auto* c = static_cast<const ModelCase*>(*state);
  Random random = {82};
  for (int n = 0; n < 4; ++n) {
    set_material(*c);
    random_lights(&random, 6, kMixed);
    random_points(&random, 30.0);
    for (size_t i = 0; i < kBatch; ++i) {
      g->exponent[i] = i % 7 ? random.real(0.0, 200.0) : 0.0f;
      g->alpha_squared[i] = i % 7 ? random.real(0.01, 1.0) : 1.0f;
      g->gain[i] = random.real(0.0, 1.0);
      for (size_t k = 0; k < 6; ++k) {
        for (int channel = 0; channel < 3; ++channel) g->factor[k][channel][i] = i % 5 ? random.real(0.0, 2.0) : 0.0f;
      }
    }
    set_shape(n & 1, n & 2);
    for (size_t k = 0; k < 6; k += 2)
      g->active[k] = {&g->light[k], {g->factor[k][0], g->factor[k][1], g->factor[k][2]}};
    illuminate_everywhere();
    check_lobes();
  }
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  constexpr size_t kModels = sizeof k_models / sizeof k_models[0];
  static char names[2 * kModels][64];
  CMUnitTest tests[2 * kModels];
  size_t n = 0;
  for (const ModelCase& c : k_models) {
    snprintf(names[n], sizeof names[0], "formula/%s", c.name);
    tests[n] = {names[n], test_model, nullptr, nullptr, const_cast<ModelCase*>(&c)};
    ++n;
    snprintf(names[n], sizeof names[0], "columns/%s", c.name);
    tests[n] = {names[n], test_columns, nullptr, nullptr, const_cast<ModelCase*>(&c)};
    ++n;
  }
  return _cmocka_run_group_tests("unit.shade.models", tests, n, set_up, tear_down);
}
