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
  Texels stored = out;
  if (image::format_info(texture.format).channels == 1) {
    fill(out.channel[1], lookups.count, 0.0f);
    fill(out.channel[2], lookups.count, 0.0f);
    fill(out.channel[3], lookups.count, 1.0f);
    stored.channel[1] = stored.channel[2] = stored.channel[3] = nullptr;
  }
  switch (sampler.filter) {
    case SHD_FILTER_NEAREST: return sample_nearest(texture, sampler, simd, lookups, stored);
    case SHD_FILTER_BILINEAR: return sample_bilinear(texture, sampler, simd, lookups, stored);
    default: return sample_trilinear(texture, sampler, simd, lookups, stored);
  }
}

}  // namespace shd::texture
