// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "tool/draws.h"
#include "tool/handles.h"
#include "tool/lights.h"

/// Shadows of the lights in their order, empty for those that have none, drawn from the surfaces. None at all without
/// `--shadows`.
std::vector<Shadow> make_shadows(shd_context* context, const Options& options, const Bounds& bounds, const Draws& draws,
                                 const std::vector<StageLight>& lights);
