// SPDX-License-Identifier: MIT
#include "geometry/weld.h"

#include <cstring>
#include <utility>

namespace shd::geometry {
namespace {

constexpr uint32_t kDigitBits = 11;  // three passes over 32 bits
constexpr uint32_t kDigits = 1u << kDigitBits;

uint32_t key_of(float value) {
  const float positive = value + 0.0f;  // -0 becomes 0
  uint32_t bits;
  std::memcpy(&bits, &positive, sizeof bits);
  return bits;
}

/// One stable pass over the digit at `shift`. Returns false without moving anything if all digits are equal.
bool sort_pass(const uint32_t* keys, size_t count, uint32_t shift, const uint32_t* from, uint32_t* to) {
  size_t start[kDigits] = {};
  const auto digit = [&](size_t i) { return keys[i] >> shift & (kDigits - 1); };
  for (size_t i = 0; i < count; ++i) ++start[digit(i)];
  if (start[digit(0)] == count) return false;
  size_t sum = 0;
  for (uint32_t d = 0; d < kDigits; ++d) sum += std::exchange(start[d], sum);
  for (size_t i = 0; i < count; ++i) to[start[digit(from[i])]++] = from[i];
  return true;
}

}  // namespace

void weld(const core::Allocator& allocator, const float* const* columns, size_t column_count, size_t vertex_count,
          uint32_t* out) {
  if (vertex_count == 0) return;
  core::Array<uint32_t> order(allocator, vertex_count);
  core::Array<uint32_t> spare(allocator, vertex_count);
  core::Array<uint32_t> keys(allocator, vertex_count);
  for (size_t i = 0; i < vertex_count; ++i) order[i] = static_cast<uint32_t>(i);
  for (size_t c = 0; c < column_count; ++c) {
    for (size_t i = 0; i < vertex_count; ++i) keys[i] = key_of(columns[c][i]);
    for (uint32_t shift = 0; shift < 32; shift += kDigitBits) {
      if (sort_pass(keys.data(), vertex_count, shift, order.data(), spare.data())) std::swap(order, spare);
    }
  }
  const auto same = [&](uint32_t a, uint32_t b) {
    for (size_t c = 0; c < column_count; ++c) {
      if (key_of(columns[c][a]) != key_of(columns[c][b])) return false;
    }
    return true;
  };
  uint32_t lowest = order[0];  // vertices of equal values are adjacent, the lowest one first
  for (size_t i = 0; i < vertex_count; ++i) {
    if (!same(order[i], lowest)) lowest = order[i];
    out[order[i]] = lowest;
  }
}

}  // namespace shd::geometry
