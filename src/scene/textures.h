// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <shd/io.h>

#include "scene/limits.h"
#include "scene/model.h"
#include "scene/owned.h"

namespace shd::scene {

/// Loads the textures of a model, in its order; files are found from its folder. A texture that cannot be read is empty and gives a warning, or throws
/// Failure with `all_required`. Lack of memory and an exceeded budget always throw Failure.
std::vector<Texture> load_textures(shd_context* context, const std::string& folder, const Model& model,
                                   const shd_load_desc& load, bool all_required, const Limits& limits,
                                   const Deadline& deadline, std::vector<std::string>* warnings);

}  // namespace shd::scene
