// SPDX-License-Identifier: MIT
#include "environment/map.h"

#include <algorithm>

#include "core/executor.h"

namespace shd::environment {

PackedTexel pack(const float rgb[3]) {
  const float largest = std::max(rgb[0], std::max(rgb[1], rgb[2]));
  int exponent = 0;
  std::frexp(largest, &exponent);  // largest < 2^exponent
  if (!(largest >= 1e-30f)) return {{0, 0}};
  if (std::ldexp(largest, 16 - exponent) >= 65535.5f) ++exponent;
  uint32_t channel[3];
  for (int c = 0; c < 3; ++c) channel[c] = static_cast<uint32_t>(std::ldexp(rgb[c], 16 - exponent) + 0.5f);
  return {{channel[0] | channel[1] << 16, channel[2] | static_cast<uint32_t>(exponent - 16 + 127) << 16}};
}

void fill_border(const Level& level, float* texels) {
  const auto size = static_cast<int32_t>(level.size);
  const auto copy = [&](int32_t x, int32_t y, int32_t from_x, int32_t from_y) {
    const float* from = texels + 4 * texel_index(level, from_x, from_y);
    std::copy_n(from, 4, texels + 4 * texel_index(level, x, y));
  };
  for (int32_t i = 0; i < size; ++i) {
    copy(i, -1, size - 1 - i, 0);
    copy(i, size, size - 1 - i, size - 1);
    copy(-1, i, 0, size - 1 - i);
    copy(size, i, size - 1, size - 1 - i);
  }
  for (const int32_t y : {-1, size}) {
    for (const int32_t x : {-1, size}) copy(x, y, x < 0 ? size - 1 : 0, y < 0 ? size - 1 : 0);
  }
}

void halve(const core::Context& context, const Level& from, const Level& to, float* texels) {
  core::parallel_for(context, to.size, [&](uint32_t y, uint32_t) {
    for (uint32_t x = 0; x < to.size; ++x) {
      float sum[4] = {}, total = 0.0f;
      for (uint32_t k = 0; k < 4; ++k) {
        const uint32_t i = 2 * x + k % 2, j = 2 * y + k / 2;
        const float norm = map_direction(from.size, static_cast<float>(i) + 0.5f, static_cast<float>(j) + 0.5f).norm;
        const float weight = norm * norm * norm;
        const float* texel = texels + 4 * texel_index(from, static_cast<int32_t>(i), static_cast<int32_t>(j));
        for (int c = 0; c < 4; ++c) sum[c] += weight * texel[c];
        total += weight;
      }
      float* out = texels + 4 * texel_index(to, static_cast<int32_t>(x), static_cast<int32_t>(y));
      for (int c = 0; c < 4; ++c) out[c] = sum[c] / total;
    }
  });
  fill_border(to, texels);
}

}  // namespace shd::environment
