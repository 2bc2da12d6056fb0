// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "tool/camera.h"
#include "tool/materials.h"

/// Materials of a model; the floor's is among them.
struct Paint {
  Extras extras;
  std::vector<Sampler> samplers;
  std::vector<Material> materials;
  Material ink;  // of lines
};

Paint make_paint(shd_context* context, const Options& options, const Model& model);

/// What a frame draws.
struct Draws {
  std::vector<Mesh> displaced;  // of instances
  std::vector<shd_draw> draws;  // surfaces, then lines
  size_t solid_count = 0;       // of surfaces
};

/// Displaced meshes are as fine as the camera needs them.
Draws make_draws(shd_context* context, const Options& options, const Model& model, const Paint& paint,
                 const Camera& camera);
