// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: material, (Fragments -> lobes).
///
/// Input:      a checked desc.
/// Output:     coefficients in the form that the kernels of shade/ read.
/// Units:      scene-linear RGB.
/// Invariants: a Material never changes once made; it holds references to its textures and samplers.
///
/// | file                      | what                                                                      |
/// |---------------------------|---------------------------------------------------------------------------|
/// | slot.h                    | where a coefficient varies, and which belong together                     |
/// | model.h                   | what each model reads, and how many lobes it has                          |
/// | lambert-inl.h             | lobes of one light: the cosine                                            |
/// | phong-inl.h               | the mirrored light                                                        |
/// | blinn_phong-inl.h         | the half vector, and its normalisation                                    |
/// | toon-inl.h                | in steps                                                                  |
/// | metallic_roughness-inl.h  | of glTF's microfacets                                                     |
/// | roughness-inl.h           | exponents and roughness in their range, and widened                       |
#pragma once

#include <cstdint>

#include <shd/material.h>

#include "core/object.h"
#include "material/model.h"
#include "material/slot.h"
#include "texture/texture.h"

namespace shd::material {

struct Material {
  shd_model model;
  uint32_t flags;     // shd_material_flag
  float ambient[3];   // k_a
  float diffuse[3];   // k_d, or base colour
  float specular[3];  // k_s
  float exponent;     // p
  float emission[3];
  float metallic, roughness;
  float dielectric;  // F0 of ior
  float occlusion_strength;
  float warm[3], cool[3];  // of Gooch, with their share of k_d still to come
  float warm_mix, cool_mix;
  float toon_steps;
  shd_normal_encoding normal_encoding;
  float normal_scale[2];               // of x and y
  float normal_factor, normal_offset;  // from values of the slot to components
  shd_bump bump;
  float bump_scale;
  float parallax_depth;
  uint32_t parallax_steps;
  Slot slot[SHD_SLOT_COUNT];
  uint32_t slots;  // bits of those that are set and that the model reads
  shd_material_program program;
  uint32_t varying_count;  // 0 without program.vertex
  shd_interpolation interpolation[SHD_MAX_VARYINGS];
  shd_blend_mode blend;
  float opacity, alpha_cutoff;
  texture::Sampler default_sampler;                   // of slots without one
  core::Object* texture_object[SHD_SLOT_COUNT] = {};  // retained, or null
  core::Object* sampler_object[SHD_SLOT_COUNT] = {};  // retained, or null

  Material() = default;
  Material(const Material&) = delete;
  Material& operator=(const Material&) = delete;
  ~Material();  // releases the objects
};

/// Whether the model reads a slot that is set.
inline bool has_slot(const Material& material, uint32_t slot) {
  return material.slots >> slot & 1;
}

/// Whether fragments must be shaded to know which samples they cover.
inline bool drops_fragments(const Material& material) {
  return material.alpha_cutoff > 0.0f || (material.flags & (SHD_ALPHA_TO_COVERAGE | SHD_MATERIAL_DISCARDS)) != 0;
}

/// Whether the opacity of a model counts.
inline bool has_opacity(const Material& material) {
  return material.blend != SHD_BLEND_OPAQUE || drops_fragments(material);
}

/// Whether the blend comes after all draws that have an order.
inline bool is_unordered(const Material& material) {
  return material.blend == SHD_BLEND_WEIGHTED || material.blend == SHD_BLEND_SORTED;
}

/// What the handles of a slot stand for.
struct SlotParts {
  const texture::Texture* texture;  // null = none
  const texture::Sampler* sampler;  // null = the default one
};

/// Takes a checked desc with what its handles stand for; the references in `out` are the caller's to set.
void build(const shd_material_desc& desc, const SlotParts parts[SHD_SLOT_COUNT], Material* out) noexcept;

}  // namespace shd::material
