// SPDX-License-Identifier: MIT
#include <cstring>

#include "texture/footprint/profile.h"
#include "texture/texture.h"

namespace shd::texture {
namespace {

/// Returns the weights of probes. A profile that places the probes also determines their weights.
shd_probe_weights probe_weights_of(const shd_sampler_desc& desc) {
  if (desc.filter != SHD_FILTER_ANISOTROPIC || desc.profile == SHD_PROFILE_EXACT) return desc.probe_weights;
  return desc.profile == SHD_PROFILE_OIIO ? SHD_PROBE_WEIGHTS_GAUSSIAN : SHD_PROBE_WEIGHTS_EQUAL;
}

}  // namespace

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
  sampler.precision = desc.precision;
  return sampler;
}

}  // namespace shd::texture
