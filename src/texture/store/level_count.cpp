// SPDX-License-Identifier: MIT
#include "texture/store/storage.h"

namespace shd::texture {

uint32_t full_level_count(uint32_t width, uint32_t height, uint32_t depth) {
  uint32_t count = 1;
  const uint32_t larger = width > height ? width : height;
  for (uint32_t size = larger > depth ? larger : depth; size > 1; size >>= 1) ++count;
  return count;
}

}  // namespace shd::texture
