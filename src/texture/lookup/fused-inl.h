// SPDX-License-Identifier: MIT
#if defined(SHD_TEXTURE_FUSED_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_FUSED_INL_H_
#undef SHD_TEXTURE_FUSED_INL_H_
#else
#define SHD_TEXTURE_FUSED_INL_H_
#endif

#include <hwy/highway.h>

#include "image/format.h"
#include "texture/stream.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {

/// Returns a filter and a format compiled together, for values of samplers without border colour. Returns null if the
/// pair is not compiled together.
RunFilter FusedOf(shd_filter filter, image::Component component);

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_FUSED_INL_H_
