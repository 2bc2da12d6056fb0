// SPDX-License-Identifier: MIT
#include "picture.h"

#include <algorithm>

namespace viewer {

std::vector<uint8_t> compose(const Picture& picture, uint32_t divider) {
  if (!picture.side[0]) return {};
  const Image& a = *picture.side[0];
  std::vector<uint8_t> pixels = a.display;
  if (!picture.side[1]) return pixels;
  const size_t row = size_t{4} * a.width, first = size_t{4} * std::min(divider, a.width);
  for (uint32_t y = 0; y < a.height; ++y) {
    const auto from = picture.side[1]->display.begin() + static_cast<std::ptrdiff_t>(y * row);
    std::copy(from + static_cast<std::ptrdiff_t>(first), from + static_cast<std::ptrdiff_t>(row),
              pixels.begin() + static_cast<std::ptrdiff_t>(y * row + first));
  }
  return pixels;
}

uint64_t hash_of(const std::vector<uint8_t>& bytes) {
  uint64_t hash = 0xcbf29ce484222325u;
  for (const uint8_t byte : bytes) hash = (hash ^ byte) * 0x100000001b3u;
  return hash;
}

}  // namespace viewer
