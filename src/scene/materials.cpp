// SPDX-License-Identifier: MIT
#include "scene/materials.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "extension/error.h"

namespace shd::scene {
namespace {

using extension::require;

/// State that the functions share while the materials of one scene are made.
struct Maker {
  shd_context* context;
  const std::vector<Texture>& textures;
  const shd_sampler_desc& host;
  bool host_filters;
  MaterialSet& out;
  std::map<std::tuple<int, int, int, int>, shd_sampler*> known;  // by wraps and filters
};

shd_sampler* make_sampler(Maker& maker, const Map& map) {
  const shd_sampler_desc desc = sampler_of(map, maker.host, maker.host_filters);
  shd_sampler*& known = maker.known[{desc.wrap_u, desc.wrap_v, desc.filter, desc.magnification}];
  if (known) return known;
  Sampler sampler;
  require(shd_sampler_create(maker.context, &desc, sampler.out()));
  known = sampler.get();
  maker.out.samplers.push_back(std::move(sampler));
  return known;
}

/// Light has no effect on unlit surfaces.
bool is_used(const Surface& surface, size_t target) {
  return !surface.unlit || target == SHD_SLOT_DIFFUSE || target == SHD_SLOT_OPACITY;
}

/// The slots of a surface, at most one for each target.
std::vector<shd_slot> slots_of(Maker& maker, const Surface& surface, bool has_colors) {
  std::vector<shd_slot> slots;
  for (size_t target = 0; target < surface.maps.size(); ++target) {
    const Map& map = surface.maps[target];
    shd_texture* texture = map.texture >= 0 ? maker.textures[static_cast<size_t>(map.texture)].get() : nullptr;
    if (!texture || !is_used(surface, target)) continue;
    shd_slot slot = shd_slot_texture(static_cast<shd_slot_target>(target), texture, make_sampler(maker, map));
    slot.uv_set = map.uv_set;
    slot.channel = map.channel;
    std::copy(map.uv_transform.begin(), map.uv_transform.end(), slot.uv_transform);
    slots.push_back(slot);
  }
  if (has_colors) slots.push_back(shd_slot_vertex(SHD_SLOT_TINT, 0));
  return slots;
}

/// The exponent of a Blinn-Phong lobe with the width of a GGX lobe, p = 2 / alpha^2 - 2 with alpha = roughness^2, and
/// the inverse function.
float exponent_of(float roughness) {
  const float alpha = std::max(roughness * roughness, 0.01f);
  return std::max(2.0f / (alpha * alpha) - 2.0f, 0.0f);
}

float roughness_of(float exponent) {
  return std::sqrt(std::sqrt(2.0f / (exponent + 2.0f)));
}

constexpr float kGlass = 0.5f;  // least transmission of SHD_MODEL_GLASS

/// SHD_MODEL_GLASS is whole: it cannot be mixed with an opaque surface, and metals transmit nothing. With a map
/// the metallic factor alone decides nothing: the map is 0 where light passes.
bool is_glass(const Surface& surface) {
  const bool is_metal = surface.metallic >= 0.5f && surface.maps[SHD_SLOT_METALLIC].texture < 0;
  return surface.transmission >= kGlass && !is_metal && !surface.unlit;
}

shd_model model_of(const Surface& surface) {
  if (surface.unlit) return SHD_MODEL_UNLIT;
  if (is_glass(surface)) return SHD_MODEL_GLASS;
  return surface.metallic_roughness ? SHD_MODEL_METALLIC_ROUGHNESS : SHD_MODEL_BLINN_PHONG;
}

void set_alpha(const Surface& surface, shd_material_desc* desc) {
  desc->opacity = std::clamp(surface.opacity, 0.0f, 1.0f);
  if (surface.alpha == Alpha::kBlend) desc->blend = SHD_BLEND_SORTED;
  if (surface.alpha != Alpha::kMask) return;
  desc->alpha_cutoff = std::clamp(surface.alpha_cutoff, 0.0f, 1.0f);
  if (surface.alpha_cutoff > 1.0f) desc->opacity = 0.0f;  // no alpha reaches the cutoff
}

/// The surfaces that a geometry with colours uses.
std::vector<bool> find_colored(const Model& model) {
  std::vector<bool> colored(model.surfaces.size());
  for (const Placement& placement : model.placements) {
    if (!model.geometries[placement.geometry].color.empty()) colored[placement.surface] = true;
  }
  return colored;
}

}  // namespace

shd_material_desc desc_of(const Surface& surface) {
  shd_material_desc desc = shd_material_desc_default();
  const bool metallic = surface.metallic_roughness;
  desc.model = model_of(surface);
  for (size_t c = 0; c < 3; ++c) {
    desc.diffuse[c] = surface.diffuse[c];
    desc.specular[c] = surface.specular[c];
    desc.emission[c] = surface.unlit ? 0.0f : surface.emission[c];
  }
  desc.ambient_share = 1.0f;  // ambient light is reflected by the diffuse colour
  desc.clearcoat = surface.clearcoat;
  desc.clearcoat_roughness = surface.clearcoat_roughness;
  desc.exponent = metallic ? exponent_of(surface.roughness) : surface.exponent;
  desc.roughness = metallic ? surface.roughness : roughness_of(surface.exponent);
  desc.metallic = surface.metallic;
  desc.ior = surface.ior > 0.0f ? std::clamp(surface.ior, 1.0f, 10.0f) : 10.0f;  // KHR_materials_ior: 0 reflects all
  desc.normal_scale = surface.normal_scale;
  desc.occlusion_strength = surface.occlusion_strength;
  if (surface.double_sided) desc.flags |= SHD_MATERIAL_DOUBLE_SIDED;
  if (surface.bump_scale != 0.0f && surface.maps[SHD_SLOT_HEIGHT].texture >= 0) {
    desc.bump = SHD_BUMP_GRADIENT;
    desc.bump_scale = std::clamp(surface.bump_scale, -1e6f, 1e6f);
  }
  set_alpha(surface, &desc);
  return desc;
}

shd_sampler_desc sampler_of(const Map& map, shd_sampler_desc host, bool host_filters) {
  host.wrap_u = static_cast<shd_wrap>(map.wrap_u);
  host.wrap_v = static_cast<shd_wrap>(map.wrap_v);
  if (host_filters) return host;
  const bool nearest = map.minify == Filter::kNearest;
  if (map.no_mip) {
    host.filter = nearest ? SHD_FILTER_NEAREST : SHD_FILTER_BILINEAR;
  } else if (nearest) {
    host.filter = map.mip == Filter::kLinear ? SHD_FILTER_NEAREST_MIP_LINEAR : SHD_FILTER_NEAREST_MIP;
  } else if (map.mip == Filter::kNearest) {
    host.filter = SHD_FILTER_BILINEAR_MIP;
  }  // else linear in all respects: the host's filter is at least as good
  if (map.magnify == Filter::kNearest) host.magnification = SHD_MAGNIFICATION_NEAREST;
  const bool sharp = host.filter == SHD_FILTER_NEAREST || host.filter == SHD_FILTER_NEAREST_MIP ||
                     host.filter == SHD_FILTER_NEAREST_MIP_LINEAR;
  if (map.magnify == Filter::kLinear && sharp) host.magnification = SHD_MAGNIFICATION_BILINEAR;
  return host;
}

void make_materials(shd_context* context, const Model& model, const std::vector<Texture>& textures,
                    const shd_sampler_desc& host, bool host_filters, MaterialSet* out,
                    std::vector<std::string>* warnings) {
  Maker maker = {context, textures, host, host_filters, *out, {}};
  const std::vector<bool> colored = find_colored(model);
  out->descs.reserve(model.surfaces.size());
  for (size_t i = 0; i < model.surfaces.size(); ++i) {
    const Surface& surface = model.surfaces[i];
    out->slots.push_back(slots_of(maker, surface, colored[i]));
    shd_material_desc desc = desc_of(surface);
    desc.slots = out->slots.back().data();
    desc.slot_count = static_cast<uint32_t>(out->slots.back().size());
    out->descs.push_back(desc);
    Material material;
    require(shd_material_create(context, &desc, material.out()));
    out->materials.push_back(std::move(material));
    if (surface.transmission > 0.0f && desc.model != SHD_MODEL_GLASS) {
      const char* const why = surface.unlit                   ? "it is unlit"
                              : surface.transmission < kGlass ? "less than half of the light passes"
                                                              : "it is a metal";
      warnings->push_back("material \"" + surface.name + "\": its transmission is left out: " + why);
    }
  }
}

}  // namespace shd::scene
