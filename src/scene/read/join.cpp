// SPDX-License-Identifier: MIT
#include "scene/read/join.h"

#include <cstring>
#include <iterator>
#include <string>
#include <unordered_map>
#include <utility>

namespace shd::scene {
namespace {

struct Column {
  std::vector<float>* numbers;
  size_t width;
};

}  // namespace

void join_identical(Geometry& geometry) {
  const Column columns[] = {{&geometry.position, 3}, {&geometry.normal, 3}, {&geometry.tangent, 4},
                            {&geometry.uv, 2},       {&geometry.uv1, 2},    {&geometry.color, 4}};
  std::vector<float> joined[std::size(columns)];
  std::unordered_map<std::string, uint32_t> vertex_of;
  std::vector<int64_t> new_of(geometry.position.size() / 3, -1);
  for (uint32_t& index : geometry.indices) {
    if (new_of[index] < 0) {
      std::string key;
      for (const Column& column : columns) {
        for (size_t c = 0; c < column.width && !column.numbers->empty(); ++c) {
          const float number = (*column.numbers)[column.width * index + c] + 0.0f;  // -0 is 0
          char bytes[sizeof number];
          std::memcpy(bytes, &number, sizeof number);
          key.append(bytes, sizeof bytes);
        }
      }
      const auto [at, is_new] = vertex_of.try_emplace(std::move(key), static_cast<uint32_t>(vertex_of.size()));
      for (size_t i = 0; is_new && i < std::size(columns); ++i) {
        const std::vector<float>& from = *columns[i].numbers;
        for (size_t c = 0; c < columns[i].width && !from.empty(); ++c) {
          joined[i].push_back(from[columns[i].width * index + c]);
        }
      }
      new_of[index] = at->second;
    }
    index = static_cast<uint32_t>(new_of[index]);
  }
  for (size_t i = 0; i < std::size(columns); ++i) *columns[i].numbers = std::move(joined[i]);
}

}  // namespace shd::scene
