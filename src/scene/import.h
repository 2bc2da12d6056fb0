// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "scene/limits.h"
#include "scene/model.h"

namespace shd::scene {

/// A model from a file, through assimp. Points and lines are left out; v grows downwards. Throws Failure if there is
/// nothing to draw or a budget is exceeded. Some damaged files make assimp terminate the process.
Model import_file(const std::string& path, const Limits& limits, const Deadline& deadline);

}  // namespace shd::scene
