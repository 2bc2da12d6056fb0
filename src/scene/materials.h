// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "scene/model.h"
#include "scene/owned.h"

namespace shd::scene {

/// Surfaces as materials; rows of all vectors are those of Model::surfaces.
struct MaterialSet {
  std::vector<Sampler> samplers;
  std::vector<std::vector<shd_slot>> slots;
  std::vector<shd_material_desc> descs;
  std::vector<Material> materials;
};

/// The desc of a surface, without slots.
shd_material_desc desc_of(const Surface& surface);

/// The host's sampler with the wraps of a map and, if `host_filters` is not set, the filters of its file.
shd_sampler_desc sampler_of(const Map& map, shd_sampler_desc host, bool host_filters);

/// Makes all materials. `textures` are those of the model, in its order; an empty one leaves its slots out. Adds a
/// warning for each property that the material has not.
void make_materials(shd_context* context, const Model& model, const std::vector<Texture>& textures,
                    const shd_sampler_desc& host, bool host_filters, MaterialSet* out,
                    std::vector<std::string>* warnings);

}  // namespace shd::scene
