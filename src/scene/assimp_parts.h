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

/// Declarations that the assimp_*.cpp files share.
namespace shd::scene {

/// Number of bytes that assimp has read from files, and the file that exceeded the budget.
struct FileBudget {
  uint64_t left = 0;
  std::string exceeded;  // path; empty = none
};

/// File access for assimp: regular files only, within a budget, read whole into memory. Reads fail after the deadline.
std::unique_ptr<Assimp::IOSystem> make_file_system(FileBudget& budget, const Deadline& deadline);

/// Removes everything from a fresh import that assimp's post-processing steps cannot handle (with or without their
/// asserts): only polygons with existing and finite vertices stay. Throws Failure beyond the limits and for a scene
/// without polygons.
void sanitize(aiScene& scene, const Limits& limits, Model& model);

/// Refuses a model of which nothing can be drawn. The message ends with the last warning about a mesh or a node.
[[noreturn]] void refuse_empty(const Model& model);

/// Whether the scene comes from glTF 2.0.
bool is_gltf2(const aiScene& scene);

/// A string of a file, made printable and short enough for a message.
std::string text_of(const char* text);

/// Reads the materials of a scene, and finds the textures that they name relative to the model's file.
void add_surfaces(const aiScene& scene, const std::string& path, Model& model);

/// The world matrix of the node with this name; identity if there is no such node.
aiMatrix4x4 world_of(const aiScene& scene, const std::string& name, const aiNode** node);

/// Reads lights and cameras. `radius` is the radius of the model: lights that do not decrease with the square of the
/// distance keep their strength at this distance.
void add_lights(const aiScene& scene, double radius, Model& model);
void add_cameras(const aiScene& scene, Model& model);

}  // namespace shd::scene
