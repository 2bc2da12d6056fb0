// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <shd/io.h>

#include "scene/limits.h"
#include "scene/model.h"
#include "scene/owned.h"

namespace shd::scene {

/// The textures of a model in its order, empty where one cannot be read: that is a warning, or with `all_required` a
/// Failure. Lack of memory and budgets of the scene always are.
std::vector<Texture> load_textures(shd_context* context, const Model& model, const shd_load_desc& load,
                                   bool all_required, const Limits& limits, const Deadline& deadline,
                                   std::vector<std::string>* warnings);

}  // namespace shd::scene
