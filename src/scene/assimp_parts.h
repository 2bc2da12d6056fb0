// SPDX-License-Identifier: MIT
#pragma once

#include <assimp/matrix4x4.h>
#include <assimp/IOSystem.hpp>

#include <memory>
#include <string>

#include "scene/limits.h"
#include "scene/model.h"

struct aiNode;
struct aiScene;

/// What the assimp_*.cpp files share.
namespace shd::scene {

/// Bytes of files that assimp has read, and the file at which they were more than allowed.
struct FileBudget {
  uint64_t left = 0;
  std::string exceeded;  // path; empty = none
};

/// Regular files alone, within a budget, whole in memory. Reading them fails after the deadline.
std::unique_ptr<Assimp::IOSystem> make_file_system(FileBudget& budget, const Deadline& deadline);

/// Leaves of a fresh import what assimp's own steps can work on, with asserts in them or not: polygons whose vertices
/// are there and finite. Throws Failure beyond the limits and for a scene without polygons.
void sanitize(aiScene& scene, const Limits& limits, Model& model);

/// Refuses a model of which nothing can be drawn. The message ends with the last warning about a mesh or a node.
[[noreturn]] void refuse_empty(const Model& model);

/// Whether the scene comes from glTF 2.0.
bool is_gltf2(const aiScene& scene);

/// A text of a file, printable and not too long for a message.
std::string text_of(const char* text);

/// The materials of a scene, and the textures that they name, found from the place of the model's file.
void add_surfaces(const aiScene& scene, const std::string& path, Model& model);

/// The world matrix of the node of that name; identity if there is none.
aiMatrix4x4 world_of(const aiScene& scene, const std::string& name, const aiNode** node);

/// Lights and cameras. `radius` is that of the model: lights that do not fade with the square of the distance get the
/// strength that they have there.
void add_lights(const aiScene& scene, double radius, Model& model);
void add_cameras(const aiScene& scene, Model& model);

}  // namespace shd::scene
