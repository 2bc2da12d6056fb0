// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <shd/io.h>

#include "scene/host_files.h"
#include "scene/limits.h"
#include "scene/model.h"
#include "scene/owned.h"

namespace shd::scene {

/// Loads the textures of a model, in its order, and behind them those of converted surfaces (specular_glossiness.h). A
/// texture that cannot be read is empty and gives a warning, or throws Failure with `all_required`; `names` gets those
/// of the others: the path of a file, or the name in the model. Lack of memory and an exceeded budget always throw
/// Failure.
std::vector<Texture> load_textures(shd_context* context, HostFiles& files, Model& model, const shd_load_desc& load,
                                   bool all_required, const Limits& limits, const Deadline& deadline,
                                   std::vector<std::string>* names, std::vector<std::string>* warnings);

}  // namespace shd::scene
