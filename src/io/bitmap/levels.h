// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

#include "io/bitmap/bitmap.h"

namespace shd::io {

/// Width or height of mip level `level`; as shd_texture_desc.level_images requires it.
inline uint32_t level_side(uint32_t base, uint32_t level) {
  return std::max(1u, base >> level);
}

/// Number of levels down to 1 x 1, the base included.
inline uint32_t full_level_count(uint32_t width, uint32_t height) {
  uint32_t count = 1;
  while (std::max(width, height) >> count) ++count;
  return count;
}

/// Pixels of the first `count` levels, which a Bitmap stores one after the other. Cannot overflow after
/// check_extent().
inline uint64_t level_pixels(uint32_t width, uint32_t height, uint32_t count) {
  uint64_t pixels = 0;
  for (uint32_t l = 0; l < count; ++l) pixels += uint64_t{level_side(width, l)} * level_side(height, l);
  return pixels;
}

/// Pixels of all slices and levels of a Bitmap. Cannot overflow after check_volume().
inline uint64_t bitmap_pixels(const Bitmap& bitmap) {
  return level_pixels(bitmap.width, bitmap.height, bitmap.level_count) * bitmap.depth;
}

}  // namespace shd::io
