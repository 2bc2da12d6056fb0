// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "tool/camera.h"
#include "tool/materials.h"

/// Materials of a model; the floor's is among them.
struct Paint {
  Extras extras;
  std::vector<Sampler> samplers;
  std::vector<Material> materials;  // by surface
  std::vector<shd_slot> diffuse;    // by surface; their textures are those of the materials
  Material ink;                     // material of lines
};

/// @param uv  coordinates of the textures of the options: uv_slot()
Paint make_paint(shd_context* context, const Options& options, const Model& model, const shd_slot& uv);

/// The draws of a frame.
struct Draws {
  std::vector<Mesh> displaced;   // displaced meshes of instances
  std::vector<shd_draw> draws;   // surfaces, then lines
  std::vector<size_t> instance;  // instance of the model of each draw
  size_t solid_count = 0;        // number of draws that are surfaces
};

/// Makes the draws of a frame. Displaced meshes are subdivided for the distance of the camera.
Draws make_draws(shd_context* context, const Options& options, const Model& model, const Paint& paint,
                 const Camera& camera);
