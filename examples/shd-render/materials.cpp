// SPDX-License-Identifier: MIT
#include "materials.h"

#include <algorithm>
#include <cmath>

#include "failure.h"
#include "textures.h"

namespace {

shd_sampler* make_sampler(shd_context* context, const Options& options, const Map& map, std::vector<Sampler>& out) {
  shd_sampler_desc desc = shd_sampler_desc_default();
  desc.filter = options.filter;
  desc.wrap_u = static_cast<shd_wrap>(map.wrap_u);
  desc.wrap_v = static_cast<shd_wrap>(map.wrap_v);
  Sampler sampler;
  check(shd_sampler_create(context, &desc, sampler.out()), "sampler");
  out.push_back(std::move(sampler));
  return out.back().get();
}

/// Slots of one material, at most one for each target.
using Slots = std::vector<shd_slot>;

/// Puts a texture into the slot of a target.
void set_slot(Slots& slots, shd_slot_target target, const Map& map, shd_texture* texture, shd_sampler* sampler,
              float uv_scale) {
  shd_slot slot = shd_slot_texture(target, texture, sampler);
  slot.uv_set = map.uv_set;
  slot.channel = map.channel;
  for (size_t i = 0; i < 6; ++i) slot.uv_transform[i] = uv_scale * map.uv_transform[i];
  const auto is_same = [&](const shd_slot& other) { return other.target == target; };
  slots.erase(std::remove_if(slots.begin(), slots.end(), is_same), slots.end());
  slots.push_back(slot);
}

/// Copies the slot of `source`, if there is one, to `target`.
void share_slot(Slots& slots, shd_slot_target source, shd_slot_target target) {
  const auto is_source = [&](const shd_slot& slot) { return slot.target == source; };
  const auto found = std::find_if(slots.begin(), slots.end(), is_source);
  if (found == slots.end()) return;
  shd_slot slot = *found;
  slot.target = target;
  slots.push_back(slot);
}

/// The exponent of a Blinn-Phong lobe as wide as a GGX lobe: p = 2 / alpha^2 - 2, alpha = roughness^2; and its inverse.
float exponent_of(float roughness) {
  const float alpha = std::max(roughness * roughness, 0.01f);
  return std::max(2.0f / (alpha * alpha) - 2.0f, 0.0f);
}

float roughness_of(float exponent) {
  return std::sqrt(std::sqrt(2.0f / (exponent + 2.0f)));
}

void set_lobe(shd_material_desc& desc, const Options& options, const Surface& surface) {
  desc.exponent =
      options.exponent.value_or(surface.metallic_roughness ? exponent_of(surface.roughness) : surface.exponent);
  desc.metallic = options.metallic.value_or(surface.metallic);
  desc.roughness =
      options.roughness.value_or(surface.metallic_roughness ? surface.roughness : roughness_of(surface.exponent));
  for (size_t c = 0; c < 3; ++c) desc.specular[c] = options.specular.value_or(surface.specular[c]);
}

void set_blend(shd_material_desc& desc, const Surface& surface) {
  if (surface.double_sided) desc.flags |= SHD_MATERIAL_DOUBLE_SIDED;
  if (surface.alpha == Alpha::kMask) desc.alpha_cutoff = surface.alpha_cutoff;
  if (surface.alpha == Alpha::kBlend) desc.blend = SHD_BLEND_SORTED;
  desc.opacity = surface.opacity;
}

/// Sets the maps of the options, which replace the maps of the surface.
void set_extras(shd_material_desc& desc, Slots& slots, const Options& options, const Extras& extras,
                shd_sampler* sampler) {
  const Map plain;
  if (extras.normal.get()) {
    set_slot(slots, SHD_SLOT_NORMAL, plain, extras.normal.get(), sampler, options.uv_scale);
    if (options.keep == KeepRoughness::kToksvig) desc.normal_encoding = SHD_NORMAL_ENCODING_TOKSVIG;
    if (options.keep == KeepRoughness::kLean) desc.normal_encoding = SHD_NORMAL_ENCODING_MOMENTS;
  }
  if (extras.height.get()) {
    set_slot(slots, SHD_SLOT_HEIGHT, plain, extras.height.get(), sampler, options.uv_scale);
    desc.bump = options.bump_form;
    desc.bump_scale = options.bump_scale;
    desc.parallax_depth = options.parallax;
  }
  if (extras.matcap.get()) {
    set_slot(slots, SHD_SLOT_MATCAP, plain, extras.matcap.get(), sampler, 1.0f);
  }
}

Texture load_extra(shd_context* context, const std::string& path, bool data) {
  Texture texture;
  if (path.empty() || path == "none") return texture;
  if (path == "checker") return make_checker(context);
  TextureSource source;
  source.path = path;
  source.data = data;
  if (!load_texture(context, source, texture)) throw Failure(kExitInput, path + ": " + shd_last_error());
  return texture;
}

}  // namespace

Extras make_extras(shd_context* context, const Options& options) {
  Extras extras;
  extras.diffuse = load_extra(context, options.texture, false);
  extras.height = load_extra(context, options.height_map, true);
  if (!options.normal_map.empty() && !load_normal_map(context, options.normal_map, options.keep, extras.normal)) {
    throw Failure(kExitInput, options.normal_map + ": " + shd_last_error());
  }
  if (options.reflectance == SHD_MODEL_MATCAP) extras.matcap = make_matcap(context);
  return extras;
}

shd_model model_of(const Options& options, const Model& model) {
  if (options.reflectance) return *options.reflectance;
  const auto is_metallic = [](const Surface& surface) { return surface.metallic_roughness; };
  const bool metallic = std::any_of(model.surfaces.begin(), model.surfaces.end(), is_metallic);
  return metallic ? SHD_MODEL_METALLIC_ROUGHNESS : SHD_MODEL_BLINN_PHONG;
}

Material make_material(shd_context* context, const Options& options, shd_model model, const Surface& surface,
                       const std::vector<Texture>& textures, const Extras& extras, std::vector<Sampler>& samplers) {
  shd_material_desc desc = shd_material_desc_default();
  desc.model = model;
  desc.debug_view = options.debug_view;
  Slots slots;
  const bool replaced = extras.diffuse.get() && !surface.is_floor;
  for (size_t c = 0; c < 3; ++c) {
    desc.diffuse[c] = replaced           ? 1.0f
                      : surface.is_floor ? surface.diffuse[c]
                                         : options.diffuse.value_or(surface.diffuse)[c];
    desc.emission[c] = surface.emission[c];
  }
  set_lobe(desc, options, surface);
  set_blend(desc, surface);
  desc.normal_scale = surface.normal_scale;
  desc.occlusion_strength = surface.occlusion_strength;
  for (size_t i = 0; i < surface.maps.size(); ++i) {
    const Map& map = surface.maps[i];
    shd_texture* texture = map.texture >= 0 ? textures[static_cast<size_t>(map.texture)].get() : nullptr;
    if (!texture) continue;
    set_slot(slots, static_cast<shd_slot_target>(i), map, texture, make_sampler(context, options, map, samplers),
             options.uv_scale);
  }
  shd_sampler* sampler = make_sampler(context, options, Map{}, samplers);
  if (replaced) set_slot(slots, SHD_SLOT_DIFFUSE, Map{}, extras.diffuse.get(), sampler, options.uv_scale);
  if (!surface.is_floor) set_extras(desc, slots, options, extras, sampler);
  // Ambient light is reflected by the diffuse colour; metallic-roughness includes this itself.
  const bool metallic = model == SHD_MODEL_METALLIC_ROUGHNESS;
  for (size_t c = 0; c < 3; ++c) desc.ambient[c] = metallic ? 1.0f : desc.diffuse[c];
  if (!metallic) share_slot(slots, SHD_SLOT_DIFFUSE, SHD_SLOT_AMBIENT);
  desc.slots = slots.data();
  desc.slot_count = static_cast<uint32_t>(slots.size());
  Material material;
  check(shd_material_create(context, &desc, material.out()), "material \"" + surface.name + "\"");
  return material;
}
