// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "model.h"

struct aiScene;

/// Whether the scene comes from glTF 2.0.
bool is_gltf2(const aiScene& scene);

/// Adds the materials of a scene and their textures, which are searched from the folder of the model's file.
void add_surfaces(const aiScene& scene, const std::string& path, Model& model);
