// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "camera.h"
#include "handles.h"

/// A light and whether `--shadows` gives it one.
struct StageLight {
  Light light;
  bool casts = false;
  shd_light_kind kind = SHD_LIGHT_KIND_POINT;
};

/// Lights of the preset, which stand around the camera, and of the command line, which stand around the model, as
/// strong as surfaces of that model of reflectance need them.
std::vector<StageLight> make_lights(shd_context* context, const Options& options, shd_model model, const Bounds& bounds,
                                    const Camera& camera);
