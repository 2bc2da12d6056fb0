// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

namespace shd::geometry {

/// A box of pixels, ends included; empty if min > max.
struct PixelBox {
  int32_t min_x, min_y, max_x, max_y;
};

inline PixelBox intersection(const PixelBox& a, const PixelBox& b) {
  return {std::max(a.min_x, b.min_x), std::max(a.min_y, b.min_y), std::min(a.max_x, b.max_x),
          std::min(a.max_y, b.max_y)};
}

inline bool is_empty(const PixelBox& box) {
  return box.min_x > box.max_x || box.min_y > box.max_y;
}

/// width x height pixels with the top left pixel (x, y).
inline PixelBox pixel_rectangle(int32_t x, int32_t y, uint32_t width, uint32_t height) {
  return {x, y, x + static_cast<int32_t>(width) - 1, y + static_cast<int32_t>(height) - 1};
}

/// All pixels of a picture.
inline PixelBox viewport_box(uint32_t width, uint32_t height) {
  return pixel_rectangle(0, 0, width, height);
}

}  // namespace shd::geometry
