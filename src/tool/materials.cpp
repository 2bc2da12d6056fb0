// SPDX-License-Identifier: MIT
#include "tool/materials.h"

#include <algorithm>

#include "command/failure.h"
#include "tool/occlusion.h"
#include "tool/solids.h"
#include "tool/textures.h"

namespace {

shd_sampler* make_sampler(shd_context* context, const Options& options, std::vector<Sampler>& out) {
  shd_sampler_desc desc = shd_sampler_desc_default();
  desc.filter = options.filter;
  desc.magnification = options.magnification;
  desc.lod_bias = options.lod_bias;
  desc.wrap_u = desc.wrap_v = SHD_WRAP_REPEAT;
  Sampler sampler;
  check(shd_sampler_create(context, &desc, sampler.out()), "sampler");
  out.push_back(std::move(sampler));
  return out.back().get();
}

constexpr int kTargets = SHD_SLOT_TINT + 1;

/// Textures of the command line, by slot target; null = the texture of the surface.
struct Replacements {
  shd_texture* texture[kTargets] = {};
  const shd_solid_desc* solid = nullptr;  // feeds the diffuse slot
  shd_slot uv = shd_slot_default();       // coordinates of the textures, except heights and matcaps
  bool drops_others = false;              // no other textures of the surface are used
};

/// Slots of one material, at most one for each target.
using Slots = std::vector<shd_slot>;

/// Slots of the surface and of the command line, with the uv scale of the options.
Slots make_slots(const shd_material_desc& desc, const Options& options, const Replacements& replacements,
                 shd_sampler* sampler) {
  Slots slots;
  for (size_t i = 0; i < desc.slot_count && !replacements.drops_others; ++i) {
    const shd_slot& slot = desc.slots[i];
    if (options.occlusion && slot.target == SHD_SLOT_OCCLUSION) continue;
    if (!replacements.texture[slot.target]) slots.push_back(slot);
  }
  for (int target = 0; target < kTargets; ++target) {
    shd_texture* texture = replacements.texture[target];
    if (!texture) continue;
    shd_slot slot = replacements.uv;
    if (target == SHD_SLOT_HEIGHT || target == SHD_SLOT_MATCAP) slot = shd_slot_default();
    slot.target = static_cast<shd_slot_target>(target);
    slot.source = SHD_SLOT_SOURCE_TEXTURE;
    slot.texture = texture;
    slot.sampler = sampler;
    slots.push_back(slot);
  }
  if (options.occlusion) slots.push_back(shd_slot_vertex(SHD_SLOT_OCCLUSION, kOcclusionAttribute));
  if (replacements.solid) {
    slots.push_back(shd_slot_solid(SHD_SLOT_DIFFUSE, replacements.solid));
    slots.back().place_space = SHD_PLACE_SPACE_WORLD;
  }
  for (shd_slot& slot : slots) {
    for (size_t i = 0; i < 6 && slot.target != SHD_SLOT_MATCAP; ++i) slot.uv_transform[i] *= options.uv_scale;
  }
  return slots;
}

void set_lobe(shd_material_desc& desc, const Options& options) {
  desc.exponent = options.exponent.value_or(desc.exponent);
  desc.metallic = options.metallic.value_or(desc.metallic);
  desc.roughness = options.roughness.value_or(desc.roughness);
  for (float& c : desc.specular) c = options.specular.value_or(c);
}

/// Replaces coefficients of the surface by those of the options; returns the textures that replace its maps.
Replacements set_extras(shd_material_desc& desc, const Options& options, const Extras& extras) {
  Replacements replacements;
  replacements.drops_others = !options.texture.empty() || extras.solid;
  if (extras.solid) replacements.solid = &*extras.solid;
  if (!extras.solid) replacements.texture[SHD_SLOT_DIFFUSE] = extras.diffuse.get();
  replacements.uv = extras.uv;
  replacements.texture[SHD_SLOT_NORMAL] = extras.normal.texture.get();
  replacements.texture[SHD_SLOT_NORMAL_MIXED] = extras.normal.mixed.get();
  replacements.texture[SHD_SLOT_HEIGHT] = extras.height.get();
  replacements.texture[SHD_SLOT_MATCAP] = extras.matcap.get();
  for (size_t c = 0; c < 3; ++c) {
    if (options.diffuse) desc.diffuse[c] = (*options.diffuse)[c];
    if (extras.diffuse.get() || extras.solid) desc.diffuse[c] = 1.0f;
  }
  if (extras.normal.texture.get() && options.keep == KeepRoughness::kToksvig)
    desc.normal_encoding = SHD_NORMAL_ENCODING_TOKSVIG;
  if (extras.normal.texture.get() && options.keep == KeepRoughness::kLean)
    desc.normal_encoding = SHD_NORMAL_ENCODING_MOMENTS;
  if (extras.height.get()) {
    desc.bump = options.bump_form;
    desc.bump_scale = options.bump_scale;
    desc.parallax_depth = options.parallax;
  }
  return replacements;
}

shd_debug_view debug_view_of(Show show) {
  switch (show) {
    case Show::kNormal: return SHD_DEBUG_VIEW_NORMAL;
    case Show::kUv: return SHD_DEBUG_VIEW_UV;
    case Show::kBarycentrics: return SHD_DEBUG_VIEW_BARYCENTRICS;
    default: return SHD_DEBUG_VIEW_NONE;
  }
}

/// Leaves one term of the model in the light that make_lights() leaves. The ambient one has the emission.
void set_term(shd_material_desc& desc, Term term) {
  if (term != Term::kDiffuse && term != Term::kSpecular) return;
  const bool no_diffuse = term == Term::kSpecular || desc.model == SHD_MODEL_UNLIT;
  for (size_t c = 0; c < 3; ++c) {
    desc.emission[c] = 0.0f;
    (no_diffuse ? desc.diffuse : desc.specular)[c] = 0.0f;
  }
}

Texture load_extra(shd_context* context, const Options& options, const std::string& path, bool data) {
  if (path.empty() || path == "none") return Texture();
  const uint32_t tables = tables_of(options.filter);
  return path == "checker" ? make_checker(context, tables) : load_texture(context, path, data, tables);
}

}  // namespace

Extras make_extras(shd_context* context, const Options& options, const shd_slot& uv) {
  Extras extras;
  extras.uv = uv;
  extras.diffuse = load_extra(context, options, options.texture, false);
  if (options.solid.kind) extras.solid = make_solid(options.solid);
  extras.height = load_extra(context, options, options.height_map, true);
  if (!options.normal_map.empty()) extras.normal = load_normal_map(context, options);
  if (options.reflectance == SHD_MODEL_MATCAP) extras.matcap = make_matcap(context);
  return extras;
}

shd_model model_of(const Options& options, const Model& model) {
  if (options.reflectance) return *options.reflectance;
  const auto is_metallic = [](const Surface& surface) {
    return surface.desc.model == SHD_MODEL_METALLIC_ROUGHNESS || surface.desc.model == SHD_MODEL_GLASS;
  };
  const bool metallic = std::any_of(model.surfaces.begin(), model.surfaces.end(), is_metallic);
  return metallic || !options.environment.empty() ? SHD_MODEL_METALLIC_ROUGHNESS : SHD_MODEL_BLINN_PHONG;
}

bool keeps_model(const Options& options, shd_model model) {
  return !options.reflectance &&
         (model == SHD_MODEL_UNLIT || (model == SHD_MODEL_GLASS && !options.environment.empty()));
}

Material make_material(shd_context* context, const Options& options, shd_model model, const Surface& surface,
                       const Extras& extras, std::vector<Sampler>& samplers, shd_slot& diffuse) {
  shd_material_desc desc = surface.desc;
  if (!keeps_model(options, desc.model)) desc.model = model;
  desc.debug_view = debug_view_of(options.show);
  set_lobe(desc, options);
  Replacements replacements;
  if (!surface.is_floor) replacements = set_extras(desc, options, extras);
  const Slots slots = make_slots(desc, options, replacements, make_sampler(context, options, samplers));
  set_term(desc, options.term);
  diffuse = shd_slot_default();
  for (const shd_slot& slot : slots) {
    if (slot.target == SHD_SLOT_DIFFUSE) diffuse = slot;
  }
  desc.slots = slots.data();
  desc.slot_count = static_cast<uint32_t>(slots.size());
  Material material;
  check(shd_material_create(context, &desc, material.out()), "material \"" + surface.name + "\"");
  return material;
}
