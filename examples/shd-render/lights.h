// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "camera.h"
#include "handles.h"

/// Lights of the preset, which stand around the camera, and of the command line, which stand around the model, as
/// strong as surfaces of that model of reflectance need them.
std::vector<Light> make_lights(shd_context* context, const Options& options, shd_model model, const Bounds& bounds,
                               const Camera& camera);
