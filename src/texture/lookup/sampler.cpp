// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstring>

#include "texture/domain/profile.h"
#include "texture/texture.h"

namespace shd::texture {
namespace {

/// Returns the weights of probes. A profile that places the probes also determines their weights.
shd_probe_weights probe_weights_of(const shd_sampler_desc& desc) {
  if (desc.filter != SHD_FILTER_ANISOTROPIC || !is_foreign(desc.profile)) return desc.probe_weights;
  return desc.profile == SHD_PROFILE_OIIO ? SHD_PROBE_WEIGHTS_GAUSSIAN : SHD_PROBE_WEIGHTS_EQUAL;
}

/// Returns the largest ratio of the axes of a footprint, so that no lookup reads more than max_texels texels.
float max_anisotropy_of(const shd_sampler_desc& desc, float level_blend) {
  if (desc.max_texels == 0) return desc.max_anisotropy;
  const auto texels = static_cast<float>(desc.max_texels);
  if (desc.filter == SHD_FILTER_EWA) return std::min(desc.max_anisotropy, texels / 16.0f - 1.0f);
  if (desc.filter != SHD_FILTER_ANISOTROPIC) return desc.max_anisotropy;
  const float probes = std::floor(texels / (level_blend < 0x1p-24f ? 4.0f : 8.0f));
  switch (desc.profile) {
    case SHD_PROFILE_LEAST_ERROR:
    case SHD_PROFILE_EXACT: {
      // A footprint of ratio r has at most ceil(sqrt(2) r - probe_slack) probes, or ceil(r - probe_slack) if all levels
      // are blended.
      const float widths = probes + desc.probe_slack;
      return std::min(desc.max_anisotropy, level_blend < 1.0f ? 0.707f * widths : widths);
    }
    case SHD_PROFILE_OIIO: return std::min(desc.max_anisotropy, 0.5f * (probes + 1.0f));
    default: return std::min(desc.max_anisotropy, probes);
  }
}

}  // namespace

Sampler make_sampler(const shd_sampler_desc& desc) {
  Sampler sampler = {};
  sampler.filter = desc.filter;
  sampler.magnification = desc.magnification;
  sampler.wrap_u = desc.wrap_u;
  sampler.wrap_v = desc.wrap_v;
  sampler.wrap_w = desc.wrap_w;
  std::memcpy(sampler.border, desc.border, sizeof sampler.border);
  sampler.lod_bias = desc.lod_bias;
  sampler.lod_min = desc.lod_min;
  sampler.lod_max = desc.lod_max < desc.lod_min ? desc.lod_min : desc.lod_max;
  sampler.width_x = desc.width_x;
  sampler.width_y = desc.width_y;
  sampler.blur_u = desc.blur_u;
  sampler.blur_v = desc.blur_v;
  sampler.max_anisotropy = max_anisotropy_of(desc, desc.level_blend);
  sampler.fast_anisotropy = max_anisotropy_of(desc, std::min(desc.level_blend, kFastLevelBlend));
  sampler.probe_weights = probe_weights_of(desc);
  sampler.cubic = desc.cubic;
  sampler.box = desc.box;
  sampler.stochastic_filter = desc.stochastic_filter;
  sampler.seed = desc.seed;
  sampler.tolerance = desc.tolerance;
  sampler.profile = desc.profile;
  sampler.weights = weights_of(desc);
  sampler.precision = desc.compares ? SHD_PRECISION_FULL : desc.precision;
  sampler.probe_slack = desc.probe_slack;
  sampler.level_steepness = desc.level_blend < 0x1p-24f ? 0.0f : 1.0f / desc.level_blend;
  sampler.stochastic = desc.stochastic;
  sampler.missing_tiles = desc.missing_tiles;
  sampler.compares = desc.compares != 0;
  sampler.compare = desc.compare;
  return sampler;
}

}  // namespace shd::texture
