// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace shd::texture {

/// Returns the number of levels after the base that halve evenly, at most level_count - 1.
inline uint32_t even_halvings(uint32_t width, uint32_t height, uint32_t level_count) {
  uint32_t steps = 0;
  for (; steps + 1 < level_count; ++steps) {
    if ((width > 1 && width % 2) || (height > 1 && height % 2)) break;
    width = width > 1 ? width / 2 : 1;
    height = height > 1 ? height / 2 : 1;
  }
  return steps;
}

}  // namespace shd::texture
