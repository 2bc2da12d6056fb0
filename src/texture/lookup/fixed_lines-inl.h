// SPDX-License-Identifier: MIT
#if defined(SHD_TEXTURE_FIXED_LINES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_FIXED_LINES_INL_H_
#undef SHD_TEXTURE_FIXED_LINES_INL_H_
#else
#define SHD_TEXTURE_FIXED_LINES_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/stream.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {

/// SHD_FILTER_ANISOTROPIC of 8-bit unorm texels with SHD_PRECISION_FAST; a RunFilter.
size_t RunFixedLines(const FilterCall& call);

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_FIXED_LINES_INL_H_
