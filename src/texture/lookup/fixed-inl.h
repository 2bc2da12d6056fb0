// SPDX-License-Identifier: MIT
#if defined(SHD_TEXTURE_FIXED_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_FIXED_INL_H_
#undef SHD_TEXTURE_FIXED_INL_H_
#else
#define SHD_TEXTURE_FIXED_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/stream.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {

/// Returns a filter in fixed point, for formats with fixed-point kernels. Returns null if the filter has none.
RunFilter FixedFilterOf(const Sampler& sampler);

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_FIXED_INL_H_
