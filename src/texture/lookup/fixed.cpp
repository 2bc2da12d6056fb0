// SPDX-License-Identifier: MIT
// Filters in fixed point, for SHD_PRECISION_FAST.
#include "texture/stream.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/lookup/fixed.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/filter/anisotropic-inl.h"
#include "texture/filter/bilinear-inl.h"
#include "texture/filter/fixed_sink-inl.h"
#include "texture/filter/mip-inl.h"
#include "texture/filter/trilinear-inl.h"
#include "texture/lookup/fixed-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {

RunFilter FixedFilterOf(const Sampler& sampler) {
  if (sampler.precision != SHD_PRECISION_FAST || has_border(sampler)) return nullptr;
  switch (sampler.filter) {
    case SHD_FILTER_BILINEAR: return Run<Bilinear, FixedSink>;
    case SHD_FILTER_BILINEAR_MIP: return Run<BilinearMip, FixedSink>;
    case SHD_FILTER_TRILINEAR: return Run<Trilinear, FixedSink>;
    case SHD_FILTER_ANISOTROPIC:
      return sampler.probe_weights == SHD_PROBE_WEIGHTS_EQUAL ? Run<Anisotropic, FixedSink> : nullptr;
    default: return nullptr;
  }
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
