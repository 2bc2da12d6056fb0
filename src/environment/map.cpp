// SPDX-License-Identifier: MIT
#include "environment/map.h"

#include <algorithm>

#include "core/executor.h"
#include "projection/projection.h"
#include "texture/format/rgb9e5-inl.h"

namespace shd::environment {

PackedTexel pack(const float rgb[3]) {
  if (!(std::max(rgb[0], std::max(rgb[1], rgb[2])) >= 1e-30f)) return {{0, 0}};
  const double color[3] = {static_cast<double>(rgb[0]), static_cast<double>(rgb[1]), static_cast<double>(rgb[2])};
  const texture::SharedExponent shared = texture::share_exponent<16>(color, -100);
  return {{shared.number[0] | shared.number[1] << 16,
           shared.number[2] | static_cast<uint32_t>(shared.exponent - 16 + 127) << 16}};
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

void MapPoints::find(const core::SimdTarget& simd) {
  projection::unproject(SHD_PROJECTION_OCTAHEDRAL, simd, {count, u, v, nullptr}, {{x, y, z}, weight});
}

namespace {

/// Writes `count` texels of a row from (x, y) on, at most MapPoints::kMost / 4.
void halve_part(const core::SimdTarget& simd, const Level& from, const Level& to, uint32_t x, uint32_t y,
                uint32_t count, float* texels) {
  MapPoints points;
  for (uint32_t k = 0; k < 4 * count; ++k) {
    points.add(from.size, static_cast<float>(2 * (x + k / 4) + k % 2) + 0.5f,
               static_cast<float>(2 * y + k % 4 / 2) + 0.5f);
  }
  points.find(simd);
  float* out = texels + 4 * texel_index(to, static_cast<int32_t>(x), static_cast<int32_t>(y));
  for (uint32_t i = 0; i < count; ++i, out += 4) {
    float sum[4] = {}, total = 0.0f;
    for (uint32_t k = 0; k < 4; ++k) {
      const float weight = points.weight[4 * i + k];
      const float* texel = texels + 4 * texel_index(from, static_cast<int32_t>(2 * (x + i) + k % 2),
                                                    static_cast<int32_t>(2 * y + k / 2));
      for (int c = 0; c < 4; ++c) sum[c] += weight * texel[c];
      total += weight;
    }
    for (int c = 0; c < 4; ++c) out[c] = sum[c] / total;
  }
}

}  // namespace

void halve(const core::Context& context, const Level& from, const Level& to, float* texels) {
  constexpr auto kBlock = static_cast<uint32_t>(MapPoints::kMost / 4);
  core::parallel_for(context, to.size, [&](uint32_t y, uint32_t) {
    for (uint32_t x = 0; x < to.size; x += kBlock) {
      halve_part(context.simd, from, to, x, y, std::min(kBlock, to.size - x), texels);
    }
  });
  fill_border(to, texels);
}

}  // namespace shd::environment
