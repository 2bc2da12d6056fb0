// SPDX-License-Identifier: MIT
#pragma once

#include <shd/io.h>

#include "scene/bounds.h"
#include "scene/limits.h"
#include "scene/model.h"
#include "scene/owned.h"

namespace shd::scene {

/// Settings for all objects of a scene.
struct ObjectOptions {
  shd_sampler_desc sampler;  // wraps come from the model
  shd_load_desc load;        // tables of all textures
  uint32_t mesh_flags;
  bool all_textures_required;
};

/// A model as handles, and the data that they were made from. Members point at each other, so Objects is never moved or
/// copied.
struct Objects {
  std::vector<Texture> textures;  // textures of the model, in its order; empty where a texture could not be read
  std::vector<shd_texture*> found_textures;
  std::vector<std::string> texture_names;  // paths of found_textures, in their order
  std::vector<Sampler> samplers;
  std::vector<std::vector<shd_slot>> material_slots;  // slots of each material
  std::vector<shd_material_desc> material_descs;
  std::vector<Material> materials;
  std::vector<std::string> material_names;
  std::vector<Mesh> meshes;
  std::vector<std::string> mesh_names;
  std::vector<shd_light_desc> light_descs;
  std::vector<Light> lights;
  std::vector<const shd_light*> light_list;
  std::vector<std::string> light_names;
  std::vector<shd_camera> cameras;
  std::vector<std::string> camera_names;
  std::vector<Instance> instances;
  std::vector<shd_draw> draws;  // one for each instance, in their order
  std::vector<std::string> warnings;
  uint64_t vertex_count = 0, triangle_count = 0;  // sums over all meshes
  Bounds bounds;
};

/// Makes all objects; `folder` is that of the model. Throws Failure; all objects made before are then released.
void make_objects(shd_context* context, const std::string& folder, Model&& model, const ObjectOptions& options,
                  const Limits& limits, const Deadline& deadline, Objects* out);

}  // namespace shd::scene
