// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "model.h"

/// A model from a file, through assimp. Points and lines are left out; v grows downwards.
/// Throws Failure (kExitInput) when there is nothing to draw. Some damaged files make assimp end the process.
Model import_model(const std::string& path);
