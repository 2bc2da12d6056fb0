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
  std::vector<Texture> textures;  // of the model
  Extras extras;                  // of the options
  std::vector<Sampler> samplers;  // of the materials
  std::vector<Material> materials;
  std::vector<Mesh> meshes;
  std::vector<Mesh> displaced;  // of instances
  std::vector<shd_draw> draws;  // surfaces, then lines
  size_t solid_count = 0;       // of surfaces
};

/// Loads the textures and hands everything to shd. A texture of the model that cannot be read is reported on stderr
/// and left out; one of the options that cannot be read is a Failure.
Scene make_scene(shd_context* context, const Model& model, const Options& options, const Camera& camera);
