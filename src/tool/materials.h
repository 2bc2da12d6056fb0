// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "tool/handles.h"
#include "tool/model.h"
#include "tool/options.h"
#include "tool/textures.h"

/// Textures of the command line, and objects that all materials share.
struct Extras {
  Texture diffuse, height, matcap;
  NormalMap normal;
  std::optional<shd_solid_desc> solid;  // instead of `diffuse`
  shd_slot uv = shd_slot_default();     // coordinates of `diffuse` and `normal`
};

/// Loads the files that the options name. Throws Failure (kExitInput) for a file that cannot be read.
/// @param uv  coordinates of the textures: uv_slot()
Extras make_extras(shd_context* context, const Options& options, const shd_slot& uv);

/// Whether a surface of the file keeps its model: unlit, and glass where an environment is seen through it.
bool keeps_model(const Options& options, shd_model model);

/// The reflectance model for surfaces: the model of the options, otherwise metallic-roughness if the importer found it,
/// otherwise Blinn-Phong.
shd_model model_of(const Options& options, const Model& model);

/// Makes the material of a surface. Its samplers are added to `samplers`; `diffuse` becomes its slot of the diffuse
/// colour, constant without one.
Material make_material(shd_context* context, const Options& options, shd_model model, const Surface& surface,
                       const Extras& extras, std::vector<Sampler>& samplers, shd_slot& diffuse);
