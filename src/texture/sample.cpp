// SPDX-License-Identifier: MIT
#include "texture/sample.h"

#include <cstring>

#include "texture/magnify.h"
#include "texture/profile.h"

namespace shd::texture {
namespace {

void fill(float* column, size_t count, float value) {
  for (size_t i = 0; i < count; ++i) column[i] = value;
}

/// Derivatives and values, each by its own kernels.
size_t sample_given(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd,
                    const Lookups& lookups, const Texels& out) {
  Texels values = {}, gradient = {};
  bool derivatives = false;
  for (size_t c = 0; c < 4; ++c) {
    values.channel[c] = out.channel[c];
    gradient.du[c] = out.du[c];
    gradient.dv[c] = out.dv[c];
    derivatives = derivatives || out.du[c] || out.dv[c];
  }
  if (sampler.filter == SHD_FILTER_EXACT) return sample_exact(texture, sampler, simd, lookups, values);
  const FilterKernels kernels = kernels_of(sampler.filter, simd);
  if (derivatives) kernels.gradient(texture, sampler, lookups, gradient);
  return kernels.values(texture, sampler, lookups, values);
}

/// Block by block, what the profile finds and then the kernels on that.
size_t sample_profiled(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd,
                       const Lookups& lookups, const Texels& out) {
  size_t nonfinite = 0;
  for (size_t first = 0; first < lookups.count; first += kProfileBlock) {
    const size_t count = lookups.count - first < kProfileBlock ? lookups.count - first : kProfileBlock;
    ProfiledBlock block;
    profile_block(texture, sampler, simd, part_of(lookups, first, count), &block);
    sample_given(texture, block.sampler, simd, block.lookups, part_of(out, first));
    nonfinite += block.nonfinite;
  }
  return nonfinite;
}

}  // namespace

FilterKernels kernels_of(shd_filter filter, const core::SimdTarget& simd) {
  switch (filter) {
    case SHD_FILTER_NEAREST: return nearest_kernels(simd);
    case SHD_FILTER_BILINEAR: return bilinear_kernels(simd);
    case SHD_FILTER_BICUBIC: return bicubic_kernels(simd);
    case SHD_FILTER_NEAREST_MIP:
    case SHD_FILTER_BILINEAR_MIP: return mip_kernels(simd);
    case SHD_FILTER_RIPMAP: return ripmap_kernels(simd);
    case SHD_FILTER_SUMMED_AREA: return summed_area_kernels(simd);
    case SHD_FILTER_ANISOTROPIC: return anisotropic_kernels(simd);
    case SHD_FILTER_EWA: return ewa_kernels(simd);
    case SHD_FILTER_STOCHASTIC: return stochastic_kernels(simd);
    default: return trilinear_kernels(simd);
  }
}

bool has_gradient(shd_filter filter) {
  switch (filter) {
    case SHD_FILTER_BILINEAR:
    case SHD_FILTER_BICUBIC:
    case SHD_FILTER_BILINEAR_MIP:
    case SHD_FILTER_RIPMAP:
    case SHD_FILTER_ANISOTROPIC:
    case SHD_FILTER_EWA:
    case SHD_FILTER_TRILINEAR: return true;
    default: return false;
  }
}

size_t sample_filter(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd,
                     const Lookups& lookups, const Texels& out) {
  return is_profiled(sampler) ? sample_profiled(texture, sampler, simd, lookups, out)
                              : sample_given(texture, sampler, simd, lookups, out);
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
  sampler.probe_weights = desc.probe_weights;
  sampler.cubic = desc.cubic;
  sampler.box = desc.box;
  sampler.expectation = desc.expectation;
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
