// SPDX-License-Identifier: MIT
#include <shd/material.h>

#include <cstdio>

#include "abi/desc.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "abi/lookup_columns.h"
#include "material/material.h"

namespace {

using namespace shd;
using namespace shd::abi;

constexpr core::ObjectType kType = core::ObjectType::kMaterial;
constexpr uint32_t kFlags = SHD_SPECULAR_UNGATED | SHD_AMBIENT_PER_LIGHT | SHD_MATERIAL_DISCARDS |
                            SHD_ALPHA_TO_COVERAGE | SHD_DOUBLE_SIDED | SHD_NORMAL_Y_DOWN;

shd_result check_programs(const shd_material_desc& desc) {
  SHD_TRY(check_count("material.varying_count", desc.varying_count, 0, SHD_MAX_VARYINGS));
  for (int i = 0; i < SHD_MAX_VARYINGS; ++i) {
    char field[40];
    std::snprintf(field, sizeof field, "material.interpolation[%d]", i);
    SHD_TRY(check_enum(field, desc.interpolation[i], 0, SHD_INTERPOLATION_FLAT));
  }
  SHD_TRY(check_zero("material.reserved", desc.reserved));
  if (desc.varying_count && !desc.program.vertex) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "material.varying_count: %u, but material.program.vertex is NULL",
                      desc.varying_count);
  }
  if (desc.model == SHD_MODEL_PROGRAM && !desc.program.fragment) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT,
                      "material.program.fragment: NULL, but the model is SHD_MODEL_PROGRAM");
  }
  if (desc.model != SHD_MODEL_PROGRAM && desc.program.fragment) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT,
                      "material.program.fragment: set, but the model is not SHD_MODEL_PROGRAM");
  }
  return SHD_OK;
}

shd_result check_metal(const shd_material_desc& desc) {
  SHD_TRY(check_values("material.emission", desc.emission, 3, 0.0, 1e12));
  SHD_TRY(check_range("material.metallic", double{desc.metallic}, 0.0, 1.0));
  SHD_TRY(check_range("material.roughness", double{desc.roughness}, 0.0, 1.0));
  SHD_TRY(check_range("material.ior", double{desc.ior}, 1.0, 10.0));
  return check_range("material.occlusion_strength", double{desc.occlusion_strength}, 0.0, 1.0);
}

shd_result check_drawing(const shd_material_desc& desc) {
  SHD_TRY(check_values("material.warm", desc.warm, 3, 0.0, 1e6));
  SHD_TRY(check_values("material.cool", desc.cool, 3, 0.0, 1e6));
  SHD_TRY(check_range("material.warm_mix", double{desc.warm_mix}, 0.0, 1.0));
  SHD_TRY(check_range("material.cool_mix", double{desc.cool_mix}, 0.0, 1.0));
  return check_count("material.toon_steps", desc.toon_steps, 1, 256);
}

shd_result check_surface(const shd_material_desc& desc) {
  SHD_TRY(check_enum("material.normal_encoding", desc.normal_encoding, 0, SHD_NORMAL_MOMENTS));
  SHD_TRY(check_range("material.normal_scale", double{desc.normal_scale}, -1e3, 1e3));
  SHD_TRY(check_enum("material.bump", desc.bump, 0, SHD_BUMP_TEXEL));
  SHD_TRY(check_range("material.bump_scale", double{desc.bump_scale}, -1e6, 1e6));
  SHD_TRY(check_range("material.parallax_depth", double{desc.parallax_depth}, 0.0, 1e6));
  return check_count("material.parallax_steps", desc.parallax_steps, 2, 256);
}

shd_result check_material_desc(const shd_material_desc& desc) {
  SHD_TRY(check_enum("material.model", desc.model, SHD_MODEL_LAMBERT, material::last_model()));
  SHD_TRY(check_flags("material.flags", desc.flags, kFlags));
  SHD_TRY(check_values("material.ambient", desc.ambient, 3, 0.0, 1e6));
  SHD_TRY(check_values("material.diffuse", desc.diffuse, 3, 0.0, 1e6));
  SHD_TRY(check_values("material.specular", desc.specular, 3, 0.0, 1e6));
  SHD_TRY(check_range("material.exponent", static_cast<double>(desc.exponent), 0.0, 1e6));
  SHD_TRY(check_enum("material.blend", desc.blend, SHD_BLEND_OPAQUE, SHD_BLEND_SORTED));
  SHD_TRY(check_range("material.opacity", static_cast<double>(desc.opacity), 0.0, 1.0));
  SHD_TRY(check_range("material.alpha_cutoff", static_cast<double>(desc.alpha_cutoff), 0.0, 1.0));
  if (desc.model != SHD_MODEL_PROGRAM && desc.flags & SHD_MATERIAL_DISCARDS) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT,
                      "material.flags: SHD_MATERIAL_DISCARDS, but the model is not SHD_MODEL_PROGRAM");
  }
  SHD_TRY(check_metal(desc));
  SHD_TRY(check_drawing(desc));
  SHD_TRY(check_surface(desc));
  return check_programs(desc);
}

/// A message about a field of a slot.
struct SlotField {
  SlotField(uint32_t slot, const char* name) { std::snprintf(text, sizeof text, "material.slot[%u].%s", slot, name); }
  char text[48];
};

/// Texture and sampler of a slot, retained.
shd_result take_parts(const shd_slot& desc, uint32_t slot, material::SlotParts* parts, material::Material* out) {
  const SlotField texture(slot, "texture"), sampler(slot, "sampler");
  if (!desc.texture)
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s: NULL, but the source is a texture", texture.text);
  SHD_TRY(check_count(SlotField(slot, "uv_set").text, desc.uv_set, 0, 1));
  SHD_TRY(check_count(SlotField(slot, "channel").text, desc.channel, 0, 3));
  SHD_TRY(check_finite(SlotField(slot, "uv_transform").text, desc.uv_transform, 6));
  SHD_TRY(
      retain_part(texture.text, desc.texture, core::ObjectType::kTexture, &parts->texture, &out->texture_object[slot]));
  SHD_TRY(
      retain_part(sampler.text, desc.sampler, core::ObjectType::kSampler, &parts->sampler, &out->sampler_object[slot]));
  if (!parts->sampler || check_tables(*parts->texture, *parts->sampler) == SHD_OK) return SHD_OK;
  return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s: its filter needs a table that the texture lacks", sampler.text);
}

shd_result take_slot(const shd_slot& desc, uint32_t slot, material::SlotParts* parts, material::Material* out) {
  const SlotField source(slot, "source");
  SHD_TRY(check_enum(source.text, desc.source, SHD_SOURCE_CONSTANT, SHD_SOURCE_PROCEDURE));
  const bool only_textures = slot == SHD_SLOT_HEIGHT || slot == SHD_SLOT_MATCAP;
  if (only_textures && desc.source != SHD_SOURCE_CONSTANT && desc.source != SHD_SOURCE_TEXTURE) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s: %u, but this slot takes a texture or nothing", source.text,
                      enum_bits(desc.source));
  }
  if (desc.source != SHD_SOURCE_TEXTURE && (desc.texture || desc.sampler)) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s: %u, but a texture or sampler is set", source.text,
                      enum_bits(desc.source));
  }
  if (desc.source == SHD_SOURCE_TEXTURE) return take_parts(desc, slot, parts, out);
  if (desc.source == SHD_SOURCE_VERTEX) {
    return check_count(SlotField(slot, "attribute").text, desc.attribute, 0, SHD_MAX_ATTRIBUTES - 1);
  }
  if (desc.source == SHD_SOURCE_PROCEDURE)
    return check_not_null(SlotField(slot, "procedure").text, reinterpret_cast<const void*>(desc.procedure));
  return SHD_OK;
}

shd_result fill(const shd_material_desc& desc, material::Material* out) {
  material::SlotParts parts[SHD_SLOT_COUNT] = {};
  for (uint32_t i = 0; i < SHD_SLOT_COUNT; ++i) SHD_TRY(take_slot(desc.slot[i], i, &parts[i], out));
  material::build(desc, parts, out);
  return SHD_OK;
}

}  // namespace

extern "C" {

shd_result shd_material_create(shd_context* context, const shd_material_desc* desc, shd_material** out_material) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_not_null("out_material", out_material));
    *out_material = nullptr;
    SHD_TRY(check_context(context));
    shd_material_desc read = shd_material_desc_default();
    SHD_TRY(read_desc("material", desc, true, &read));
    SHD_TRY(check_material_desc(read));
    core::Context& owner = context_of(context);
    auto* material = core::create<material::Material>(owner.allocator);
    if (const shd_result result = fill(read, material)) {
      core::destroy(owner.allocator, material);
      return result;
    }
    make_handle(owner, kType, material, out_material);
    return SHD_OK;
  });
}

void shd_material_retain(shd_material* material) {
  retain_handle(material, kType);
}

void shd_material_release(shd_material* material) {
  release_handle(material, kType);
}

}  // extern "C"
