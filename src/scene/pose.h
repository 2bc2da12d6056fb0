// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "scene/model.h"

namespace shd::scene {

Matrix multiply(const Matrix& a, const Matrix& b);

/// Determinant of the upper left 3 x 3 part.
double determinant(const Matrix& m);

/// A point through a matrix.
std::array<double, 3> transform(const Matrix& m, const std::array<double, 3>& point);

/// The state of all nodes at one time.
struct Pose {
  std::vector<Matrix> worlds;                // [node], to the world
  std::vector<std::vector<double>> weights;  // [node], of morph targets
};

/// The channel moves its node: its values fit, and the node has the property.
bool is_usable(const Model& model, const Channel& channel);

/// The pose of the file, or of an animation at `seconds`. Channels that are not usable have no effect.
Pose pose_of(const Model& model, const Animation* animation = nullptr, double seconds = 0);

/// A geometry placed in the world.
struct Instance {
  uint32_t geometry = 0, surface = 0;
  Matrix object_to_world = kIdentity;
};

/// All copies of all placements in the pose of the file, in their order, without skins.
std::vector<Instance> place(const Model& model);

}  // namespace shd::scene
