// SPDX-License-Identifier: MIT
#pragma once
#include <shd/view.h>

#include "tool/model.h"
#include "tool/options.h"

/// The eye and the axes of its view.
struct Camera {
  shd_view view;
  std::array<float, 3> right, up, back;  // of the view, world space, unit
};

/// Camera of `--camera`, or of `--orbit`, `turn` degrees further, and `--fov`. Without a distance the eye stands, and
/// looks aside, so that every vertex is just in the picture.
Camera make_camera(const Options& options, const Model& model, const Bounds& bounds, float turn);
