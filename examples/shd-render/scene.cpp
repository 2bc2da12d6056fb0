// SPDX-License-Identifier: MIT
#include "scene.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "failure.h"
#include "textures.h"

namespace {

void set_uv(shd_f32_in out[2], const std::vector<float>& uv) {
  for (size_t c = 0; c < 2 && !uv.empty(); ++c) out[c] = {uv.data() + c, 2 * sizeof(float)};
}

Mesh make_mesh(shd_context* context, const Options& options, const Geometry& geometry) {
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
  if (!geometry.uv.empty()) desc.flags |= SHD_MESH_TANGENTS;
  if (options.line_width > 0.0f) desc.flags |= SHD_MESH_ADJACENCY;
  Mesh mesh;
  check(shd_mesh_create(context, &desc, mesh.out()), "mesh");
  return mesh;
}

/// Tessellates the mesh of an instance into triangles of a few pixels and displaces them by the heights.
Mesh displace(shd_context* context, const Options& options, const Camera& camera, const Instance& instance,
              const Mesh& mesh, const shd_texture* height) {
  shd_tessellation_desc desc = shd_tessellation_desc_default();
  desc.mode = SHD_TESSELLATION_MODE_ADAPTIVE;
  desc.max_segments = 512;
  desc.edge_length = options.edge_length;
  desc.width = options.width;
  desc.height = options.height;
  desc.view = &camera.view;
  desc.object_to_world = instance.object_to_world.data();
  desc.displacement = height;
  desc.amplitude = options.displacement;
  desc.lod = 2.0f;  // mean of some texels: single texels are finer than the triangles
  Mesh displaced;
  check(shd_mesh_tessellate(context, mesh.get(), &desc, displaced.out()), "displacement");
  return displaced;
}

/// Adds lines on top of the surfaces, whose depth is biased away from them.
void add_lines(shd_context* context, const Options& options, Scene& scene) {
  shd_material_desc ink = shd_material_desc_default();
  ink.model = SHD_MODEL_UNLIT;
  for (float& c : ink.diffuse) c = 0.01f;
  Material material;
  check(shd_material_create(context, &ink, material.out()), "ink");
  for (size_t i = 0; i < scene.solid_count; ++i) {
    shd_draw line = scene.draws[i];
    scene.draws[i].depth_bias = 1e-5f;
    scene.draws[i].depth_bias_slope = 0.5f * options.line_width + 1.0f;
    line.material = material.get();
    line.fill = SHD_FILL_LINES;
    line.fill_width = options.line_width;
    line.edges = SHD_EDGE_SILHOUETTE | SHD_EDGE_CREASE | SHD_EDGE_BORDER;
    line.crease_cosine = std::cos(options.crease * 3.14159265f / 180.0f);
    line.compare = SHD_COMPARE_LESS_EQUAL;
    scene.draws.push_back(line);
  }
  scene.materials.push_back(std::move(material));
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

Scene make_scene(shd_context* context, const Model& model, const Options& options, const Camera& camera) {
  Scene scene;
  add_textures(context, model, options, scene);
  scene.extras = make_extras(context, options);
  const shd_model reflectance = model_of(options, model);
  for (const Surface& surface : model.surfaces) {
    scene.materials.push_back(
        make_material(context, options, reflectance, surface, scene.textures, scene.extras, scene.samplers));
  }
  for (const Geometry& geometry : model.geometries) scene.meshes.push_back(make_mesh(context, options, geometry));
  for (const Instance& instance : model.instances) {
    shd_draw draw = shd_draw_default();
    draw.mesh = scene.meshes[instance.geometry].get();
    if (options.displacement != 0.0f && !model.surfaces[instance.surface].is_floor) {
      const Mesh& flat = scene.meshes[instance.geometry];
      scene.displaced.push_back(displace(context, options, camera, instance, flat, scene.extras.height.get()));
      draw.mesh = scene.displaced.back().get();
    }
    draw.material = scene.materials[instance.surface].get();
    draw.frequency = options.frequency;
    std::copy(instance.object_to_world.begin(), instance.object_to_world.end(), draw.object_to_world);
    scene.draws.push_back(draw);
  }
  scene.solid_count = scene.draws.size();
  if (options.line_width > 0.0f) add_lines(context, options, scene);
  return scene;
}
