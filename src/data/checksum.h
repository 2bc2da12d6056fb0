// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace shd::data {

/// A checksum against damage of stored bytes, not against forgery: each step is one-to-one, so that one changed word is
/// always seen. `sum` continues the checksum of earlier bytes.
inline uint64_t checksum(const void* data, size_t size, uint64_t sum = 0) {
  constexpr uint64_t kOdd = 0x9e3779b97f4a7c15u;
  const auto* bytes = static_cast<const unsigned char*>(data);
  sum ^= size * kOdd;
  for (size_t i = 0; i < size; i += 8) {
    uint64_t word = 0;
    std::memcpy(&word, bytes + i, size - i < 8 ? size - i : 8);
    sum = (sum ^ word) * kOdd;
    sum ^= sum >> 29;
  }
  return sum;
}

}  // namespace shd::data
