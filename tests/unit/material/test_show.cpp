// SPDX-License-Identifier: MIT
// Colours of unlit models against their formulas.
#include "unit/shade/slot_fixture.h"

#include "ref/shade_ref.h"

namespace shd::tests {
namespace {

constexpr uint32_t kWidth = 64;

/// Sets a material of a model or view, with a texture in a slot; null = no texture.
void set_slot(shd_model model, shd_debug_view view, shd_slot_target target, texture::Texture* texture) {
  shd_material_desc desc = shd_material_desc_default();
  desc.model = model;
  desc.debug_view = view;
  material::SlotInput slots[material::kSlotCount] = {};
  if (texture) slots[target] = {shd_slot_texture(target, nullptr, nullptr), 0, texture, &g->sampler, nullptr};
  material::build(desc, slots, &g->material);
}

void show(const core::SimdTarget& target, const shd_view& view = {}) {
  constexpr float kIdentity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  material::show({target, g->material, view, g->points, kIdentity, g->columns.uv}, g->columns.lobes.lobe[0]);
}

void test_normals(void**) {
  Random random = {171};
  g->points.count = 131;
  for (float* column : {g->points.nx, g->points.ny, g->points.nz}) {
    for (size_t i = 0; i < kBatch; ++i) column[i] = random.real(-1.0, 1.0);
  }
  float* const* out = g->columns.lobes.lobe[0];
  for (int c = 0; c < 3; ++c) std::fill_n(out[c], kBatch, -77.0f);
  set_slot(SHD_MODEL_PHONG, SHD_DEBUG_VIEW_NORMAL, SHD_SLOT_DIFFUSE, nullptr);
  show(best_target());
  const float* const n[3] = {g->points.nx, g->points.ny, g->points.nz};
  for (int c = 0; c < 3; ++c) {
    for (size_t i = 0; i < 131; ++i) shd_assert_close("normal", i, out[c][i], 0.5 + 0.5 * n[c][i], 6e-8, 0.0);
    for (size_t i = 131; i < kBatch; ++i) assert_true(out[c][i] == -77.0f);
  }
}

void test_uv(void**) {
  const float u[] = {0.25f, -0.25f, 1.0f, 3.5f, -1e-9f, 1e9f, -2.0f};
  const double want[] = {0.25, 0.75, 0, 0.5, 1.0, 0, 0};
  g->points.count = 7;
  for (size_t i = 0; i < 7; ++i) g->points.u[i] = u[i], g->points.v[i] = u[6 - i];
  set_slot(SHD_MODEL_PHONG, SHD_DEBUG_VIEW_UV, SHD_SLOT_DIFFUSE, nullptr);
  show(best_target());
  for (size_t i = 0; i < 7; ++i) {
    shd_assert_close("u", i, g->columns.lobes.lobe[0][0][i], want[i], 0.0, 0.0);
    shd_assert_close("v", i, g->columns.lobes.lobe[0][1][i], want[6 - i], 0.0, 0.0);
    assert_true(g->columns.lobes.lobe[0][2][i] == 0.0f);
  }
}

void test_barycentrics(void**) {
  Random random = {172};
  g->points.count = 65;
  for (float* column : g->points.bary) {
    for (size_t i = 0; i < kBatch; ++i) column[i] = random.real(0.0, 1.0);
  }
  set_slot(SHD_MODEL_PHONG, SHD_DEBUG_VIEW_BARYCENTRICS, SHD_SLOT_DIFFUSE, nullptr);
  show(best_target());
  for (int c = 0; c < 3; ++c) assert_memory_equal(g->columns.lobes.lobe[0][c], g->points.bary[c], 65 * sizeof(float));
}

/// The colour runs from blue over green to red with the level of detail; blue without a texture.
void test_levels(void**) {
  static const uint8_t texels[kWidth * kWidth] = {};
  texture::Texture* mipped = make_texture(SHD_FORMAT_R8, kWidth, kWidth, texels, SHD_TABLE_MIPMAP);
  texture::Texture* plain = make_texture(SHD_FORMAT_R8, kWidth, kWidth, texels);
  texture::Texture* const textures[] = {mipped, plain, nullptr};
  g->sampler = make_sampler(SHD_FILTER_TRILINEAR, SHD_WRAP_REPEAT);
  g->sampler.profile = SHD_PROFILE_EXACT;
  g->points.count = kBatch;
  for (size_t i = 0; i < kBatch; ++i) {
    const float step = static_cast<float>(std::exp2(-9.0 + 12.0 * static_cast<double>(i) / kBatch));
    g->points.u[i] = g->points.v[i] = 0.5f;
    g->points.dudx[i] = g->points.dvdy[i] = step;
    g->points.dudy[i] = g->points.dvdx[i] = 0.0f;
  }
  for (texture::Texture* texture : textures) {
    set_slot(SHD_MODEL_PHONG, SHD_DEBUG_VIEW_LEVEL, SHD_SLOT_DIFFUSE, texture);
    for_each_target([&](const core::SimdTarget& target, bool) {
      show(target);
      for (size_t i = 0; i < kBatch; ++i) {
        const double lod = log2(double{g->points.dudx[i]} * kWidth);
        const double part = texture == mipped ? std::min(std::max(lod / 6.0, 0.0), 1.0) : 0.0;
        float* const* out = g->columns.lobes.lobe[0];
        shd_assert_close("red", i, out[0][i], std::max(2.0 * part - 1.0, 0.0), 2e-6, 0.0);
        shd_assert_close("green", i, out[1][i], 1.0 - fabs(2.0 * part - 1.0), 2e-6, 0.0);
        shd_assert_close("blue", i, out[2][i], std::max(1.0 - 2.0 * part, 0.0), 2e-6, 0.0);
      }
    });
  }
  free_texture(mipped);
  free_texture(plain);
}

/// The texel at (1/2 + x/2, 1/2 - y/2) of the unit normal in view space, for normals of any length; 1 without a
/// texture.
void test_matcap(void**) {
  static float texels[kWidth * kWidth * 4];
  for (size_t i = 0; i < size_t{kWidth} * kWidth; ++i) {
    texels[4 * i] = (static_cast<float>(i % kWidth) + 0.5f) / kWidth;
    texels[4 * i + 1] = (static_cast<float>(i / kWidth) + 0.5f) / kWidth;
  }
  texture::Texture* texture = make_texture(SHD_FORMAT_RGBA32F, kWidth, kWidth, texels);
  g->sampler = make_sampler(SHD_FILTER_BILINEAR, SHD_WRAP_CLAMP);
  shd_view view = {};
  const float turned[16] = {0.36f, 0.48f, -0.8f, 0, -0.8f, 0.6f, 0, 0, 0.48f, 0.64f, 0.6f, 0, 7, 8, 9, 1};
  memcpy(view.world_to_view, turned, sizeof turned);
  Random random = {173};
  g->points.count = kBatch;
  for (size_t i = 0; i < kBatch; ++i) {
    const double size = std::exp2(random.in(-20.0, 20.0));
    for (float* column : {g->points.nx, g->points.ny, g->points.nz}) {
      column[i] = i % 16 ? static_cast<float>(size * random.in(-1.0, 1.0)) : i % 32 ? NAN : 0.0f;
    }
  }
  for (bool has_texture : {true, false}) {
    set_slot(SHD_MODEL_MATCAP, SHD_DEBUG_VIEW_NONE, SHD_SLOT_MATCAP, has_texture ? texture : nullptr);
    for_each_target([&](const core::SimdTarget& target, bool) {
      show(target, view);
      for (size_t i = 0; i < kBatch; ++i) {
        float* const* out = g->columns.lobes.lobe[0];
        const float v[3] = {g->points.nx[i], g->points.ny[i], g->points.nz[i]};
        const ref::Vector n = ref::unit(ref::vector(v));
        const long double x = n.x * turned[0] + n.y * turned[4] + n.z * turned[8];
        const long double y = n.x * turned[1] + n.y * turned[5] + n.z * turned[9];
        const auto place = [&](long double at) {
          return std::min(std::max(static_cast<double>(0.5L + at / 2), 0.5 / kWidth), 1.0 - 0.5 / kWidth);
        };
        const bool odd = i % 16 == 0;
        if (odd && has_texture) {  // no direction: the middle of the texture
          for (size_t c = 0; c < 2; ++c) shd_assert_close("no_direction", i, out[c][i], 0.5, 1e-4, 0.0);
          continue;
        }
        shd_assert_close("u", i, out[0][i], has_texture ? place(x) : 1.0, 1e-4, 0.0);
        shd_assert_close("v", i, out[1][i], has_texture ? place(-y) : 1.0, 1e-4, 0.0);
      }
    });
  }
  free_texture(texture);
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  const CMUnitTest tests[] = {
      {"normals", test_normals, nullptr, nullptr, nullptr},
      {"uv", test_uv, nullptr, nullptr, nullptr},
      {"barycentrics", test_barycentrics, nullptr, nullptr, nullptr},
      {"levels", test_levels, nullptr, nullptr, nullptr},
      {"matcap", test_matcap, nullptr, nullptr, nullptr},
  };
  return _cmocka_run_group_tests("unit.material.show", tests, sizeof tests / sizeof tests[0], set_up, tear_down);
}
