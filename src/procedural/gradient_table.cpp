// SPDX-License-Identifier: MIT
#include "procedural/gradient_table.h"

#include <utility>

#include "data/hash.h"

namespace shd::procedural {
namespace {

using data::kHashStep;
using data::mix_bits;

/// The square root of s in (0, 1] by Newton's method, for constants.
constexpr double root(double s) {
  double r = 1.0;
  for (int i = 0; i < 64; ++i) r = 0.5 * (r + s / r);
  return r;
}

struct UnitVectors {
  float v[kTableSize][3];
};

/// Random points of the unit ball outside its core, normalised.
constexpr UnitVectors make_unit_vectors() {
  UnitVectors out = {};
  uint32_t state = 0;
  for (auto& v : out.v) {
    double p[3] = {}, square = 0.0;
    while (square < 0x1p-6 || square > 1.0) {
      square = 0.0;
      for (double& component : p) {
        component = static_cast<double>(mix_bits(state += kHashStep)) * 0x1p-31 - 1.0;
        square += component * component;
      }
    }
    const double length = root(square);
    for (int c = 0; c < 3; ++c) v[c] = static_cast<float>(p[c] / length);
  }
  return out;
}
constexpr UnitVectors kUnitVectors = make_unit_vectors();

}  // namespace

void fill(uint32_t seed, GradientTable* out) noexcept {
  int32_t* const p = out->permutation;
  for (int32_t i = 0; i < kTableSize; ++i) p[i] = i;
  uint32_t state = mix_bits(seed + kHashStep);
  for (uint32_t i = kTableSize - 1; i > 0; --i) {  // Fisher and Yates
    const uint64_t random = mix_bits(state += kHashStep);
    std::swap(p[i], p[random * (i + 1) >> 32]);
  }
  p[kTableSize] = p[0];
  for (int32_t i = 0; i <= kTableSize; ++i) {
    const float* const g = kUnitVectors.v[p[i]];
    out->x[i] = g[0];
    out->y[i] = g[1];
    out->z[i] = g[2];
  }
}

}  // namespace shd::procedural
