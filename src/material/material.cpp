// SPDX-License-Identifier: MIT
#include "material/material.h"

#include <algorithm>

namespace shd::material {
namespace {

Slot build_slot(const SlotInput& in, const texture::Sampler& default_sampler) noexcept {
  constexpr float kIdentity[6] = {1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f};
  const shd_slot& desc = in.desc;
  Slot slot = {};
  slot.index = in.index;
  slot.source = desc.source;
  if (desc.source == SHD_SLOT_SOURCE_TEXTURE) {
    slot.uv_set = desc.uv_set;
    slot.channel = desc.channel;
    slot.texture = in.texture;
    slot.sampler = in.sampler ? in.sampler : &default_sampler;
    std::copy_n(desc.uv_transform, 6, slot.uv_transform);
    slot.coordinates = desc.coordinates;
    slot.triplanar_sharpness = desc.triplanar_sharpness;
    slot.is_transformed = !std::equal(kIdentity, kIdentity + 6, slot.uv_transform);
  } else if (desc.source == SHD_SLOT_SOURCE_VERTEX) {
    slot.attribute = desc.attribute;
  } else if (desc.source == SHD_SLOT_SOURCE_PROCEDURE) {
    slot.procedure = desc.procedure;
    slot.user_data = desc.user_data;
  } else if (desc.source == SHD_SLOT_SOURCE_SOLID) {
    slot.channel = desc.channel;
    slot.solid = in.solid;
  }
  if (reads_places(slot)) {
    slot.place_space = desc.place_space;
    std::copy_n(desc.place_transform, 16, slot.place_transform);
    slot.place_width = desc.place_width;
  }
  return slot;
}

/// Reflectance at normal incidence of a surface with an index of refraction.
float dielectric_f0_of(float ior) noexcept {
  const double ratio = (double{ior} - 1.0) / (double{ior} + 1.0);
  return static_cast<float>(ratio * ratio);
}

/// k_a and its slot: those of the desc, or a share of the diffuse colour.
void build_ambient(const shd_material_desc& desc, const SlotInput slots[kSlotCount], Material* out) noexcept {
  out->ambient_slot = SHD_SLOT_AMBIENT;
  std::copy_n(desc.ambient, 3, out->ambient);
  if (desc.ambient[0] >= 0.0f) return;
  const bool is_colored = info_of(out->model).colors_ambient;
  for (int c = 0; c < 3; ++c) out->ambient[c] = desc.ambient_share * (is_colored ? 1.0f : desc.diffuse[c]);
  if (!is_colored && slots[SHD_SLOT_AMBIENT].desc.source == SHD_SLOT_SOURCE_CONSTANT)
    out->ambient_slot = SHD_SLOT_DIFFUSE;
}

bool has_unorm_texels(const texture::Texture* normals) noexcept {
  return normals && normals->component != image::Component::kFloat16 &&
         normals->component != image::Component::kFloat32;
}

void build_surface(const shd_material_desc& desc, const texture::Texture* normals, Material* out) noexcept {
  const bool is_unorm = has_unorm_texels(normals);
  out->normal_factor = is_unorm ? 2.0f : 1.0f;
  out->normal_offset = is_unorm ? -1.0f : 0.0f;
  out->normal_encoding = desc.normal_encoding;
  out->normal_scale[0] = desc.normal_scale;
  out->normal_scale[1] = desc.flags & SHD_MATERIAL_NORMAL_Y_DOWN ? -desc.normal_scale : desc.normal_scale;
  out->bump = desc.bump;
  out->bump_scale = desc.bump_scale;
  out->parallax_depth = desc.parallax_depth;
  out->parallax_steps = desc.parallax_steps;
}

}  // namespace

Material::~Material() {
  for (uint32_t i = 0; i < kSlotCount; ++i) {
    core::release(texture_object[i], static_cast<uint32_t>(core::ObjectType::kTexture));
    core::release(sampler_object[i], static_cast<uint32_t>(core::ObjectType::kSampler));
  }
}

void build(const shd_material_desc& desc, const SlotInput slots[kSlotCount], Material* out) noexcept {
  out->model = model_key(desc.model, desc.debug_view);
  if (out->model == SHD_MODEL_METALLIC_ROUGHNESS && desc.clearcoat > 0.0f) out->model = ModelKey::kClearCoat;
  out->coat = desc.clearcoat;
  out->coat_roughness = desc.clearcoat_roughness;
  const bool has_coat_unorm = has_unorm_texels(slots[SHD_SLOT_CLEARCOAT_NORMAL].texture);
  out->coat_normal_factor = has_coat_unorm ? 2.0f : 1.0f;
  out->coat_normal_offset = has_coat_unorm ? -1.0f : 0.0f;
  out->flags = out->model == ModelKey::kProgram ? desc.flags : desc.flags & ~uint32_t{SHD_MATERIAL_DISCARDS};
  build_ambient(desc, slots, out);
  std::copy_n(desc.diffuse, 3, out->diffuse);
  std::copy_n(desc.specular, 3, out->specular);
  std::copy_n(desc.emission, 3, out->emission);
  std::copy_n(desc.warm, 3, out->warm);
  std::copy_n(desc.cool, 3, out->cool);
  out->exponent = desc.exponent;
  out->metallic = desc.metallic;
  out->roughness = desc.roughness;
  out->ior = desc.ior;
  out->dielectric_f0 = dielectric_f0_of(desc.ior);
  out->occlusion_strength = desc.occlusion_strength;
  out->warm_mix = desc.warm_mix;
  out->cool_mix = desc.cool_mix;
  out->toon_steps = static_cast<float>(desc.toon_steps);
  build_surface(desc, slots[SHD_SLOT_NORMAL].texture, out);
  out->program = desc.program;
  out->varying_count = static_cast<uint32_t>(desc.varying_count);
  std::fill_n(out->interpolation, SHD_MAX_VARYINGS, SHD_INTERPOLATION_PERSPECTIVE);
  if (desc.interpolation) std::copy_n(desc.interpolation, desc.varying_count, out->interpolation);
  out->blend = desc.blend;
  out->opacity = desc.opacity;
  out->alpha_cutoff = desc.alpha_cutoff;
  out->default_sampler = texture::make_sampler(shd_sampler_desc_default());
  out->slots = 0;
  for (uint32_t i = 0; i < kSlotCount; ++i) {
    out->slot[i] = build_slot(slots[i], out->default_sampler);
    if (is_set(out->slot[i])) out->slots |= 1u << i & info_of(out->model).slots;
  }
  if (desc.normal_encoding != SHD_NORMAL_ENCODING_MOMENTS || !has_slot(*out, SHD_SLOT_NORMAL))
    out->slots &= ~(1u << SHD_SLOT_NORMAL_MIXED);
}

}  // namespace shd::material
