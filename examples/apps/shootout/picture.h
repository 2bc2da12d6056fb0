// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace shootout {

/// Red, green and blue in [0, 1] as a display takes them, packed, row 0 on top.
struct Picture {
  uint32_t width = 0, height = 0;
  std::vector<float> rgb;

  Picture() = default;
  Picture(uint32_t w, uint32_t h) : width(w), height(h), rgb(size_t{w} * h * 3) {}
  size_t pixels() const { return size_t{width} * height; }
  float* at(uint32_t x, uint32_t y) { return &rgb[(size_t{y} * width + x) * 3]; }
  const float* at(uint32_t x, uint32_t y) const { return &rgb[(size_t{y} * width + x) * 3]; }
};

/// FNV-1a of the bits of the values, in 16 hexadecimal digits (Fowler, Noll and Vo, RFC 9923).
std::string hash_of(const void* data, size_t size);
inline std::string hash_of(const Picture& picture) {
  return hash_of(picture.rgb.data(), picture.rgb.size() * sizeof(float));
}

}  // namespace shootout
