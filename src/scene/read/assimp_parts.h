// SPDX-License-Identifier: MIT
#pragma once

#include <assimp/matrix4x4.h>
#include <assimp/IOSystem.hpp>

#include <memory>
#include <optional>
#include <string>

#include "scene/read/read.h"
#include "scene/read/warnings.h"
#include "scene/text.h"

struct aiScene;

/// Declarations that the assimp_*.cpp files share.
namespace shd::scene {

/// Files of the source for assimp, which calls the model by its name. Reads fail after the deadline. assimp hides
/// exceptions: the first Failure of Files is kept in `failure`.
std::unique_ptr<Assimp::IOSystem> make_file_system(const Source& source, std::optional<core::Failure>& failure);

/// Removes everything from a fresh import that assimp's post-processing steps cannot handle (with or without their
/// asserts): only polygons with existing and finite vertices stay, and meshes that have some. Throws Failure beyond the
/// limits and for a scene without polygons.
void sanitize(aiScene& scene, const Limits& limits, Model& model);

/// Name of the format, as assimp's readers call it.
std::string format_of(const aiScene& scene);

/// Reads the materials of a scene, and the textures that they name.
void add_surfaces(const aiScene& scene, Model& model);

/// The world matrix of the node with this name; identity if there is no such node.
aiMatrix4x4 world_of(const aiScene& scene, const std::string& name);

/// Reads lights and cameras. `radius` is the radius of the model: lights that do not decrease with the square of the
/// distance keep their strength at this distance.
void add_lights(const aiScene& scene, double radius, Model& model);
void add_cameras(const aiScene& scene, Model& model);

}  // namespace shd::scene
