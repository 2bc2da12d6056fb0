// SPDX-License-Identifier: MIT
#pragma once
#include <shd/view.h>

#include "tool/model.h"
#include "tool/options.h"

/// Radians of a degree.
constexpr float kDegree = 3.14159265f / 180.0f;

/// The eye and the axes of its view.
struct Camera {
  shd_view view;
  std::array<float, 3> right, up, back;  // axes of the view, world space, unit
};

/// Makes the camera of a shot, an orbit rotated by `turn` degrees, and `--fov`. Without a given distance,
/// the position and direction of the eye are chosen so that every vertex of `shown` is just inside the picture. `model`
/// has the cameras of the file.
Camera make_camera(const Options& options, const Shot& shot, float turn, const Model& model, const Model& shown,
                   const Bounds& bounds);
