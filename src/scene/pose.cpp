// SPDX-License-Identifier: MIT
#include "scene/pose.h"

namespace shd::scene {
namespace {

/// translation * rotation * scale of a node.
Matrix matrix_of(const Node& node) {
  if (!node.parts) return node.matrix;
  const auto [x, y, z, w] = node.rotation;
  const double columns[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)},
                                {2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)},
                                {2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)}};
  Matrix out = kIdentity;
  for (size_t c = 0; c < 3; ++c) {
    for (size_t r = 0; r < 3; ++r) out[4 * c + r] = columns[c][r] * node.scale[c];
    out[12 + c] = node.translation[c];
  }
  return out;
}

}  // namespace

Matrix multiply(const Matrix& a, const Matrix& b) {
  Matrix out = {};
  for (size_t c = 0; c < 4; ++c) {
    for (size_t r = 0; r < 4; ++r) {
      for (size_t k = 0; k < 4; ++k) out[4 * c + r] += a[4 * k + r] * b[4 * c + k];
    }
  }
  return out;
}

std::vector<Matrix> world_matrices(const Model& model) {
  std::vector<Matrix> out;
  out.reserve(model.nodes.size());
  for (const Node& node : model.nodes) {
    const Matrix local = matrix_of(node);
    out.push_back(node.parent < 0 ? local : multiply(out[static_cast<size_t>(node.parent)], local));
  }
  return out;
}

std::vector<Instance> place(const Model& model) {
  const std::vector<Matrix> worlds = world_matrices(model);
  std::vector<Instance> out;
  for (const Placement& placement : model.placements) {
    const Matrix& world = worlds[placement.node];
    if (placement.copies.empty()) out.push_back({placement.geometry, placement.surface, world});
    for (const Matrix& copy : placement.copies) {
      out.push_back({placement.geometry, placement.surface, multiply(world, copy)});
    }
  }
  return out;
}

}  // namespace shd::scene
