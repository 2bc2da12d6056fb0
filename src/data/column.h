// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include <shd/column.h>

namespace shd::data {

/// Element i of a checked column. The stride may place it at any multiple of 4 bytes.
inline float load(const shd_f32_in& column, size_t i) {
  const size_t stride = column.stride ? column.stride : sizeof(float);
  float value;
  std::memcpy(&value, reinterpret_cast<const char*>(column.data) + i * stride, sizeof value);
  return value;
}
inline uint32_t load(const shd_u32_in& column, size_t i) {
  const size_t stride = column.stride ? column.stride : sizeof(uint32_t);
  uint32_t value;
  std::memcpy(&value, reinterpret_cast<const char*>(column.data) + i * stride, sizeof value);
  return value;
}
inline void store(const shd_f32_out& column, size_t i, float value) {
  const size_t stride = column.stride ? column.stride : sizeof(float);
  std::memcpy(reinterpret_cast<char*>(column.data) + i * stride, &value, sizeof value);
}
inline void store(const shd_u32_out& column, size_t i, uint32_t value) {
  const size_t stride = column.stride ? column.stride : sizeof(uint32_t);
  std::memcpy(reinterpret_cast<char*>(column.data) + i * stride, &value, sizeof value);
}

/// Whether the elements are adjacent, so that a kernel can read or write in place.
inline bool is_packed(size_t stride) {
  return stride == 0 || stride == 4;
}

}  // namespace shd::data
