// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "camera.h"
#include "handles.h"

/// Lights of the preset, which stand around the camera, and of the command line, which stand around the model.
std::vector<Light> make_lights(shd_context* context, const Options& options, const Bounds& bounds,
                               const Camera& camera);
