// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "tool/camera.h"
#include "tool/handles.h"

/// A light and whether `--shadows` gives it one.
struct StageLight {
  Light light;
  bool casts = false;
  shd_light_kind kind = SHD_LIGHT_POINT;
};

/// Lights of the preset, which stand around the camera, and of the command line, which stand around the model, as
/// strong as surfaces of the model's reflectance need them; or those of the file.
std::vector<StageLight> make_lights(shd_context* context, const Options& options, const Model& model,
                                    const Bounds& bounds, const Camera& camera);
