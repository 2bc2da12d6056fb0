// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: material, (Fragments -> lobes).
///
/// Input:      a checked desc.
/// Output:     coefficients in the form that the kernels of shade/ read.
/// Units:      scene-linear RGB.
/// Invariants: a Material never changes once made; it holds references to its texture and sampler.
#pragma once

#include <cstdint>

#include <shd/material.h>

#include "core/object.h"
#include "texture/texture.h"

namespace shd::material {

struct Material {
  shd_model model;
  uint32_t flags;     // shd_material_flag
  float ambient[3];   // k_a
  float diffuse[3];   // k_d
  float specular[3];  // k_s
  float exponent;     // p
  shd_material_program program;
  uint32_t varying_count;  // 0 without program.vertex
  shd_interpolation interpolation[SHD_MAX_VARYINGS];
  shd_blend_mode blend;
  float opacity, alpha_cutoff;
  const texture::Texture* diffuse_texture;  // null = none
  const texture::Sampler* diffuse_sampler;  // never null when there is a texture
  texture::Sampler default_sampler;         // what diffuse_sampler points at when the desc gave none
  core::Object* texture_object = nullptr;   // retained, or null
  core::Object* sampler_object = nullptr;   // retained, or null

  Material() = default;
  Material(const Material&) = delete;
  Material& operator=(const Material&) = delete;
  ~Material();  // releases the two objects
};

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

/// Takes a checked desc with what its handles stand for; the references in `out` are the caller's to set.
void build(const shd_material_desc& desc, const texture::Texture* diffuse_texture,
           const texture::Sampler* diffuse_sampler, Material* out) noexcept;

}  // namespace shd::material
