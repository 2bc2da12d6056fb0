// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "scene/model.h"

namespace shd::scene {

Matrix multiply(const Matrix& a, const Matrix& b);

/// A geometry placed in the world.
struct Instance {
  uint32_t geometry = 0, surface = 0;
  Matrix object_to_world = kIdentity;
};

/// The matrices of all nodes to the world.
std::vector<Matrix> world_matrices(const Model& model);

/// All copies of all placements, in their order.
std::vector<Instance> place(const Model& model);

}  // namespace shd::scene
