// SPDX-License-Identifier: MIT
#include "texture/sample.h"

#include <cstring>

#include "texture/filter/exact.h"
#include "texture/filter/magnify.h"
#include "texture/footprint/profile.h"

namespace shd::texture {
namespace {

void fill(float* column, size_t count, float value) {
  for (size_t i = 0; i < count; ++i) column[i] = value;
}

/// Weights of probes. Profiles that place the probes bring their own.
shd_probe_weights probe_weights_of(const shd_sampler_desc& desc) {
  if (desc.filter != SHD_FILTER_ANISOTROPIC || desc.profile == SHD_PROFILE_EXACT) return desc.probe_weights;
  return desc.profile == SHD_PROFILE_OIIO ? SHD_PROBE_WEIGHTS_GAUSSIAN : SHD_PROBE_WEIGHTS_EQUAL;
}

}  // namespace

size_t sample_filter(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd,
                     const Lookups& lookups, const Texels& out) {
  if (sampler.filter == SHD_FILTER_EXACT) return sample_exact(texture, sampler, simd, lookups, out);
  return run_filter(texture, sampler, simd, lookups, out, nullptr);
}

Sampler make_sampler(const shd_sampler_desc& desc) {
  Sampler sampler = {};
  sampler.filter = desc.filter;
  sampler.magnification = desc.magnification;
  sampler.wrap_u = desc.wrap_u;
  sampler.wrap_v = desc.wrap_v;
  std::memcpy(sampler.border, desc.border, sizeof sampler.border);
  sampler.lod_bias = desc.lod_bias;
  sampler.lod_min = desc.lod_min;
  sampler.lod_max = desc.lod_max < desc.lod_min ? desc.lod_min : desc.lod_max;
  sampler.width_x = desc.width_x;
  sampler.width_y = desc.width_y;
  sampler.blur_u = desc.blur_u;
  sampler.blur_v = desc.blur_v;
  sampler.max_anisotropy = desc.max_anisotropy;
  sampler.probe_weights = probe_weights_of(desc);
  sampler.cubic = desc.cubic;
  sampler.box = desc.box;
  sampler.stochastic_filter = desc.stochastic_filter;
  sampler.seed = desc.seed;
  sampler.tolerance = desc.tolerance;
  sampler.profile = desc.profile;
  sampler.rounded_weights = has_rounded_weights(desc);
  return sampler;
}

size_t sample(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd, const Lookups& lookups,
              const Texels& out) {
  // Columns 4 k + c of values (k = 0) and of their derivatives in u and v, by stored channel.
  Texels stored = {};
  for (size_t i = 0; i < kOutputColumns; ++i) {
    const uint32_t source = texture.channel_source[i % 4];
    if (source == kFill) continue;
    float*& column = stored.column(i / 4 * 4 + source);
    if (!column) column = out.column(i);
  }
  const size_t nonfinite = sampler.magnification == SHD_MAGNIFICATION_DEFAULT
                               ? sample_filter(texture, sampler, simd, lookups, stored)
                               : sample_magnified(texture, sampler, simd, lookups, stored);
  for (size_t i = 0; i < kOutputColumns; ++i) {
    if (!out.column(i)) continue;
    const uint32_t source = texture.channel_source[i % 4];
    if (source == kFill) {
      fill(out.column(i), lookups.count, i < 4 ? texture.fill[i] : 0.0f);
      continue;
    }
    const float* column = stored.column(i / 4 * 4 + source);
    if (column != out.column(i)) std::memcpy(out.column(i), column, lookups.count * sizeof(float));
  }
  return nonfinite;
}

}  // namespace shd::texture
