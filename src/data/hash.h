// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace shd::data {

/// Odd step between the words of a sequence that is hashed: 2^32 by the golden ratio.
constexpr uint32_t kHashStep = 0x9e3779b9u;

/// A hash of a word, which is one-to-one: Wellons, "Prospecting for Hash Functions" (2018), lowbias32. MixBits() of
/// simd/hash-inl.h is the same for vectors.
constexpr uint32_t mix_bits(uint32_t x) {
  x = (x ^ x >> 16) * 0x7feb352du;
  x = (x ^ x >> 15) * 0x846ca68bu;
  return x ^ x >> 16;
}

/// A number in [0, 1) from the high 24 bits of a hash.
constexpr float unit_of(uint32_t hash) {
  return static_cast<float>(hash >> 8) * 0x1p-24f;
}

}  // namespace shd::data
