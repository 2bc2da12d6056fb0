// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "handles.h"
#include "lights.h"
#include "scene.h"

/// Shadows of the lights in their order, empty for those that have none, drawn from the scene. None at all without
/// `--shadows`.
std::vector<Shadow> make_shadows(shd_context* context, const Options& options, const Bounds& bounds, const Scene& scene,
                                 const std::vector<StageLight>& lights);
