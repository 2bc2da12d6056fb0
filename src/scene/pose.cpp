// SPDX-License-Identifier: MIT
#include "scene/pose.h"

#include <algorithm>

#include "scene/sample.h"

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

void set_property(const Channel& channel, const std::vector<double>& values, Node& node, std::vector<double>& weights) {
  switch (channel.target) {
    case Target::kTranslation: std::copy_n(values.begin(), 3, node.translation.begin()); break;
    case Target::kRotation: std::copy_n(values.begin(), 4, node.rotation.begin()); break;
    case Target::kScale: std::copy_n(values.begin(), 3, node.scale.begin()); break;
    case Target::kWeights: weights = values; break;
  }
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

double determinant(const Matrix& m) {
  return m[0] * (m[5] * m[10] - m[9] * m[6]) - m[4] * (m[1] * m[10] - m[9] * m[2]) + m[8] * (m[1] * m[6] - m[5] * m[2]);
}

std::array<double, 3> transform(const Matrix& m, const std::array<double, 3>& p) {
  std::array<double, 3> out;
  for (size_t r = 0; r < 3; ++r) out[r] = m[r] * p[0] + m[4 + r] * p[1] + m[8 + r] * p[2] + m[12 + r];
  return out;
}

bool is_usable(const Model& model, const Channel& channel) {
  const size_t count = component_count(channel);
  if (channel.target == Target::kWeights) return count > 0;
  return model.nodes[channel.node].parts && count == (channel.target == Target::kRotation ? 4u : 3u);
}

Pose pose_of(const Model& model, const Animation* animation, double seconds) {
  std::vector<Node> nodes = model.nodes;
  Pose pose;
  for (const Node& node : nodes) pose.weights.emplace_back(node.weights.begin(), node.weights.end());
  for (size_t i = 0; animation && i < animation->channels.size(); ++i) {
    const Channel& channel = animation->channels[i];
    if (!is_usable(model, channel)) continue;
    set_property(channel, sample(channel, seconds), nodes[channel.node], pose.weights[channel.node]);
  }
  pose.worlds.reserve(nodes.size());
  for (const Node& node : nodes) {
    const Matrix local = matrix_of(node);
    pose.worlds.push_back(node.parent < 0 ? local : multiply(pose.worlds[static_cast<size_t>(node.parent)], local));
  }
  return pose;
}

std::vector<Instance> place(const Model& model) {
  const std::vector<Matrix> worlds = pose_of(model).worlds;
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
