// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: material, (Fragments -> lobes).
///
/// Input:      a checked desc; fragments for models without lights.
/// Output:     coefficients in the form that the kernels of shade/ read; the reflectance models.
/// Units:      scene-linear RGB.
/// Invariants: a Material is immutable; it retains its textures and samplers. A model is one struct in one file, and
///             one row of the table in models-inl.h; nothing else depends on the set of models.
///
/// | file                         | contents                                                              |
/// |------------------------------|-----------------------------------------------------------------------|
/// | slot.h                       | sources of coefficients, and their values at points                   |
/// | places.h                     | places of points in solid and 3D textures                             |
/// | projected.h                  | coordinates of a texture that a slide projector throws                |
/// | triplanar.h                  | coordinates and weights of a texture along three axes                 |
/// | slot_lookup.h                | texture lookups of a slot at points                                   |
/// | model.h                      | properties of a model that other stages use                           |
/// | models-inl.h                 | the table of the models                                               |
/// | model-inl.h                  | members of a model, and the arguments of its functions                |
/// | specular-inl.h               | base of the textbook models with a specular lobe                      |
/// | debug_view-inl.h             | base of the models that show an attribute of fragments                |
/// | exponent-inl.h               | shape of a lobe: exponent, and its gain                               |
/// | roughness-inl.h              | shape of a lobe: alpha^2                                              |
/// | slope_spread-inl.h           | lobes averaged over the normals of a filtered normal map              |
/// | lambert-inl.h                | model                                                                 |
/// | phong-inl.h                  | model                                                                 |
/// | blinn_phong-inl.h            | model                                                                 |
/// | blinn_phong_normalized-inl.h | model                                                                 |
/// | combined-inl.h               | model: ambient light through the diffuse coefficient                  |
/// | toon-inl.h                   | model                                                                 |
/// | gooch-inl.h                  | model                                                                 |
/// | metallic_roughness-inl.h     | model: the microfacets of glTF                                        |
/// | clear_coat-inl.h             | model: metallic-roughness below a clear coat                          |
/// | glass-inl.h                  | model: reflection and refraction                                      |
/// | unlit-inl.h, matcap-inl.h    | models without lights                                                 |
/// | show_*-inl.h                 | debug views of normal, uv, level of detail, barycentric coordinates   |
#pragma once

#include <cstdint>

#include <shd/material.h>

#include "core/allocator.h"
#include "core/object.h"
#include "material/model.h"
#include "material/slot.h"
#include "texture/texture.h"

namespace shd::material {

struct Material {
  ModelKey model;
  uint32_t flags;     // shd_material_flag
  float ambient[3];   // k_a without its slot
  float diffuse[3];   // k_d, or base colour
  float specular[3];  // k_s
  float exponent;     // p
  float emission[3];
  float metallic, roughness;
  float coat, coat_roughness;                    // clear coat
  float coat_normal_factor, coat_normal_offset;  // as normal_factor and normal_offset
  float ior;
  float dielectric_f0;  // reflectance of ior at normal incidence
  float occlusion_strength;
  float warm[3], cool[3];    // Gooch model
  float warm_mix, cool_mix;  // fractions of k_d added to warm and cool
  float toon_steps;
  shd_normal_encoding normal_encoding;
  float normal_scale[2];               // factors of x and y
  float normal_factor, normal_offset;  // component = factor * value of the slot + offset
  shd_bump bump;
  float bump_scale;
  float parallax_depth;
  uint32_t parallax_steps;
  Slot slot[kSlotCount];
  uint32_t ambient_slot;  // slot that scales k_a: its own, or that of the diffuse colour which it follows
  uint32_t slots;         // bits of the set slots that the model reads
  shd_material_program program;
  uint32_t varying_count;  // 0 without program.vertex
  shd_interpolation interpolation[SHD_MAX_VARYINGS];
  shd_blend blend;
  float opacity, alpha_cutoff;
  texture::Sampler default_sampler;                  // used by slots without a sampler
  core::Object* texture_object[kSlotCount] = {};     // retained, or null
  core::Object* sampler_object[kSlotCount] = {};     // retained, or null
  core::Array<procedural::Solid> solid[kSlotCount];  // one each, or empty

  Material() = default;
  Material(const Material&) = delete;
  Material& operator=(const Material&) = delete;
  ~Material();  // releases the objects
};

/// Whether the model reads a slot that is set.
inline bool has_slot(const Material& material, uint32_t slot) {
  return material.slots >> slot & 1;
}

/// Whether the samples that a fragment covers depend on its shading.
inline bool drops_fragments(const Material& material) {
  return material.alpha_cutoff > 0.0f ||
         (material.flags & (SHD_MATERIAL_ALPHA_TO_COVERAGE | SHD_MATERIAL_DISCARDS)) != 0;
}

/// Whether the opacity of the material has an effect.
inline bool has_opacity(const Material& material) {
  return material.blend != SHD_BLEND_OPAQUE || drops_fragments(material);
}

/// Whether the material is blended after all ordered draws.
inline bool is_unordered(const Material& material) {
  return material.blend == SHD_BLEND_WEIGHTED || material.blend == SHD_BLEND_SORTED;
}

/// A slot of the caller and the objects behind its handles. All zero is a constant.
struct SlotInput {
  shd_slot desc;
  uint32_t index;                   // in the caller's array
  const texture::Texture* texture;  // null = none
  const texture::Sampler* sampler;  // null = the default sampler
  const procedural::Solid* solid;   // null = none
};

/// Builds a material from a checked desc and its slots by target. The caller sets the references of `out`.
void build(const shd_material_desc& desc, const SlotInput slots[kSlotCount], Material* out) noexcept;

}  // namespace shd::material
