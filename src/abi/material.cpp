// SPDX-License-Identifier: MIT
#include <shd/material.h>

#include <cstdio>

#include "abi/desc.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "abi/lookup.h"
#include "abi/solid.h"
#include "material/material.h"

namespace {

using namespace shd;
using namespace shd::abi;

constexpr core::ObjectType kMaterialType = core::ObjectType::kMaterial;
constexpr uint32_t kFlags = SHD_MATERIAL_SPECULAR_UNGATED | SHD_MATERIAL_AMBIENT_PER_LIGHT | SHD_MATERIAL_DISCARDS |
                            SHD_MATERIAL_ALPHA_TO_COVERAGE | SHD_MATERIAL_DOUBLE_SIDED | SHD_MATERIAL_NORMAL_Y_DOWN;

shd_result check_programs(const shd_material_desc& desc) {
  SHD_TRY(check_count("material.varying_count", desc.varying_count, 0, SHD_MAX_VARYINGS));
  for (size_t i = 0; desc.interpolation && i < desc.varying_count; ++i) {
    char field[48];
    std::snprintf(field, sizeof field, "material.interpolation[%zu]", i);
    SHD_TRY(check_enum(field, desc.interpolation[i], 0, SHD_INTERPOLATION_FLAT));
  }
  if (desc.varying_count && !desc.program.vertex) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "material.varying_count: %zu, but material.program.vertex is NULL",
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

/// k_a: -1 in all channels, or none of them negative.
shd_result check_ambient(const shd_material_desc& desc) {
  SHD_TRY(check_range("material.ambient_share", double{desc.ambient_share}, 0.0, 1.0));
  const float* const k = desc.ambient;
  if (k[0] == -1.0f && k[1] == -1.0f && k[2] == -1.0f) return SHD_OK;
  for (int c = 0; c < 3; ++c) {
    if (k[c] >= 0.0f && k[c] <= 1e6f) continue;
    return core::fail(SHD_ERROR_INVALID_ARGUMENT,
                      "material.ambient[%d]: %g is not in 0..1e+06, and the channels are not all -1", c, double{k[c]});
  }
  return SHD_OK;
}

shd_result check_metal(const shd_material_desc& desc) {
  SHD_TRY(check_values("material.emission", desc.emission, 3, 0.0, 1e12));
  SHD_TRY(check_range("material.metallic", double{desc.metallic}, 0.0, 1.0));
  SHD_TRY(check_range("material.roughness", double{desc.roughness}, 0.0, 1.0));
  SHD_TRY(check_range("material.clearcoat", double{desc.clearcoat}, 0.0, 1.0));
  SHD_TRY(check_range("material.clearcoat_roughness", double{desc.clearcoat_roughness}, 0.0, 1.0));
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
  SHD_TRY(check_enum("material.normal_encoding", desc.normal_encoding, 0, SHD_NORMAL_ENCODING_MOMENTS));
  SHD_TRY(check_range("material.normal_scale", double{desc.normal_scale}, -1e3, 1e3));
  SHD_TRY(check_enum("material.bump", desc.bump, 0, SHD_BUMP_TEXEL));
  SHD_TRY(check_range("material.bump_scale", double{desc.bump_scale}, -1e6, 1e6));
  SHD_TRY(check_range("material.parallax_depth", double{desc.parallax_depth}, 0.0, 1e6));
  return check_count("material.parallax_steps", desc.parallax_steps, 2, 256);
}

shd_result check_material_desc(const shd_material_desc& desc) {
  SHD_TRY(check_enum("material.model", desc.model, SHD_MODEL_LAMBERT, material::last_model()));
  SHD_TRY(check_enum("material.debug_view", desc.debug_view, 0, SHD_DEBUG_VIEW_BARYCENTRICS));
  SHD_TRY(check_flags("material.flags", desc.flags, kFlags));
  SHD_TRY(check_ambient(desc));
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

/// Whether a slot reads 2D textures only.
bool takes_only_textures(shd_slot_target target) {
  return target == SHD_SLOT_HEIGHT || target == SHD_SLOT_MATCAP;
}

/// The name of a field of a slot, for messages.
struct SlotField {
  SlotField(uint32_t index, const char* name) {
    std::snprintf(text, sizeof text, "material.slots[%u].%s", index, name);
  }
  char text[48];
};

shd_result check_place_transform(const char* field, const float (&m)[16]) {
  SHD_TRY(check_finite(field, m, 16));
  if (m[3] == 0.0f && m[7] == 0.0f && m[11] == 0.0f && m[15] == 1.0f) return SHD_OK;
  return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s: last row is (%g, %g, %g, %g), not (0, 0, 0, 1)", field,
                    double{m[3]}, double{m[7]}, double{m[11]}, double{m[15]});
}

/// The fields of a slot that reads places.
shd_result check_place(const shd_slot& desc, uint32_t index) {
  const SlotField transform(index, "place_transform");
  SHD_TRY(check_enum(SlotField(index, "place_space").text, desc.place_space, 0, SHD_PLACE_SPACE_WORLD));
  if (desc.coordinates == SHD_SLOT_COORDINATES_PROJECTED) {
    SHD_TRY(check_finite(transform.text, desc.place_transform, 16));
  } else {
    SHD_TRY(check_place_transform(transform.text, desc.place_transform));
  }
  return check_range(SlotField(index, "place_width").text, double{desc.place_width}, 0.0, 1000.0);
}

/// Checks the coordinates of a slot's texture: uv, or places if the slot takes those.
shd_result check_coordinates(const shd_slot& desc, uint32_t index, const texture::Texture& texture) {
  const SlotField coordinates(index, "coordinates");
  SHD_TRY(check_enum(coordinates.text, desc.coordinates, 0, SHD_SLOT_COORDINATES_TRIPLANAR));
  if (texture.depth == 0 || takes_only_textures(desc.target)) {
    SHD_TRY(check_flat(SlotField(index, "texture").text, texture));
    if (desc.coordinates == SHD_SLOT_COORDINATES_UV) return SHD_OK;
    if (takes_only_textures(desc.target)) {
      return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s: %u, but this slot takes the uv of the mesh only",
                        coordinates.text, enum_bits(desc.coordinates));
    }
    SHD_TRY(check_count(SlotField(index, "triplanar_sharpness").text, desc.triplanar_sharpness, 1, 64));
  } else if (desc.coordinates != SHD_SLOT_COORDINATES_UV) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s: %u, but the texture is 3D", coordinates.text,
                      enum_bits(desc.coordinates));
  }
  return check_place(desc, index);
}

/// check_use() with a message that names the slot.
shd_result check_slot_tables(uint32_t index, const texture::Texture& texture, const texture::Sampler& sampler) {
  const shd_result result = check_use(texture, sampler);
  return result == SHD_OK ? result : core::fail_within(result, "material.slots[%u].", index);
}

/// Texture and sampler of a slot, retained.
shd_result take_parts(const shd_slot& desc, material::SlotInput* slot, material::Material* out) {
  const SlotField texture(slot->index, "texture"), sampler(slot->index, "sampler");
  if (!desc.texture)
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s: NULL, but the source is a texture", texture.text);
  SHD_TRY(check_count(SlotField(slot->index, "uv_set").text, desc.uv_set, 0, 1));
  SHD_TRY(check_count(SlotField(slot->index, "channel").text, desc.channel, 0, 3));
  SHD_TRY(check_finite(SlotField(slot->index, "uv_transform").text, desc.uv_transform, 6));
  SHD_TRY(retain_part(texture.text, desc.texture, core::ObjectType::kTexture, &slot->texture,
                      &out->texture_object[desc.target]));
  SHD_TRY(retain_part(sampler.text, desc.sampler, core::ObjectType::kSampler, &slot->sampler,
                      &out->sampler_object[desc.target]));
  SHD_TRY(check_coordinates(desc, slot->index, *slot->texture));
  return slot->sampler ? check_slot_tables(slot->index, *slot->texture, *slot->sampler) : SHD_OK;
}

/// Copies the solid texture of a slot. Throws std::bad_alloc.
shd_result take_solid(const core::Allocator& allocator, material::SlotInput* slot, material::Material* out) {
  const shd_slot& desc = slot->desc;
  shd_solid_desc solid;
  SHD_TRY(check_count(SlotField(slot->index, "channel").text, desc.channel, 0, 3));
  SHD_TRY(check_place(desc, slot->index));
  SHD_TRY(read_solid(SlotField(slot->index, "solid").text, desc.solid, &solid));
  core::Array<procedural::Solid>& copy = out->solid[desc.target];
  copy = core::Array<procedural::Solid>(allocator, 1);
  procedural::build(solid, copy.data());
  slot->solid = copy.data();
  return SHD_OK;
}

/// Checks the source of a slot and that no field of another source is set.
shd_result check_source(const material::SlotInput& slot) {
  const shd_slot& desc = slot.desc;
  const SlotField source(slot.index, "source");
  SHD_TRY(check_enum(source.text, desc.source, SHD_SLOT_SOURCE_CONSTANT, SHD_SLOT_SOURCE_SOLID));
  if (takes_only_textures(desc.target) && desc.source != SHD_SLOT_SOURCE_CONSTANT &&
      desc.source != SHD_SLOT_SOURCE_TEXTURE) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s: %u, but this slot takes textures only", source.text,
                      enum_bits(desc.source));
  }
  if (desc.source != SHD_SLOT_SOURCE_TEXTURE && (desc.texture || desc.sampler)) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s: %u, but a texture or sampler is set", source.text,
                      enum_bits(desc.source));
  }
  if (desc.source != SHD_SLOT_SOURCE_TEXTURE && desc.coordinates != SHD_SLOT_COORDINATES_UV) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s: %u, but coordinates of a texture are set", source.text,
                      enum_bits(desc.source));
  }
  if (desc.source == SHD_SLOT_SOURCE_SOLID || !desc.solid) return SHD_OK;
  return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s: %u, but a solid texture is set", source.text,
                    enum_bits(desc.source));
}

/// Checks a slot and retains or copies its objects. Throws std::bad_alloc.
shd_result take_slot(const core::Allocator& allocator, material::SlotInput* slot, material::Material* out) {
  const shd_slot& desc = slot->desc;
  SHD_TRY(check_source(*slot));
  if (desc.source == SHD_SLOT_SOURCE_TEXTURE) return take_parts(desc, slot, out);
  if (desc.source == SHD_SLOT_SOURCE_SOLID) return take_solid(allocator, slot, out);
  if (desc.source == SHD_SLOT_SOURCE_VERTEX) {
    return check_count(SlotField(slot->index, "attribute").text, desc.attribute, 0, SHD_MAX_ATTRIBUTES - 1);
  }
  if (desc.source == SHD_SLOT_SOURCE_PROCEDURE)
    return check_not_null(SlotField(slot->index, "procedure").text, reinterpret_cast<const void*>(desc.procedure));
  return SHD_OK;
}

/// Reads slot `index` of the caller's, which are struct_size apart, into its place among `slots`. Throws
/// std::bad_alloc.
shd_result read_slot(const core::Allocator& allocator, const shd_slot* first, uint32_t index, bool* is_taken,
                     material::SlotInput* slots, material::Material* out) {
  const uint32_t stride = core::struct_size_of(first);
  const char* const in = reinterpret_cast<const char*>(first) + size_t{index} * stride;
  char name[32];
  std::snprintf(name, sizeof name, "material.slots[%u]", index);
  shd_slot desc = shd_slot_default();
  SHD_TRY(read_desc(name, reinterpret_cast<const shd_slot*>(in), false, &desc));
  if (desc.struct_size != stride) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s.struct_size: %u is not the %u of material.slots[0]", name,
                      desc.struct_size, stride);
  }
  SHD_TRY(check_enum(SlotField(index, "target").text, desc.target, 0, material::kSlotCount - 1));
  if (is_taken[desc.target]) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s.target: %u is that of material.slots[%u] too", name,
                      enum_bits(desc.target), slots[desc.target].index);
  }
  is_taken[desc.target] = true;
  slots[desc.target] = {desc, index, nullptr, nullptr, nullptr};
  return take_slot(allocator, &slots[desc.target], out);
}

/// Throws std::bad_alloc.
shd_result fill(const core::Allocator& allocator, const shd_material_desc& desc, material::Material* out) {
  SHD_TRY(check_count("material.slot_count", desc.slot_count, 0, material::kSlotCount));
  if (desc.slot_count) SHD_TRY(check_not_null("material.slots", desc.slots));
  material::SlotInput slots[material::kSlotCount] = {};
  bool is_taken[material::kSlotCount] = {};
  for (uint32_t i = 0; i < desc.slot_count; ++i) SHD_TRY(read_slot(allocator, desc.slots, i, is_taken, slots, out));
  material::build(desc, slots, out);
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
    return create_handle<material::Material>(
        owner, kMaterialType, [&](material::Material* body) { return fill(owner.allocator, read, body); },
        out_material);
  });
}

void shd_material_retain(shd_material* material) {
  retain_handle(material, kMaterialType);
}

void shd_material_release(shd_material* material) {
  release_handle(material, kMaterialType);
}

}  // extern "C"
