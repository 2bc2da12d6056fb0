// SPDX-License-Identifier: MIT
#include "texture/sample.h"

#include "image/format.h"

namespace shd::texture {
namespace {

void fill(float* column, size_t count, float value) {
  if (!column) return;
  for (size_t i = 0; i < count; ++i) column[i] = value;
}

}  // namespace

size_t sample(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd, const Lookups& lookups,
              const Texels& out) {
  Texels stored = out;  // channels that the format has
  if (image::format_info(texture.format).channels == 1) {
    for (size_t c = 1; c < 4; ++c) {
      fill(out.channel[c], lookups.count, c == 3 ? 1.0f : 0.0f);
      stored.channel[c] = nullptr;
    }
  }
  switch (sampler.filter) {
    case SHD_FILTER_NEAREST: return sample_nearest(texture, sampler, simd, lookups, stored);
    case SHD_FILTER_BILINEAR: return sample_bilinear(texture, sampler, simd, lookups, stored);
    default: return sample_trilinear(texture, sampler, simd, lookups, stored);
  }
}

}  // namespace shd::texture
