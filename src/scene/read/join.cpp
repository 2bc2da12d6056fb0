// SPDX-License-Identifier: MIT
#include "scene/read/join.h"

#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "scene/columns.h"

namespace shd::scene {
namespace {

/// The bytes of all numbers of a vertex; -0 counts as 0.
std::string key_of(const Geometry& g, uint32_t vertex) {
  std::string key;
  const auto append = [&](const std::vector<float>& column, size_t width) {
    for (size_t c = 0; c < width && !column.empty(); ++c) {
      const float number = column[width * vertex + c] + 0.0f;
      key.append(reinterpret_cast<const char*>(&number), sizeof number);
    }
  };
  for (const std::vector<float>* column : {&g.position, &g.normal}) append(*column, 3);
  for (const std::vector<float>* column : {&g.tangent, &g.color}) append(*column, 4);
  for (const std::vector<float>* column : {&g.uv, &g.uv1}) append(*column, 2);
  return key;
}

}  // namespace

void join_identical(Geometry& geometry) {
  std::unordered_map<std::string, uint32_t> vertex_of;
  std::vector<int64_t> new_of(geometry.position.size() / 3, -1);
  std::vector<uint32_t> kept;
  for (uint32_t& index : geometry.indices) {
    if (new_of[index] < 0) {
      const auto [at, is_new] = vertex_of.try_emplace(key_of(geometry, index), static_cast<uint32_t>(kept.size()));
      if (is_new) kept.push_back(index);
      new_of[index] = at->second;
    }
    index = static_cast<uint32_t>(new_of[index]);
  }
  take_vertices(geometry, kept);
}

}  // namespace shd::scene
