// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "camera.h"
#include "handles.h"
#include "materials.h"
#include "model.h"
#include "options.h"

/// A model as shd objects, ready for shd_render_desc.
struct Scene {
  std::vector<Texture> textures;  // textures of the model
  Extras extras;                  // textures of the options
  std::vector<Sampler> samplers;  // samplers of the materials
  std::vector<Material> materials;
  std::vector<Mesh> meshes;
  std::vector<Mesh> displaced;  // meshes of displaced instances
  std::vector<shd_draw> draws;  // surfaces, then lines
  size_t solid_count = 0;       // number of surface draws
};

/// Loads the textures and creates all shd objects. A texture of the model that cannot be read is reported on stderr and
/// left out. A texture of the options that cannot be read is a Failure.
Scene make_scene(shd_context* context, const Model& model, const Options& options, const Camera& camera);
