// SPDX-License-Identifier: MIT
#include "material/material.h"

namespace shd::material {
Material::~Material() {
  core::release(texture_object, static_cast<uint32_t>(core::ObjectType::kTexture));
  core::release(sampler_object, static_cast<uint32_t>(core::ObjectType::kSampler));
}

void build(const shd_material_desc& desc, const texture::Texture* diffuse_texture,
           const texture::Sampler* diffuse_sampler, Material* out) noexcept {
  out->model = desc.model;
  out->flags = desc.flags;
  for (int c = 0; c < 3; ++c) {
    out->ambient[c] = desc.ambient[c];
    out->diffuse[c] = desc.diffuse[c];
    out->specular[c] = desc.specular[c];
  }
  out->exponent = desc.exponent;
  out->program = desc.program;
  out->varying_count = desc.varying_count;
  for (int c = 0; c < SHD_MAX_VARYINGS; ++c) out->interpolation[c] = desc.interpolation[c];
  out->blend = desc.blend;
  out->opacity = desc.opacity;
  out->alpha_cutoff = desc.alpha_cutoff;
  out->default_sampler = texture::make_sampler(shd_sampler_desc_default());
  out->diffuse_texture = diffuse_texture;
  out->diffuse_sampler = diffuse_sampler ? diffuse_sampler : &out->default_sampler;
}

}  // namespace shd::material
