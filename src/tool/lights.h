// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "tool/camera.h"
#include "tool/handles.h"

/// A light, and whether `--shadows` renders a shadow for it.
struct StageLight {
  Light light;
  bool casts = false;
  shd_light_kind kind = SHD_LIGHT_KIND_POINT;
};

/// Makes the lights of the preset, which are placed around the camera, and of the command line, which are placed around
/// the model; or the lights of the file. Their intensities are chosen for the reflectance model.
std::vector<StageLight> make_lights(shd_context* context, const Options& options, const Model& model,
                                    const Bounds& bounds, const Camera& camera);
