// SPDX-License-Identifier: MIT
// Values of slots: textures with transforms and uv sets, alone and shared; attributes of meshes; procedures.
#include "core/status.h"  // before cmocka, whose fail is a macro

#include <cstring>
#include <limits>
#include <stdexcept>

#include "texture/lookup/sample.h"
#include "unit/shade/slot_fixture.h"

namespace shd::tests {
namespace {

constexpr uint32_t kSize = 8;

texture::Texture* random_texture(Random* random) {
  static float texels[kSize * kSize * 4];
  for (float& texel : texels) texel = random->real(-1.0, 1.0);
  return make_texture(SHD_FORMAT_RGBA32F, kSize, kSize, texels, SHD_TABLE_MIPMAP);
}

void random_points(Random* random) {
  raster::Fragments& f = g->points;
  f.count = kBatch;
  for (size_t i = 0; i < kBatch; ++i) {
    for (float* column : {f.u, f.v, f.u1, f.v1}) column[i] = random->real(-2.0, 2.0);
    for (float* column : {f.dudx, f.dvdx, f.dudy, f.dvdy, f.du1dx, f.dv1dx, f.du1dy, f.dv1dy}) {
      column[i] = random->real(-0.3, 0.3);
    }
    for (float* column : f.attribute) column[i] = random->real(-1.0, 1.0);
  }
}

/// Expected values of a slot, from a separate lookup, in `kept`.
void look_up_alone(const core::SimdTarget& target, const material::Slot& slot, uint32_t index, bool has_footprint) {
  static float at[6][kBatch];
  const raster::Fragments& f = g->points;
  const float* const first[6] = {f.u, f.v, f.dudx, f.dvdx, f.dudy, f.dvdy};
  const float* const second[6] = {f.u1, f.v1, f.du1dx, f.dv1dx, f.du1dy, f.dv1dy};
  const float* const* in = slot.uv_set ? second : first;
  const float* t = slot.uv_transform;
  for (size_t i = 0; i < f.count; ++i) {
    for (int k = 0; k < 6; k += 2) {
      at[k][i] = t[0] * in[k][i] + t[1] * in[k + 1][i] + (k ? 0.0f : t[2]);
      at[k + 1][i] = t[3] * in[k][i] + t[4] * in[k + 1][i] + (k ? 0.0f : t[5]);
    }
  }
  const bool j = has_footprint;
  const texture::Lookups lookups = {
      f.count, at[0],   at[1],  j ? at[2] : nullptr, j ? at[3] : nullptr, j ? at[4] : nullptr, j ? at[5] : nullptr,
      nullptr, nullptr, nullptr};
  texture::Texels out = {};
  const uint32_t channels = material::slot_channels(index);
  for (uint32_t c = 0; c < channels; ++c) out.channel[channels == 1 ? slot.channel : c] = g->kept.slot[index][c];
  texture::sample(*slot.texture, *slot.sampler, target, lookups, out);
}

/// Slots with random textures, samplers, transforms, sets and channels, many of them equal.
void random_slots(Random* random, texture::Texture* const textures[2], const texture::Sampler* samplers,
                  shd_model model, shd_normal_encoding encoding) {
  shd_material_desc desc = shd_material_desc_default();
  desc.model = model;
  desc.normal_encoding = encoding;
  desc.blend = random->whole(0, 1) ? SHD_BLEND_PREMULTIPLIED : SHD_BLEND_OPAQUE;
  material::SlotInput slots[material::kSlotCount] = {};
  const float turned[6] = {0.6f, -0.8f, 0.25f, 0.8f, 0.6f, -0.5f};
  for (uint32_t i = 0; i < material::kSlotCount; ++i) {
    if (random->whole(0, 4) == 0) continue;
    shd_slot slot = shd_slot_texture(static_cast<shd_slot_target>(i), nullptr, nullptr);
    slot.uv_set = random->whole(0, 3) == 0;
    slot.channel = static_cast<uint32_t>(random->whole(0, 3));
    if (random->whole(0, 2) == 0) std::copy_n(turned, 6, slot.uv_transform);
    slots[i] = {slot, i, textures[random->whole(0, 3) == 0], &samplers[random->whole(0, 3) == 0], nullptr};
  }
  material::build(desc, slots, &g->material);
}

/// Shared lookups give the bits of separate lookups.
void test_textures(void** state) {
  const auto model = *static_cast<const shd_model*>(*state);
  Random random = {161};
  texture::Texture* const textures[2] = {random_texture(&random), random_texture(&random)};
  static texture::Sampler samplers[2];
  samplers[0] = make_sampler(SHD_FILTER_TRILINEAR, SHD_WRAP_REPEAT);
  samplers[1] = make_sampler(SHD_FILTER_BILINEAR, SHD_WRAP_CLAMP);
  const uint32_t looked_up =
      material::info_of(material::key_of(model)).slots & ~(1u << SHD_SLOT_HEIGHT | 1u << SHD_SLOT_MATCAP);
  for (int n = 0; n < 60; ++n) {
    const shd_normal_encoding encoding = n % 4 < 2 ? SHD_NORMAL_ENCODING_MOMENTS : SHD_NORMAL_ENCODING_XYZ;
    random_slots(&random, textures, samplers, model, encoding);
    random_points(&random);
    g->points.count = n % 3 ? kBatch : static_cast<size_t>(random.whole(1, 131));
    const uint32_t wanted = n % 2 ? ~0u : material::kShapingSlots;
    for_each_target([&](const core::SimdTarget& target, bool) {
      const shade::DrawShading shading = draw_shading();
      material::Parameters p = {};
      for (uint32_t i = 0; i < material::kSlotCount; ++i) {
        for (uint32_t c = 0; c < material::slot_channels(i); ++c) std::fill_n(g->columns.slot[i][c], kBatch, -77.0f);
      }
      shade::look_up_slots(target, {shading, g->points, g->varyings, n % 5 != 0}, wanted, &g->columns, &p);
      const bool completes_moments = encoding == SHD_NORMAL_ENCODING_MOMENTS &&
                                     g->material.slot[SHD_SLOT_NORMAL].source == SHD_SLOT_SOURCE_TEXTURE;
      const auto is_read = [&](uint32_t i) {
        return g->material.slot[i].source == SHD_SLOT_SOURCE_TEXTURE && looked_up >> i & 1 && wanted >> i & 1 &&
               (i != SHD_SLOT_NORMAL_MIXED || completes_moments);
      };
      const bool tinted = is_read(SHD_SLOT_TINT);
      for (uint32_t i = material::kSlotCount; i-- > 0;) {  // the tint before the diffuse slot
        const material::Slot& slot = g->material.slot[i];
        const bool is_diffuse = i == SHD_SLOT_DIFFUSE, reads = is_read(i);
        assert_true((p.value[i][0] != nullptr) == (reads || (is_diffuse && tinted)));
        const bool lacks_alpha = (is_diffuse || i == SHD_SLOT_TINT) && g->material.blend == SHD_BLEND_OPAQUE;
        for (uint32_t c = 0; c < material::slot_channels(i); ++c) {
          const bool fills = reads && !(lacks_alpha && c == 3);
          for (size_t k = fills ? g->points.count : 0; k < kBatch; ++k) assert_true(g->columns.slot[i][c][k] == -77.0f);
        }
        if (!reads) continue;
        look_up_alone(target, slot, i, n % 5 != 0);
        if (lacks_alpha) assert_null(p.value[i][3]);
        for (uint32_t c = 0; c < (lacks_alpha ? 3 : material::slot_channels(i)); ++c) {
          for (size_t k = 0; is_diffuse && tinted && k < g->points.count; ++k) {
            g->kept.slot[i][c][k] *= g->kept.slot[SHD_SLOT_TINT][c][k];
          }
          assert_memory_equal(p.value[i][c], g->kept.slot[i][c], g->points.count * sizeof(float));
        }
      }
    });
  }
  for (texture::Texture* texture : textures) free_texture(texture);
}

/// The diffuse slot and the tint have straight colours of premultiplied textures, other slots the lookups; without
/// opacity, too. Colours are 0 where alpha is not positive.
void test_premultiplied(void**) {
  Random random = {171};
  float texels[kSize * kSize * 4];
  for (float& texel : texels) texel = random.real(-1.0, 1.0);
  texels[3] = std::numeric_limits<float>::quiet_NaN();
  texture::Texture* const texture = make_texture(SHD_FORMAT_RGBA32F, kSize, kSize, texels, SHD_TABLE_MIPMAP);
  texture->premultiplied = true;
  const texture::Sampler sampler = make_sampler(SHD_FILTER_TRILINEAR, SHD_WRAP_REPEAT);
  for (int n = 0; n < 8; ++n) {
    shd_material_desc desc = shd_material_desc_default();
    desc.model = SHD_MODEL_BLINN_PHONG;
    desc.blend = n % 2 ? SHD_BLEND_STRAIGHT : SHD_BLEND_OPAQUE;
    material::SlotInput slots[material::kSlotCount] = {};
    for (const shd_slot_target i : {SHD_SLOT_DIFFUSE, SHD_SLOT_SPECULAR, SHD_SLOT_TINT}) {
      if (i != SHD_SLOT_TINT || n & 2)
        slots[i] = {shd_slot_texture(i, nullptr, nullptr), i, texture, &sampler, nullptr};
    }
    if (n & 4) slots[SHD_SLOT_DIFFUSE] = {};
    material::build(desc, slots, &g->material);
    random_points(&random);
    for_each_target([&](const core::SimdTarget& target, bool) {
      material::Parameters p = {};
      const shade::DrawShading shading = draw_shading();
      shade::look_up_slots(target, {shading, g->points, g->varyings, true}, ~0u, &g->columns, &p);
      material::Slot slot = g->material.slot[SHD_SLOT_SPECULAR];
      look_up_alone(target, slot, SHD_SLOT_DIFFUSE, true);
      size_t hidden = 0;
      for (size_t i = 0; i < kBatch; ++i) {
        const float a = g->kept.slot[SHD_SLOT_DIFFUSE][3][i];
        hidden += !(a > 0.0f);
        for (uint32_t c = 0; c < 3; ++c) {
          const float color = g->kept.slot[SHD_SLOT_DIFFUSE][c][i];
          assert_memory_equal(&p.value[SHD_SLOT_SPECULAR][c][i], &color, sizeof color);
          const float straight = a > 0.0f ? color / a : 0.0f;
          const float wanted = (n & 6) == 2 ? straight * straight : straight;
          if ((n & 6) == 4) assert_null(p.value[SHD_SLOT_DIFFUSE][c]);
          if ((n & 6) != 4) assert_memory_equal(&p.value[SHD_SLOT_DIFFUSE][c][i], &wanted, sizeof wanted);
        }
      }
      assert_true(hidden > 0 && hidden < kBatch);
    });
  }
  free_texture(texture);
}

struct AttributeCase {
  const char* name;
  uint32_t slot, attribute;
  uint32_t present;   // bits of the columns that the mesh has
  uint32_t expected;  // bits of the channels that come from the mesh
};
const AttributeCase k_attributes[] = {
    {"attribute/colour", SHD_SLOT_DIFFUSE, 0, 0xff, 0xf},
    {"attribute/colour/4", SHD_SLOT_DIFFUSE, 4, 0xff, 0xf},
    {"attribute/colour/runs_out", SHD_SLOT_DIFFUSE, 6, 0xff, 0x3},
    {"attribute/colour/without_alpha", SHD_SLOT_DIFFUSE, 0, 0x07, 0x7},
    {"attribute/colour/absent", SHD_SLOT_DIFFUSE, 0, 0, 0},
    {"attribute/scalar", SHD_SLOT_EXPONENT, 7, 0x80, 1},
    {"attribute/scalar/absent", SHD_SLOT_EXPONENT, 7, 0x7f, 0},
    {"attribute/normal", SHD_SLOT_NORMAL, 0, 0xff, 0xf},
    {"attribute/normal/three", SHD_SLOT_NORMAL, 5, 0xff, 0x7},
    {"attribute/normal/absent", SHD_SLOT_NORMAL, 0, 0, 0},
};

/// Slots read the columns of the mesh. An absent column counts as 1; it is null except for normals, whose kernel reads
/// all columns.
void test_attribute(void** state) {
  const auto* c = static_cast<const AttributeCase*>(*state);
  Random random = {162};
  shd_material_desc desc = shd_material_desc_default();
  desc.model = SHD_MODEL_BLINN_PHONG;
  material::SlotInput slots[material::kSlotCount] = {};
  slots[c->slot].desc = shd_slot_vertex(static_cast<shd_slot_target>(c->slot), c->attribute);
  material::build(desc, slots, &g->material);
  random_points(&random);
  for (uint32_t k = 0; k < SHD_MAX_ATTRIBUTES; ++k) g->vertices.has_attribute[k] = c->present >> k & 1;
  const shade::DrawShading shading = draw_shading();
  material::Parameters p = {};
  shade::look_up_slots(best_target(), {shading, g->points, g->varyings, true}, ~0u, &g->columns, &p);
  for (uint32_t k = 0; k < material::slot_channels(c->slot); ++k) {
    const float* got = p.value[c->slot][k];
    if (c->slot == SHD_SLOT_NORMAL) assert_non_null(got);
    for (size_t i = 0; i < kBatch; ++i) {
      const float want = c->expected >> k & 1 ? g->points.attribute[c->attribute + k][i] : 1.0f;
      assert_true((got ? got[i] : 1.0f) == want);
    }
  }
}

/// The inputs of a procedure, and its behaviour.
struct Call {
  uint32_t slot;
  size_t calls, points;
  bool sees_rows, starts_at_1;
  int throws;  // 1 = std::runtime_error, 2 = something else
};

void procedure(const shd_fragments* in, float* const out[4], void* user_data) {
  auto* call = static_cast<Call*>(user_data);
  ++call->calls;
  call->points += in->count;
  call->sees_rows =
      in->u == g->points.u && in->attribute[0] == nullptr && in->struct_size == sizeof *in && in->draw == 3;
  const uint32_t channels = material::slot_channels(call->slot);
  call->starts_at_1 = true;
  for (uint32_t c = 0; c < 4; ++c) call->starts_at_1 &= (out[c] != nullptr) == (c < channels);
  for (uint32_t c = 0; c < channels; ++c) {
    for (size_t i = 0; i < in->count; ++i) call->starts_at_1 &= out[c][i] == 1.0f;
  }
  if (call->throws == 1) throw std::runtime_error("out of paint");
  if (call->throws == 2) throw 7;
  for (uint32_t c = 0; c < channels - (channels == 4); ++c) {
    for (size_t i = 0; i < in->count; ++i) out[c][i] = in->u[i] + static_cast<float>(c);
  }
}

void set_procedure(Call* call) {
  shd_material_desc desc = shd_material_desc_default();
  desc.model = call->slot == SHD_SLOT_METALLIC || call->slot == SHD_SLOT_ROUGHNESS ? SHD_MODEL_METALLIC_ROUGHNESS
                                                                                   : SHD_MODEL_BLINN_PHONG;
  material::SlotInput slots[material::kSlotCount] = {};
  slots[call->slot].desc = shd_slot_procedure(static_cast<shd_slot_target>(call->slot), procedure, call);
  slots[call->slot].index = 7;
  material::build(desc, slots, &g->material);
}

/// Every slot that accepts a procedure calls it once with the points; channels that it does not write are 1.
void test_procedure(void**) {
  Random random = {163};
  std::fill_n(g->vertices.has_attribute, SHD_MAX_ATTRIBUTES, false);
  for (uint32_t slot = 0; slot < SHD_SLOT_HEIGHT; ++slot) {
    for (size_t count : {size_t{1}, size_t{65}, kBatch}) {
      Call call = {slot, 0, 0, false, false, 0};
      set_procedure(&call);
      random_points(&random);
      g->points.count = count;
      const shade::DrawShading shading = draw_shading();
      material::Parameters p = {};
      shade::look_up_slots(best_target(), {shading, g->points, g->varyings, true}, ~0u, &g->columns, &p);
      assert_true(call.calls == 1 && call.points == count && call.sees_rows && call.starts_at_1);
      const uint32_t channels = material::slot_channels(slot);
      for (uint32_t c = 0; c < channels; ++c) {
        for (size_t i = 0; i < count; ++i) {
          assert_true(p.value[slot][c][i] == (c == 3 ? 1.0f : g->points.u[i] + static_cast<float>(c)));
        }
      }
    }
  }
}

/// An exception from a procedure becomes a failure that names the slot and the draw.
void test_throws(void**) {
  Random random = {164};
  random_points(&random);
  for (int throws : {1, 2}) {
    Call call = {SHD_SLOT_SPECULAR, 0, 0, false, false, throws};
    set_procedure(&call);
    const shade::DrawShading shading = draw_shading();
    material::Parameters p = {};
    shd_result result = SHD_OK;
    char text[core::kErrorTextSize] = "";
    try {
      shade::look_up_slots(best_target(), {shading, g->points, g->varyings, true}, ~0u, &g->columns, &p);
    } catch (const core::Failure& failure) {
      result = failure.code;
      std::strcpy(text, failure.what());
    }
    assert_int_equal(result, SHD_ERROR_CALLBACK);
    assert_non_null(strstr(text, "material.slots[7].procedure threw in render.draws[3]"));
    if (throws == 1) assert_non_null(strstr(text, "out of paint"));
  }
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  static shd_model models[] = {SHD_MODEL_METALLIC_ROUGHNESS, SHD_MODEL_BLINN_PHONG, SHD_MODEL_MATCAP};
  CMUnitTest tests[32];
  size_t n = 0;
  tests[n++] = {"textures/metallic_roughness", test_textures, nullptr, nullptr, &models[0]};
  tests[n++] = {"textures/blinn_phong", test_textures, nullptr, nullptr, &models[1]};
  tests[n++] = {"textures/matcap", test_textures, nullptr, nullptr, &models[2]};
  for (const AttributeCase& c : k_attributes) {
    tests[n++] = {c.name, test_attribute, nullptr, nullptr, const_cast<AttributeCase*>(&c)};
  }
  tests[n++] = {"premultiplied", test_premultiplied, nullptr, nullptr, nullptr};
  tests[n++] = {"procedure", test_procedure, nullptr, nullptr, nullptr};
  tests[n++] = {"procedure/throws", test_throws, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.shade.parameters", tests, n, set_up, tear_down);
}
