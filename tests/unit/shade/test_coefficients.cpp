// SPDX-License-Identifier: MIT
// Radiance of every model from its lobes, with and without each slot, against the formulas in long double.
#include "support/check.h"

#include <algorithm>

#include "data/data.h"
#include "ref/radiance_ref.h"
#include "shade/combine.h"
#include "support/random.h"
#include "support/targets.h"

namespace shd::tests {
namespace {

using raster::kBatch;

const core::Allocator g_allocator = {core::default_allocator()};
constexpr size_t kRows = 2 * 64 + 3;

struct Fixture {
  material::Material material;
  shade::LightTable lights = {};
  shade::Columns columns, first;
};
Fixture* g;

int set_up(void**) {
  g = new Fixture;
  shade::allocate(g_allocator, 1, &g->columns);
  shade::allocate(g_allocator, 1, &g->first);
  return 0;
}
int tear_down(void**) {
  delete g;
  return 0;
}

struct ModelCase {
  const char* name;
  shd_model model;
  shd_debug_view view = SHD_DEBUG_VIEW_NONE;
};
const ModelCase k_models[] = {
    {"lambert", SHD_MODEL_LAMBERT},
    {"blinn_phong", SHD_MODEL_BLINN_PHONG},
    {"unlit", SHD_MODEL_UNLIT},
    {"phong", SHD_MODEL_PHONG},
    {"normalized", SHD_MODEL_BLINN_PHONG_NORMALIZED},
    {"combined", SHD_MODEL_COMBINED},
    {"gooch", SHD_MODEL_GOOCH},
    {"toon", SHD_MODEL_TOON},
    {"metallic_roughness", SHD_MODEL_METALLIC_ROUGHNESS},
    {"matcap", SHD_MODEL_MATCAP},
    {"show_normal", SHD_MODEL_LAMBERT, SHD_DEBUG_VIEW_NORMAL},
    {"show_uv", SHD_MODEL_LAMBERT, SHD_DEBUG_VIEW_UV},
    {"show_level", SHD_MODEL_LAMBERT, SHD_DEBUG_VIEW_LEVEL},
    {"show_barycentrics", SHD_MODEL_LAMBERT, SHD_DEBUG_VIEW_BARYCENTRICS},
};

void build(const shd_material_desc& desc) {
  const material::SlotInput slots[material::kSlotCount] = {};
  material::build(desc, slots, &g->material);
}

shd_material_desc random_material(Random* random, const ModelCase& of) {
  shd_material_desc desc = shd_material_desc_default();
  desc.model = of.model;
  desc.debug_view = of.view;
  const bool emits = random->bits() & 1;
  for (int c = 0; c < 3; ++c) {
    desc.ambient[c] = random->real(0.0, 2.0);
    desc.diffuse[c] = random->real(0.0, 1.0);
    desc.specular[c] = random->real(0.0, 2.0);
    desc.emission[c] = emits ? random->real(0.0, 2.0) : 0.0f;
    desc.warm[c] = random->real(0.0, 1.0);
    desc.cool[c] = random->real(0.0, 1.0);
  }
  desc.metallic = random->real(0.0, 1.0);
  desc.ior = random->real(1.0, 3.0);
  desc.occlusion_strength = random->real(0.0, 1.0);
  desc.opacity = random->real(0.0, 1.0);
  desc.warm_mix = random->real(0.0, 1.0);
  desc.cool_mix = random->real(0.0, 1.0);
  return desc;
}

/// Random lobes and slot values in `first`; lobes that the model lacks are NaN.
void random_columns(Random* random, const ModelCase& of) {
  const uint32_t lobes = std::max(material::info_of(material::model_key(of.model, of.view)).lobes, 1u);
  for (int c = 0; c < 3; ++c) {
    g->lights.ambient[c] = random->real(0.0, 2.0);
    for (size_t i = 0; i < kBatch; ++i) {
      for (uint32_t k = 0; k < material::kMaxLobes; ++k)
        g->first.lobes.lobe[k][c][i] = k < lobes ? random->real(0, 10) : NAN;
    }
  }
  for (uint32_t slot = 0; slot < material::kSlotCount; ++slot) {
    for (uint32_t c = 0; c < material::slot_channels(slot); ++c) {
      for (size_t i = 0; i < kBatch; ++i) g->first.slot[slot][c][i] = random->real(0.0, 1.0);
    }
  }
}

/// The columns of some slots, as look_up_slots() returns them for slots that the model reads.
material::Parameters parameters(uint32_t slots) {
  material::Parameters p = {};
  for (uint32_t slot = 0; slot < material::kSlotCount; ++slot) {
    if (slots >> slot & 1) std::copy_n(g->first.slot[slot], 4, p.value[slot]);
  }
  return p;
}

/// Compares row i with the result in double: |error| <= 6 half ulps of the terms.
void check_point(size_t i, const material::Parameters& p, const shade::Radiance& got) {
  const material::Material& m = g->material;
  const auto lights = static_cast<long double>(g->lights.count);
  const long double times = m.flags & SHD_MATERIAL_AMBIENT_PER_LIGHT ? lights : 1.0L;
  const auto value = [&](uint32_t slot, uint32_t c) {
    const float* column = p.value[slot][c];
    return column ? static_cast<long double>(column[i]) : 1.0L;
  };
  const bool counts = material::has_opacity(m);
  const long double a = counts ? m.opacity * value(SHD_SLOT_OPACITY, 0) * value(SHD_SLOT_DIFFUSE, 3) : 1.0L;
  shd_assert_close("a", i, got.channel[3][i], static_cast<double>(a), 0.0, 3 * 0x1p-24);
  const bool multiplied = m.blend != SHD_BLEND_OPAQUE && m.blend != SHD_BLEND_STRAIGHT;
  for (int c = 0; c < 3; ++c) {
    ref::SlotValues s = {};
    for (uint32_t slot = 0; slot < material::kSlotCount; ++slot) {
      s.of[slot] = value(slot, material::slot_channels(slot) > 1 ? static_cast<uint32_t>(c) : 0u);
    }
    long double lobe[3];
    for (int k = 0; k < 3; ++k) lobe[k] = g->first.lobes.lobe[k][c][i];
    const ref::Sum want = ref::radiance(m, s, lights, times * g->lights.ambient[c], lobe, c);
    const long double scale = multiplied ? a : 1.0L;
    shd_assert_close("channel", i, got.channel[c][i], static_cast<double>(scale * want.value),
                     static_cast<double>(12 * 0x1p-24L * scale * want.magnitude), 0.0);
  }
}

void combine_everywhere(const material::Parameters& p, size_t count) {
  for_each_target([&](const core::SimdTarget& target, bool first) {
    shade::Radiance& out = first ? g->first.radiance : g->columns.radiance;
    for (int c = 0; c < 4; ++c) std::fill_n(out.channel[c], kBatch, -77.0f);
    shade::combine(target, g->material, g->lights, g->first.lobes, p, count, &out);
    for (int c = 0; c < 4; ++c) {
      if (!first) assert_memory_equal(out.channel[c], g->first.radiance.channel[c], count * sizeof(float));
      for (size_t i = data::padded(count); i < kBatch; ++i) assert_true(out.channel[c][i] == -77.0f);
    }
  });
  for (size_t i = 0; i < count; ++i) check_point(i, p, g->first.radiance);
}

/// Every single slot, no slots, all slots, and random sets.
void test_slots(void** state) {
  const auto* c = static_cast<const ModelCase*>(*state);
  Random random = {92};
  const uint32_t reads = material::info_of(material::model_key(c->model, c->view)).slots;
  for (uint32_t n = 0; n < material::kSlotCount + 22; ++n) {
    const uint32_t slots = n < material::kSlotCount    ? 1u << n
                           : n == material::kSlotCount ? 0u
                                                       : static_cast<uint32_t>(random.bits());
    shd_material_desc desc = random_material(&random, *c);
    desc.blend = static_cast<shd_blend>(random.whole(SHD_BLEND_OPAQUE, SHD_BLEND_SORTED));
    desc.alpha_cutoff = random.bits() & 1 ? 0.5f : 0.0f;
    build(desc);
    random_columns(&random, *c);
    g->lights.count = static_cast<size_t>(random.whole(0, 5));
    combine_everywhere(parameters(slots & reads), kRows);
  }
}

/// Any number of points.
void test_tails(void** state) {
  const auto* c = static_cast<const ModelCase*>(*state);
  Random random = {93};
  shd_material_desc desc = random_material(&random, *c);
  desc.blend = SHD_BLEND_PREMULTIPLIED;
  build(desc);
  random_columns(&random, *c);
  g->lights.count = 2;
  for (size_t count = 0; count <= kRows; ++count)
    combine_everywhere(parameters(material::info_of(material::model_key(c->model, c->view)).slots), count);
}

/// Ambient light is added once per light that is not ambient; it is zero without lights.
void test_ambient_per_light(void** state) {
  const auto* c = static_cast<const ModelCase*>(*state);
  Random random = {94};
  for (size_t lights : {size_t{0}, size_t{1}, size_t{7}}) {
    shd_material_desc desc = random_material(&random, *c);
    desc.flags = SHD_MATERIAL_AMBIENT_PER_LIGHT;
    build(desc);
    random_columns(&random, *c);
    g->lights.count = lights;
    combine_everywhere(parameters(material::info_of(material::model_key(c->model, c->view)).slots), kRows);
  }
}

struct BlendCase {
  const char* name;
  shd_blend blend;
  float cutoff;
  uint32_t flags;
  float want_a, want_l;  // with opacity 1/2, diffuse slot alpha 1/4 and an unlit 1
};
const BlendCase k_blends[] = {
    {"blend/opaque", SHD_BLEND_OPAQUE, 0, 0, 1, 1},
    {"blend/opaque/cutoff", SHD_BLEND_OPAQUE, 0.5f, 0, 0.125f, 1},
    {"blend/opaque/coverage", SHD_BLEND_OPAQUE, 0, SHD_MATERIAL_ALPHA_TO_COVERAGE, 0.125f, 1},
    {"blend/premultiplied", SHD_BLEND_PREMULTIPLIED, 0, 0, 0.125f, 0.125f},
    {"blend/straight", SHD_BLEND_STRAIGHT, 0, 0, 0.125f, 1},
    {"blend/add", SHD_BLEND_ADD, 0, 0, 0.125f, 0.125f},
    {"blend/multiply", SHD_BLEND_MULTIPLY, 0, 0, 0.125f, 0.125f},
    {"blend/weighted", SHD_BLEND_WEIGHTED, 0, 0, 0.125f, 0.125f},
    {"blend/sorted", SHD_BLEND_SORTED, 0, 0, 0.125f, 0.125f},
};

void test_blend(void** state) {
  const auto* c = static_cast<const BlendCase*>(*state);
  shd_material_desc desc = shd_material_desc_default();
  desc.model = SHD_MODEL_UNLIT;
  std::fill_n(desc.diffuse, 3, 1.0f);
  desc.blend = c->blend;
  desc.alpha_cutoff = c->cutoff;
  desc.flags = c->flags;
  desc.opacity = 0.5f;
  build(desc);
  for (int channel = 0; channel < 4; ++channel) {
    std::fill_n(g->first.slot[SHD_SLOT_DIFFUSE][channel], kBatch, channel == 3 ? 0.25f : 1.0f);
  }
  for_each_target([&](const core::SimdTarget& target, bool) {
    shade::combine(target, g->material, g->lights, g->first.lobes, parameters(1u << SHD_SLOT_DIFFUSE), 3,
                   &g->columns.radiance);
    assert_true(g->columns.radiance.channel[0][2] == c->want_l && g->columns.radiance.channel[3][2] == c->want_a);
  });
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  static char names[64][64];
  CMUnitTest tests[64];
  size_t n = 0;
  for (const ModelCase& c : k_models) {
    const struct {
      const char* name;
      CMUnitTestFunction body;
    } bodies[] = {{"slots", test_slots}, {"tails", test_tails}, {"ambient_per_light", test_ambient_per_light}};
    for (const auto& body : bodies) {
      snprintf(names[n], sizeof names[0], "%s/%s", body.name, c.name);
      tests[n] = {names[n], body.body, nullptr, nullptr, const_cast<ModelCase*>(&c)};
      ++n;
    }
  }
  for (const BlendCase& c : k_blends) tests[n++] = {c.name, test_blend, nullptr, nullptr, const_cast<BlendCase*>(&c)};
  return _cmocka_run_group_tests("unit.shade.coefficients", tests, n, set_up, tear_down);
}
