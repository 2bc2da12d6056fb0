// SPDX-License-Identifier: MIT
// The table of the models: every value of shd_model has a row, with the traits that other stages rely on.
#include "support/check.h"

#include "material/material.h"
#include "raster/interpolate.h"

namespace {

using namespace shd;

struct ModelCase {
  const char* name;
  material::ModelKey model;
  uint32_t lobes;
  int shape_slot;  // negative = none
  bool needs_eye, has_normal, ignores_irradiance, has_ambient, colors_ambient;
  uint32_t shown_columns;
};
const ModelCase k_models[] = {
    {"lambert", material::key_of(SHD_MODEL_LAMBERT), 1, -1, false, true, false, true, false, 0},
    {"blinn_phong", material::key_of(SHD_MODEL_BLINN_PHONG), 2, SHD_SLOT_EXPONENT, true, true, false, true, false, 0},
    {"unlit", material::key_of(SHD_MODEL_UNLIT), 0, -1, false, false, false, false, false, 0},
    {"phong", material::key_of(SHD_MODEL_PHONG), 2, SHD_SLOT_EXPONENT, true, true, false, true, false, 0},
    {"normalized", material::key_of(SHD_MODEL_BLINN_PHONG_NORMALIZED), 2, SHD_SLOT_EXPONENT, true, true, false, true,
     false, 0},
    {"combined", material::key_of(SHD_MODEL_COMBINED), 2, SHD_SLOT_EXPONENT, true, true, false, false, true, 0},
    {"gooch", material::key_of(SHD_MODEL_GOOCH), 1, -1, false, true, true, false, false, 0},
    {"toon", material::key_of(SHD_MODEL_TOON), 2, SHD_SLOT_EXPONENT, true, true, false, true, false, 0},
    {"metallic_roughness", material::key_of(SHD_MODEL_METALLIC_ROUGHNESS), 3, SHD_SLOT_ROUGHNESS, true, true, false,
     true, true, 0},
    {"glass", material::key_of(SHD_MODEL_GLASS), 2, SHD_SLOT_ROUGHNESS, true, true, false, true, false, 0},
    {"matcap", material::key_of(SHD_MODEL_MATCAP), 0, -1, false, true, false, false, false, 0},
    {"show_normal", material::key_of(SHD_DEBUG_VIEW_NORMAL), 0, -1, false, true, false, false, false, 0},
    {"show_uv", material::key_of(SHD_DEBUG_VIEW_UV), 0, -1, false, false, false, false, false, raster::kTexture},
    {"show_level", material::key_of(SHD_DEBUG_VIEW_LEVEL), 0, -1, false, false, false, false, false, raster::kTexture},
    {"show_barycentrics", material::key_of(SHD_DEBUG_VIEW_BARYCENTRICS), 0, -1, false, false, false, false, false,
     raster::kBarycentrics},
};

void test_row(void** state) {
  const auto* c = static_cast<const ModelCase*>(*state);
  const material::ModelInfo& info = material::info_of(c->model);
  assert_int_equal(info.lobes, c->lobes);
  assert_int_equal(info.shape_slots, c->shape_slot < 0 ? 0u : 1u << c->shape_slot);
  assert_int_equal(info.shape_slots & ~info.slots, 0);
  assert_int_equal(info.needs_eye, c->needs_eye);
  assert_int_equal(info.has_normal, c->has_normal);
  assert_int_equal(info.slots >> SHD_SLOT_NORMAL & 1, c->has_normal);
  assert_int_equal(info.ignores_irradiance, c->ignores_irradiance);
  assert_int_equal(info.slots >> SHD_SLOT_AMBIENT & 1, c->has_ambient);
  assert_int_equal(info.colors_ambient, c->colors_ambient);
  assert_int_equal(info.shown_columns, c->shown_columns);
}

/// Every model and view reads the diffuse slot; programs have no row. A view is shown in place of any model.
void test_all(void**) {
  assert_int_equal(material::last_model(), SHD_MODEL_GLASS);
  for (int model = 0; model <= SHD_MODEL_GLASS; ++model) {
    const auto key = material::key_of(static_cast<shd_model>(model));
    assert_int_equal(material::info_of(key).slots >> SHD_SLOT_DIFFUSE & 1, model != SHD_MODEL_PROGRAM);
    assert_true(material::model_key(static_cast<shd_model>(model), SHD_DEBUG_VIEW_NONE) == key);
  }
  for (int view = SHD_DEBUG_VIEW_NORMAL; view <= SHD_DEBUG_VIEW_BARYCENTRICS; ++view) {
    const auto key = material::key_of(static_cast<shd_debug_view>(view));
    assert_true(material::info_of(key).slots >> SHD_SLOT_DIFFUSE & 1);
    assert_true(material::model_key(SHD_MODEL_PROGRAM, static_cast<shd_debug_view>(view)) == key);
  }
  const material::ModelInfo& coat = material::info_of(material::ModelKey::kClearCoat);
  assert_int_equal(coat.lobes, 4);
  assert_int_equal(coat.shape_slots,
                   1u << SHD_SLOT_ROUGHNESS | 1u << SHD_SLOT_CLEARCOAT | 1u << SHD_SLOT_CLEARCOAT_ROUGHNESS);
  assert_int_equal(coat.slots & coat.shape_slots, coat.shape_slots);
}

}  // namespace

int main() {
  constexpr size_t kModels = sizeof k_models / sizeof k_models[0];
  CMUnitTest tests[kModels + 1];
  size_t n = 0;
  for (const ModelCase& c : k_models) tests[n++] = {c.name, test_row, nullptr, nullptr, const_cast<ModelCase*>(&c)};
  tests[n++] = {"all", test_all, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.material.model_table", tests, n, nullptr, nullptr);
}
