// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "tool/handles.h"
#include "tool/model.h"
#include "tool/options.h"

/// Textures that the command line puts on the model, and what every material shares.
struct Extras {
  Texture diffuse, normal, height, matcap;
};

/// Loads what the options name; throws Failure (kExitInput) for what cannot be read.
Extras make_extras(shd_context* context, const Options& options);

/// The model that surfaces are shaded with: that of the options, else metallic-roughness where the importer found it,
/// else Blinn-Phong.
shd_model model_of(const Options& options, const Model& model);

/// The material of a surface. Its samplers go to `samplers`.
Material make_material(shd_context* context, const Options& options, shd_model model, const Surface& surface,
                       const Extras& extras, std::vector<Sampler>& samplers);
