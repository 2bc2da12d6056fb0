// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "model.h"

/// Reads a model from a file with assimp. Points and lines are left out; v grows downwards. Throws Failure (kExitInput)
/// if there is nothing to draw. Some damaged files make assimp end the process.
Model import_model(const std::string& path);
