// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <shd/io.h>
#include <shd/scene.h>

#include "scene/bounds.h"
#include "scene/deform.h"
#include "scene/host_files.h"
#include "scene/limits.h"
#include "scene/materials.h"
#include "scene/model.h"
#include "scene/owned.h"

namespace shd::scene {

/// Settings for all objects of a scene.
struct ObjectOptions {
  shd_sampler_desc sampler;  // wraps come from the model, and filters unless host_filters
  shd_load_desc load;        // tables of all textures
  uint32_t mesh_flags;
  bool all_textures_required;
  bool host_filters;
  shd_uv_projection uv_projection = SHD_UV_PROJECTION_NONE;  // rule for meshes without uv
};

/// The first and the last key of an animation [s].
struct Times {
  double first = 0, last = 0;
};

/// Objects that all poses of a scene share; they never change. Members point at each other, so Parts is never moved
/// or copied.
struct Parts {
  shd_context* context = nullptr;  // retained by each scene
  Model model;                     // without columns and bytes that no pose needs
  std::vector<Texture> textures;   // textures of the model, in its order; empty where a texture could not be read
  std::vector<shd_texture*> found_textures;
  std::vector<std::string> texture_names;  // paths of found_textures, in their order
  MaterialSet materials;
  std::vector<std::string> material_names;
  std::vector<MeshRow> rows;     // meshes
  std::vector<uint32_t> row_of;  // [placement]
  std::vector<Mesh> meshes;      // by rows; empty where a pose makes the mesh
  std::vector<std::string> mesh_names;
  std::vector<Times> animations;
  std::vector<std::string> animation_names;
  std::array<double, 3> origin = {0, 0, 0};  // world of the file = origin + world of shd
  uint32_t mesh_flags = 0;
  std::vector<std::string> warnings;
};

/// A scene in one pose. Its pointers lead to its parts, so Objects is never moved or copied.
struct Objects {
  std::shared_ptr<const Parts> parts;
  std::vector<Mesh> meshes;  // by Parts::rows
  std::vector<shd_light_desc> light_descs;
  std::vector<Light> lights;
  std::vector<const shd_light*> light_list;
  std::vector<std::string> light_names;
  std::vector<shd_camera> cameras;
  std::vector<std::string> camera_names;
  std::vector<shd_scene_instance> instances;
  std::vector<shd_draw> draws;  // one for each instance, in their order
  std::vector<std::string> warnings;
  uint64_t vertex_count = 0, triangle_count = 0;  // sums over all meshes
  Bounds bounds;                                  // without Parts::origin
};

/// Makes all objects in the pose of the file; `files` are those around the model. Throws Failure; all objects made
/// before are then released.
void make_objects(shd_context* context, HostFiles& files, Model&& model, const ObjectOptions& options,
                  const Limits& limits, const Deadline& deadline, Objects* out);

/// Makes the objects of a pose of an animation. Meshes without skins and morph targets are shared. Throws Failure.
void pose_objects(const std::shared_ptr<const Parts>& parts, uint32_t animation, double seconds, Objects* out);

}  // namespace shd::scene
