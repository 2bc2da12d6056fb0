// SPDX-License-Identifier: MIT
#include "scene.h"

#include <algorithm>
#include <cstdio>

#include "failure.h"
#include "textures.h"

namespace {

void set_uv(shd_f32_in out[2], const std::vector<float>& uv) {
  for (size_t c = 0; c < 2 && !uv.empty(); ++c) out[c] = {uv.data() + c, 2 * sizeof(float)};
}

Mesh make_mesh(shd_context* context, const Geometry& geometry) {
  shd_mesh_desc desc = shd_mesh_desc_default();
  desc.vertex_count = static_cast<uint32_t>(geometry.position.size() / 3);
  for (size_t c = 0; c < 3; ++c) {
    desc.position[c] = {geometry.position.data() + c, 3 * sizeof(float)};
    if (!geometry.normal.empty()) desc.normal[c] = {geometry.normal.data() + c, 3 * sizeof(float)};
  }
  set_uv(desc.uv, geometry.uv);
  set_uv(desc.uv1, geometry.uv1);
  desc.indices.data = geometry.indices.data();
  desc.index_count = geometry.indices.size();
  Mesh mesh;
  check(shd_mesh_create(context, &desc, mesh.out()), "mesh");
  return mesh;
}

void add_textures(shd_context* context, const Model& model, const Options& options, Scene& scene) {
  for (const TextureSource& source : model.textures) {
    Texture texture;
    if (options.texture.empty() && !load_texture(context, source, texture)) {
      std::fprintf(stderr, "shd-render: %s: %s; its material is plain\n", source.path.c_str(), shd_last_error());
    }
    scene.textures.push_back(std::move(texture));
  }
}

}  // namespace

Scene make_scene(shd_context* context, const Model& model, const Options& options) {
  Scene scene;
  add_textures(context, model, options, scene);
  scene.extras = make_extras(context, options);
  const shd_model reflectance = model_of(options, model);
  for (const Surface& surface : model.surfaces) {
    scene.materials.push_back(
        make_material(context, options, reflectance, surface, scene.textures, scene.extras, scene.samplers));
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
