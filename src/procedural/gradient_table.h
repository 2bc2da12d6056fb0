// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace shd::procedural {

/// Length of the permutation and of the array of gradients.
constexpr int32_t kTableSize = 256;

/// Tables of the classic Perlin noise: phi(i) = permutation[i mod 256], and the gradients G(phi(i)) by component. The
/// first element of each is repeated at the end, so that i and i + 1 are adjacent.
struct GradientTable {
  int32_t permutation[kTableSize + 1];
  float x[kTableSize + 1], y[kTableSize + 1], z[kTableSize + 1];
};

/// Fills the tables. The seed shuffles the permutation; G is the same array of random unit vectors for every seed.
void fill(uint32_t seed, GradientTable* out) noexcept;

}  // namespace shd::procedural
