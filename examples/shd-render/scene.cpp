// SPDX-License-Identifier: MIT
#include "scene.h"

#include <algorithm>
#include <cstdio>

#include "failure.h"
#include "textures.h"

namespace {

Mesh make_mesh(shd_context* context, const Geometry& geometry) {
  shd_mesh_desc desc = shd_mesh_desc_default();
  desc.vertex_count = static_cast<uint32_t>(geometry.position.size() / 3);
  for (size_t c = 0; c < 3; ++c) {
    desc.position[c] = {geometry.position.data() + c, 3 * sizeof(float)};
    if (!geometry.normal.empty()) desc.normal[c] = {geometry.normal.data() + c, 3 * sizeof(float)};
  }
  for (size_t c = 0; c < 2; ++c) {
    if (!geometry.uv.empty()) desc.uv[c] = {geometry.uv.data() + c, 2 * sizeof(float)};
  }
  desc.indices.data = geometry.indices.data();
  desc.index_count = geometry.indices.size();
  Mesh mesh;
  check(shd_mesh_create(context, &desc, mesh.out()), "mesh");
  return mesh;
}

Sampler make_sampler(shd_context* context, const Options& options, const Surface& surface) {
  shd_sampler_desc desc = shd_sampler_desc_default();
  desc.filter = options.filter;
  desc.wrap_u = static_cast<shd_wrap>(surface.wrap_u);
  desc.wrap_v = static_cast<shd_wrap>(surface.wrap_v);
  Sampler sampler;
  check(shd_sampler_create(context, &desc, sampler.out()), "sampler");
  return sampler;
}

/// shd's ambient term has its own colour, which no texture multiplies: use the texture's average there.
Material make_material(shd_context* context, const Options& options, const Surface& surface, shd_texture* texture,
                       shd_sampler* sampler) {
  shd_material_desc desc = shd_material_desc_default();
  const std::array<float, 3> average = texture ? average_color(context, texture) : std::array<float, 3>{1, 1, 1};
  desc.model = options.reflectance;
  desc.exponent = options.exponent.value_or(surface.exponent);
  for (size_t c = 0; c < 3; ++c) {
    desc.diffuse[c] = surface.diffuse[c];
    desc.ambient[c] = surface.diffuse[c] * average[c];
    desc.specular[c] = options.specular.value_or(surface.specular[c]);
  }
  if (texture) {
    desc.slot[SHD_SLOT_DIFFUSE].source = SHD_SOURCE_TEXTURE;
    desc.slot[SHD_SLOT_DIFFUSE].texture = texture;
    desc.slot[SHD_SLOT_DIFFUSE].sampler = sampler;
  }
  Material material;
  check(shd_material_create(context, &desc, material.out()), "material \"" + surface.name + "\"");
  return material;
}

void add_textures(shd_context* context, const Model& model, const Options& options, Scene& scene) {
  for (const TextureSource& source : model.textures) {
    Texture texture;
    if (options.texture.empty() && !load_texture(context, source, texture)) {
      std::fprintf(stderr, "shd-render: %s: %s; its material is plain\n", source.path.c_str(), shd_last_error());
    }
    scene.textures.push_back(std::move(texture));
  }
  if (options.texture == "checker") {
    scene.textures.push_back(make_checker(context));
  } else if (!options.texture.empty()) {
    TextureSource source;
    source.path = options.texture;
    Texture texture;
    if (!load_texture(context, source, texture)) throw Failure(kExitInput, source.path + ": " + shd_last_error());
    scene.textures.push_back(std::move(texture));
  }
}

}  // namespace

Scene make_scene(shd_context* context, const Model& model, const Options& options) {
  Scene scene;
  add_textures(context, model, options, scene);
  for (Surface surface : model.surfaces) {
    shd_texture* texture = surface.texture >= 0 ? scene.textures[static_cast<size_t>(surface.texture)].get() : nullptr;
    if (!options.texture.empty()) {
      texture = scene.textures.back().get();
      surface.diffuse = {1, 1, 1};
    }
    scene.samplers.push_back(make_sampler(context, options, surface));
    scene.materials.push_back(make_material(context, options, surface, texture, scene.samplers.back().get()));
  }
  for (const Geometry& geometry : model.geometries) scene.meshes.push_back(make_mesh(context, geometry));
  for (const Instance& instance : model.instances) {
    shd_draw draw = shd_draw_default();
    draw.mesh = scene.meshes[instance.geometry].get();
    draw.material = scene.materials[instance.surface].get();
    draw.frequency = options.frequency;
    std::copy(instance.object_to_world.begin(), instance.object_to_world.end(), draw.object_to_world);
    scene.draws.push_back(draw);
  }
  return scene;
}
