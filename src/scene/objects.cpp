// SPDX-License-Identifier: MIT
#include "scene/objects.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "extension/error.h"
#include "scene/textures.h"

namespace shd::scene {
namespace {

using extension::require;

/// State that the functions share while one scene is made.
struct Maker {
  shd_context* context;
  const ObjectOptions& options;
  Objects& out;
  std::map<std::pair<int, int>, shd_sampler*> sampler_of;  // by wraps
};

shd_sampler* sampler_of(Maker& maker, const Map& map) {
  shd_sampler*& known = maker.sampler_of[{map.wrap_u, map.wrap_v}];
  if (known) return known;
  shd_sampler_desc desc = maker.options.sampler;
  desc.wrap_u = static_cast<shd_wrap>(map.wrap_u);
  desc.wrap_v = static_cast<shd_wrap>(map.wrap_v);
  Sampler sampler;
  require(shd_sampler_create(maker.context, &desc, sampler.out()));
  known = sampler.get();
  maker.out.samplers.push_back(std::move(sampler));
  return known;
}

/// The slots of a surface, at most one for each target.
std::vector<shd_slot> slots_of(Maker& maker, const Surface& surface) {
  std::vector<shd_slot> slots;
  for (size_t target = 0; target < surface.maps.size(); ++target) {
    const Map& map = surface.maps[target];
    shd_texture* texture = map.texture >= 0 ? maker.out.textures[static_cast<size_t>(map.texture)].get() : nullptr;
    if (!texture) continue;
    shd_slot slot = shd_slot_texture(static_cast<shd_slot_target>(target), texture, sampler_of(maker, map));
    slot.uv_set = map.uv_set;
    slot.channel = map.channel;
    std::copy(map.uv_transform.begin(), map.uv_transform.end(), slot.uv_transform);
    slots.push_back(slot);
  }
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

shd_material_desc desc_of(const Surface& surface) {
  shd_material_desc desc = shd_material_desc_default();
  const bool metallic = surface.metallic_roughness;
  desc.model = metallic ? SHD_MODEL_METALLIC_ROUGHNESS : SHD_MODEL_BLINN_PHONG;
  for (size_t c = 0; c < 3; ++c) {
    desc.diffuse[c] = surface.diffuse[c];
    desc.specular[c] = surface.specular[c];
    desc.emission[c] = surface.emission[c];
  }
  desc.ambient_share = 1.0f;  // ambient light is reflected by the diffuse colour
  desc.clearcoat = surface.clearcoat;
  desc.clearcoat_roughness = surface.clearcoat_roughness;
  desc.exponent = metallic ? exponent_of(surface.roughness) : surface.exponent;
  desc.roughness = metallic ? surface.roughness : roughness_of(surface.exponent);
  desc.metallic = surface.metallic;
  desc.normal_scale = surface.normal_scale;
  desc.occlusion_strength = surface.occlusion_strength;
  if (surface.double_sided) desc.flags |= SHD_MATERIAL_DOUBLE_SIDED;
  if (surface.alpha == Alpha::kMask) desc.alpha_cutoff = surface.alpha_cutoff;
  if (surface.alpha == Alpha::kBlend) desc.blend = SHD_BLEND_SORTED;
  desc.opacity = surface.opacity;
  return desc;
}

void add_materials(Maker& maker, const std::vector<Surface>& surfaces) {
  maker.out.material_descs.reserve(surfaces.size());
  for (const Surface& surface : surfaces) {
    maker.out.material_slots.push_back(slots_of(maker, surface));
    shd_material_desc desc = desc_of(surface);
    desc.slots = maker.out.material_slots.back().data();
    desc.slot_count = static_cast<uint32_t>(maker.out.material_slots.back().size());
    maker.out.material_descs.push_back(desc);
    Material material;
    require(shd_material_create(maker.context, &desc, material.out()));
    maker.out.materials.push_back(std::move(material));
    maker.out.material_names.push_back(surface.name);
  }
}

void set_columns(shd_f32_in* out, size_t count, const std::vector<float>& from) {
  for (size_t c = 0; c < count && !from.empty(); ++c) out[c] = {from.data() + c, count * sizeof(float)};
}

void add_meshes(Maker& maker, const std::vector<Geometry>& geometries, const Deadline& deadline) {
  for (const Geometry& geometry : geometries) {
    deadline.check();
    shd_mesh_desc desc = shd_mesh_desc_default();
    desc.vertex_count = static_cast<uint32_t>(geometry.position.size() / 3);
    set_columns(desc.position, 3, geometry.position);
    set_columns(desc.normal, 3, geometry.normal);
    set_columns(desc.uv, 2, geometry.uv);
    set_columns(desc.uv1, 2, geometry.uv1);
    desc.indices.data = geometry.indices.data();
    desc.index_count = geometry.indices.size();
    desc.flags = maker.options.mesh_flags | (geometry.uv.empty() ? 0u : uint32_t{SHD_MESH_TANGENTS});
    Mesh mesh;
    require(shd_mesh_create(maker.context, &desc, mesh.out()));
    maker.out.meshes.push_back(std::move(mesh));
    maker.out.mesh_names.push_back(geometry.name);
    maker.out.vertex_count += desc.vertex_count;
    maker.out.triangle_count += desc.index_count / 3;
  }
}

void add_lights(Maker& maker, const std::vector<NamedLight>& lights) {
  for (const NamedLight& named : lights) {
    Light light;
    require(shd_light_create(maker.context, &named.desc, light.out()));
    maker.out.light_list.push_back(light.get());
    maker.out.lights.push_back(std::move(light));
    maker.out.light_descs.push_back(named.desc);
    maker.out.light_names.push_back(named.name);
  }
}

/// Chooses near and far planes that enclose the whole model, if the file has no such planes.
void add_cameras(Maker& maker, const std::vector<NamedCamera>& cameras) {
  const Bounds& box = maker.out.bounds;
  const double radius = box.radius();
  for (const NamedCamera& named : cameras) {
    shd_camera camera = named.camera;
    double square = 0.0;
    for (int c = 0; c < 3; ++c) {
      const double away = static_cast<double>(camera.eye[c]) - 0.5 * (box.low[c] + box.high[c]);
      square += away * away;
    }
    const auto far_plane = static_cast<float>(std::min(std::sqrt(square) + 2.0 * radius, 1e30));
    if (!(camera.near_plane > 0.0f)) camera.near_plane = 1e-3f * far_plane;
    if (!(camera.far_plane > camera.near_plane)) camera.far_plane = std::max(far_plane, 2.0f * camera.near_plane);
    shd_view view;
    if (shd_view_from_camera(&camera, &view) != SHD_OK) {
      maker.out.warnings.push_back("camera \"" + named.name + "\": " + shd_last_error());
      continue;
    }
    maker.out.cameras.push_back(camera);
    maker.out.camera_names.push_back(named.name);
  }
}

void add_draws(Maker& maker) {
  for (const Instance& instance : maker.out.instances) {
    shd_draw draw = shd_draw_default();
    draw.mesh = maker.out.meshes[instance.geometry].get();
    draw.material = maker.out.materials[instance.surface].get();
    for (size_t i = 0; i < 16; ++i) draw.object_to_world[i] = static_cast<float>(instance.object_to_world[i]);
    maker.out.draws.push_back(draw);
  }
}

}  // namespace

void make_objects(shd_context* context, const std::string& folder, Model&& model, const ObjectOptions& options,
                  const Limits& limits, const Deadline& deadline, Objects* out) {
  Maker maker = {context, options, *out, {}};
  out->warnings = std::move(model.warnings);
  out->instances = place(model);
  out->bounds = bounds_of(model, out->instances);
  out->textures = load_textures(context, folder, model, options.load, options.all_textures_required, limits, deadline,
                                &out->warnings);
  for (size_t i = 0; i < out->textures.size(); ++i) {
    if (!out->textures[i].get()) continue;
    out->found_textures.push_back(out->textures[i].get());
    out->texture_names.push_back(model.textures[i].name);
  }
  add_materials(maker, model.surfaces);
  add_meshes(maker, model.geometries, deadline);
  add_lights(maker, model.lights);
  add_cameras(maker, model.cameras);
  add_draws(maker);
}

}  // namespace shd::scene
