// SPDX-License-Identifier: MIT
// Coefficients, ambient light and texture applied to lobes, and values spread from corners and centroids.
#include "support/check.h"

#include <algorithm>

#include "data/data.h"
#include "shade/combine.h"
#include "support/random.h"
#include "support/targets.h"

namespace shd::tests {
namespace {

using raster::kBatch;

const core::Allocator g_allocator = {core::default_allocator()};

struct Fixture {
  material::Material material;
  shade::LightTable lights = {};
  raster::Fragments points;
  shade::Columns columns, first;
};
Fixture* g;

int set_up(void**) {
  g = new Fixture;
  raster::allocate(g_allocator, &g->points);
  shade::allocate(g_allocator, 1, &g->columns);
  shade::allocate(g_allocator, 1, &g->first);
  return 0;
}
int tear_down(void**) {
  delete g;
  return 0;
}

struct combine_case {
  const char* name;
  shd_model model;
  uint32_t flags;
  size_t lights;
  bool texture;
};
const combine_case k_cases[] = {
    {"lambert", SHD_MODEL_LAMBERT, 0, 1, false},
    {"lambert/texture", SHD_MODEL_LAMBERT, 0, 1, true},
    {"lambert/ambient_per_light/0", SHD_MODEL_LAMBERT, SHD_MATERIAL_AMBIENT_PER_LIGHT, 0, false},
    {"lambert/ambient_per_light/1", SHD_MODEL_LAMBERT, SHD_MATERIAL_AMBIENT_PER_LIGHT, 1, false},
    {"lambert/ambient_per_light/8", SHD_MODEL_LAMBERT, SHD_MATERIAL_AMBIENT_PER_LIGHT, 8, true},
    {"unlit", SHD_MODEL_UNLIT, 0, 2, false},
    {"unlit/texture", SHD_MODEL_UNLIT, 0, 2, true},
    {"blinn_phong/0_lights", SHD_MODEL_BLINN_PHONG, 0, 0, false},
    {"blinn_phong/2_lights", SHD_MODEL_BLINN_PHONG, 0, 2, false},
    {"blinn_phong/texture", SHD_MODEL_BLINN_PHONG, 0, 8, true},
    {"blinn_phong/ambient_per_light/2", SHD_MODEL_BLINN_PHONG, SHD_MATERIAL_AMBIENT_PER_LIGHT, 2, true},
};

material::Parameters parameters(bool texture) {
  material::Parameters p = {};
  if (texture) std::copy_n(g->first.slot[SHD_SLOT_DIFFUSE], 4, p.value[SHD_SLOT_DIFFUSE]);
  return p;
}

void fill(Random* random, const combine_case& c) {
  shd_material_desc desc = shd_material_desc_default();
  desc.model = c.model;
  desc.flags = c.flags;
  std::fill_n(desc.ambient, 3, 1.0f);  // does not follow the diffuse slot
  const material::SlotInput slots[material::kSlotCount] = {};
  material::build(desc, slots, &g->material);
  g->lights.count = c.lights;
  for (int channel = 0; channel < 3; ++channel) {
    g->material.ambient[channel] = random->real(0.0, 2.0);
    g->material.diffuse[channel] = random->real(0.0, 2.0);
    g->material.specular[channel] = random->real(0.0, 2.0);
    g->lights.ambient[channel] = random->real(0.0, 2.0);
    for (size_t i = 0; i < kBatch; ++i) {
      g->first.lobes.lobe[0][channel][i] = random->real(0.0, 10.0);
      // Values that Lambert's model must not read.
      g->first.lobes.lobe[1][channel][i] = c.model == SHD_MODEL_LAMBERT ? NAN : random->real(0.0, 10.0);
      g->first.slot[SHD_SLOT_DIFFUSE][channel][i] = random->real(0.0, 1.0);
    }
  }
}

/// Compares the channels of row i with results in double; |error| <= 5 half ulps of the terms, one per rounding.
void check_point(size_t i, const combine_case& c, const shade::Radiance& got) {
  const double times = c.flags & SHD_MATERIAL_AMBIENT_PER_LIGHT ? static_cast<double>(c.lights) : 1.0;
  for (int channel = 0; channel < 3; ++channel) {
    const material::Material& m = g->material;
    const double t = c.texture ? double{g->first.slot[SHD_SLOT_DIFFUSE][channel][i]} : 1.0;
    if (c.model == SHD_MODEL_UNLIT) {
      shd_assert_close("channel", i, got.channel[channel][i], t * m.diffuse[channel], 0.0, 0x1p-24);
      continue;
    }
    const double ambient = times * m.ambient[channel] * g->lights.ambient[channel];
    const double diffuse = t * m.diffuse[channel] * g->first.lobes.lobe[0][channel][i];
    const double specular =
        c.model == SHD_MODEL_BLINN_PHONG ? double{m.specular[channel]} * g->first.lobes.lobe[1][channel][i] : 0.0;
    shd_assert_close("channel", i, got.channel[channel][i], ambient + diffuse + specular, 0.0, 5 * 0x1p-24);
  }
  assert_true(got.channel[3][i] == 1.0f);
}

void test_combine(void** state) {
  const auto* c = static_cast<const combine_case*>(*state);
  Random random = {61};
  fill(&random, *c);
  for_each_target([&](const core::SimdTarget& target, bool first) {
    for (size_t count = 0; count <= 2 * 64 + 3; ++count) {
      shade::Radiance& out = g->columns.radiance;
      for (size_t k = 0; k < 4; ++k) std::fill_n(out.channel[k], kBatch, -77.0f);
      shade::combine(target, g->material, g->lights, g->first.lobes, parameters(c->texture), count, &out);
      for (size_t i = 0; i < count; ++i) check_point(i, *c, out);
      for (size_t k = 0; k < 4; ++k) {
        for (size_t i = data::padded(count); i < kBatch; ++i) assert_true(out.channel[k][i] == -77.0f);
      }
    }
    for (int channel = 0; channel < 4; ++channel) {
      if (first) memcpy(g->first.radiance.channel[channel], g->columns.radiance.channel[channel], 131 * sizeof(float));
      assert_memory_equal(g->columns.radiance.channel[channel], g->first.radiance.channel[channel],
                          131 * sizeof(float));
    }
  });
}

/// The largest coefficients and lobes of any lights give finite results.
void test_range(void**) {
  Random random = {62};
  fill(&random, {"", SHD_MODEL_BLINN_PHONG, SHD_MATERIAL_AMBIENT_PER_LIGHT, 0, true});
  g->lights.count = size_t{1} << 20;
  for (int channel = 0; channel < 3; ++channel) {
    g->material.ambient[channel] = g->material.diffuse[channel] = g->material.specular[channel] = 1e6f;
    g->lights.ambient[channel] = 1e12f * 1048576.0f;
    for (size_t i = 0; i < kBatch; ++i) {
      g->first.lobes.lobe[0][channel][i] = g->first.lobes.lobe[1][channel][i] = 1e20f * 1048576.0f;
    }
  }
  for_each_target([&](const core::SimdTarget& target, bool) {
    shade::combine(target, g->material, g->lights, g->first.lobes, parameters(true), kBatch, &g->columns.radiance);
    for (size_t c = 0; c < 4; ++c) {
      for (size_t i = 0; i < kBatch; ++i) assert_true(std::isfinite(g->columns.radiance.channel[c][i]));
    }
  });
}

/// The count of rows that are not finite, with and without slots beside the diffuse one, leaves out rows past the end.
void test_nonfinite(void**) {
  const float bad[] = {NAN, INFINITY, -INFINITY};
  Random random = {65};
  for (const bool occluded : {false, true}) {
    fill(&random, {"", SHD_MODEL_BLINN_PHONG, 0, 1, true});
    material::Parameters p = parameters(true);
    for (size_t i = 0; i < kBatch && occluded; ++i) g->first.slot[SHD_SLOT_OCCLUSION][0][i] = 0.5f;
    if (occluded) p.value[SHD_SLOT_OCCLUSION][0] = g->first.slot[SHD_SLOT_OCCLUSION][0];
    for (size_t row = 0; row < 70; row += 3) g->first.lobes.lobe[row % 2][row / 2 % 3][row] = bad[row / 3 % 3];
    for_each_target([&](const core::SimdTarget& target, bool) {
      for (size_t count = 1; count <= 131; ++count) {
        const size_t wanted = (std::min<size_t>(count, 70) + 2) / 3;
        const size_t got =
            shade::combine(target, g->material, g->lights, g->first.lobes, p, count, &g->columns.radiance);
        assert_int_equal(got, wanted);
        assert_int_equal(shade::count_nonfinite(target, g->columns.radiance, count), wanted);
      }
    });
    for (size_t row = 0; row < 70; row += 3) g->first.lobes.lobe[row % 2][row / 2 % 3][row] = 1.0f;
    g->first.lobes.lobe[0][0][5] = NAN;  // past the count
    for_each_target([&](const core::SimdTarget& target, bool) {
      assert_int_equal(shade::combine(target, g->material, g->lights, g->first.lobes, p, 5, &g->columns.radiance), 0);
    });
  }
}

void test_corners(void**) {
  Random random = {63};
  float in[kBatch];
  uint32_t points[kBatch];
  for (size_t i = 0; i < kBatch; ++i) {
    in[i] = random.real(0.0, 100.0);
    points[i] = static_cast<uint32_t>(random.whole(0, kBatch / 3 - 1)) * 3;
    g->points.bary[1][i] = random.real(0.0, 1.0);
    g->points.bary[2][i] = random.real(0.0, 1.0) * (1.0f - g->points.bary[1][i]);
    g->points.bary[0][i] = 1.0f - g->points.bary[1][i] - g->points.bary[2][i];
  }
  alignas(64) float column[kBatch];
  alignas(64) uint32_t row_column[kBatch];
  memcpy(column, in, sizeof in);
  memcpy(row_column, points, sizeof points);
  for_each_target([&](const core::SimdTarget& target, bool first) {
    float *out = g->columns.slot[SHD_SLOT_DIFFUSE][0], *wanted = g->first.slot[SHD_SLOT_DIFFUSE][0];
    for (size_t count = 0; count <= 2 * 64 + 3; ++count) {
      g->points.count = count;
      std::fill_n(out, kBatch, -77.0f);
      shade::spread_corners(target, g->points, row_column, column, out);
      for (size_t i = 0; i < count; ++i) {
        double want = 0.0;
        for (uint32_t k = 0; k < 3; ++k) want += double{g->points.bary[k][i]} * in[points[i] + k];
        shd_assert_close("corner", i, out[i], want, 100 * 8 * 0x1p-24, 0.0);
      }
      for (size_t i = data::padded(count); i < kBatch; ++i) assert_true(out[i] == -77.0f);
    }
    if (first) memcpy(wanted, out, 131 * sizeof(float));
    assert_memory_equal(out, wanted, 131 * sizeof(float));
  });
}

void test_centroids(void**) {
  Random random = {64};
  float in[kBatch], out[kBatch];
  uint32_t points[kBatch];
  for (size_t i = 0; i < kBatch; ++i) {
    in[i] = random.real(0.0, 100.0);
    points[i] = static_cast<uint32_t>(random.whole(0, kBatch - 1));
    out[i] = -77.0f;
  }
  shade::spread_centroids(points, 301, in, out);
  for (size_t i = 0; i < kBatch; ++i) assert_true(out[i] == (i < 301 ? in[points[i]] : -77.0f));
}

/// Ambient lights are summed separately, the other lights keep their order.
void test_table(void**) {
  light::Light light[5];
  const light::Light* pointers[5];
  for (int i = 0; i < 5; ++i) {
    shd_light_desc desc = shd_light_desc_default();
    desc.kind = i % 2 ? SHD_LIGHT_KIND_AMBIENT : i == 2 ? SHD_LIGHT_KIND_DIRECTIONAL : SHD_LIGHT_KIND_POINT;
    desc.intensity[0] = static_cast<float>(i);
    light[i] = light::make_light(desc, nullptr, nullptr);
    pointers[i] = &light[i];
  }
  g->lights = shade::make_light_table(g_allocator, pointers, 5);
  assert_int_equal(g->lights.count, 3);
  for (size_t k = 0; k < 3; ++k) assert_true(g->lights.lights[k].intensity[0] == static_cast<float>(2 * k));
  assert_true(g->lights.ambient[0] == 4.0f && g->lights.ambient[1] == 2.0f);
  g->lights = shade::make_light_table(g_allocator, pointers, 0);
  assert_true(g->lights.count == 0 && g->lights.ambient[0] == 0.0f);
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  CMUnitTest tests[32];
  size_t n = 0;
  for (const combine_case& c : k_cases) {
    tests[n++] = {c.name, test_combine, nullptr, nullptr, const_cast<combine_case*>(&c)};
  }
  tests[n++] = {"range", test_range, nullptr, nullptr, nullptr};
  tests[n++] = {"nonfinite", test_nonfinite, nullptr, nullptr, nullptr};
  tests[n++] = {"spread/corners", test_corners, nullptr, nullptr, nullptr};
  tests[n++] = {"spread/centroids", test_centroids, nullptr, nullptr, nullptr};
  tests[n++] = {"light_table", test_table, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.shade.combine", tests, n, set_up, tear_down);
}
