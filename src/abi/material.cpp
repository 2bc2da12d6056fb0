// SPDX-License-Identifier: MIT
#include <shd/material.h>

#include <cstdio>

#include "abi/desc.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "material/material.h"

namespace {

using namespace shd;
using namespace shd::abi;

constexpr core::ObjectType kType = core::ObjectType::kMaterial;
constexpr uint32_t kFlags =
    SHD_SPECULAR_UNGATED | SHD_AMBIENT_PER_LIGHT | SHD_MATERIAL_DISCARDS | SHD_ALPHA_TO_COVERAGE;

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

shd_result check_material_desc(const shd_material_desc& desc) {
  SHD_TRY(check_enum("material.model", desc.model, SHD_MODEL_LAMBERT, SHD_MODEL_UNLIT));
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
  return check_programs(desc);
}

shd_result fill(const shd_material_desc& desc, material::Material* out) {
  const texture::Texture* texture = nullptr;
  const texture::Sampler* sampler = nullptr;
  SHD_TRY(retain_part("material.diffuse_texture", desc.diffuse_texture, core::ObjectType::kTexture, &texture,
                      &out->texture_object));
  SHD_TRY(retain_part("material.diffuse_sampler", desc.diffuse_sampler, core::ObjectType::kSampler, &sampler,
                      &out->sampler_object));
  material::build(desc, texture, sampler, out);
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
