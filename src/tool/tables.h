// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "tool/handles.h"
#include "tool/options.h"

/// Saves a table of the texture of the options as one picture. Throws Failure (kExitInput) for a file that cannot be
/// read.
void save_table(shd_context* context, const Options& options, const std::string& name);

/// Saves the depths of the first shadow of a list as greys, from black at the near plane to white at the far one: the
/// faces of a cube side by side, +X, -X, +Y, -Y, +Z, -Z. Throws Failure (kExitUsage) if no light casts a shadow.
void save_shadow_map(const std::vector<Shadow>& shadows, const Options& options, const std::string& name);
