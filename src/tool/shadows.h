// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "tool/draws.h"
#include "tool/handles.h"
#include "tool/lights.h"

/// Renders the shadows of the lights, in their order; entries of lights without a shadow are empty. Returns an empty
/// list without `--shadows`.
std::vector<Shadow> make_shadows(shd_context* context, const Options& options, const Bounds& bounds, const Draws& draws,
                                 const std::vector<StageLight>& lights);
