// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "color/bake.h"
#include "color/pixels.h"
#include "core/simd_name.h"
#include "data/hash.h"

namespace shd::color {
namespace {

constexpr uint32_t kColors = 1 << 16;

/// Uniform in [0, 1).
float uniform(uint32_t index, uint32_t dimension) {
  return data::unit_of(data::mix_bits(index * 8 + dimension));
}

/// 2^x; x is a multiple of 2^-10.
float exposure(float x) {
  return std::exp2(std::floor(x * 1024.0f) / 1024.0f);
}

/// Colour i of the set. Its largest channel is 2^-14 to 2^6. A quarter each: any ratios; one or two channels smaller by
/// up to 2^-14; the same with zeros; some channels negative.
void make_color(uint32_t i, float (&rgb)[3]) {
  const float peak = exposure(-14.0f + 20.0f * uniform(i, 0));
  const uint32_t largest = data::mix_bits(i * 8 + 1) % 3;
  for (uint32_t c = 0; c < 3; ++c) {
    const float t = uniform(i, 2 + c);
    float ratio = t;
    if (i % 4 == 1) ratio = exposure(-14.0f * t);
    if (i % 4 == 2) ratio = t < 0.5f ? 0.0f : exposure(28.0f * (t - 1.0f));
    if (i % 4 == 3) ratio = t < 0.5f ? -exposure(14.0f * (t - 0.5f) - 1.0f) : exposure(28.0f * (t - 1.0f));
    rgb[c] = c == largest ? peak : peak * ratio;
  }
}

}  // namespace

Deviation measure(const Program& program, const Transform& transform) {
  const core::SimdTarget baseline = core::find_simd_target("");
  Deviation deviation;
  PixelBlock exact;
  std::vector<uint8_t> want(4 * kBlockPixels), got(4 * kBlockPixels);
  shd_image image = shd_image_default();
  image.format = SHD_FORMAT_RGBA8;
  image.width = kBlockPixels;
  image.height = 1;
  image.pixels = want.data();
  image.row_stride = want.size();
  for (uint32_t first = 0; first < kColors; first += kBlockPixels) {
    for (uint32_t i = 0; i < kBlockPixels; ++i) {
      float rgb[3];
      make_color(first + i, rgb);
      exact.r[i] = rgb[0], exact.g[i] = rgb[1], exact.b[i] = rgb[2], exact.a[i] = 1.0f;
    }
    const float* const planes[4] = {exact.r, exact.g, exact.b, exact.a};
    show(baseline, program, planes, kBlockPixels, got.data());
    transform.apply(exact.r, exact.g, exact.b, kBlockPixels);
    store_pixels(baseline, &exact, image, 0, kBlockPixels);
    for (size_t k = 0; k < got.size(); ++k) {
      if (k % 4 == 3) continue;
      const int difference = std::abs(static_cast<int>(got[k]) - want[k]);
      deviation.above_one += difference > 1;
      deviation.largest = std::max(deviation.largest, difference);
      ++deviation.channels;
    }
  }
  return deviation;
}

}  // namespace shd::color
