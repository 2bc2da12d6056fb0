// SPDX-License-Identifier: MIT
// The functions of one target that name the consumers of each format.

#if defined(SHD_TEXTURE_FORMATS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_FORMATS_INL_H_
#undef SHD_TEXTURE_FORMATS_INL_H_
#else
#define SHD_TEXTURE_FORMATS_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/format/formats.h"
#include "texture/stream.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {

#define SHD_TEXTURE_DECLARE_FORMAT(component, codec, kernels) FormatKernels kernels();
SHD_TEXTURE_FORMATS(SHD_TEXTURE_DECLARE_FORMAT)
#undef SHD_TEXTURE_DECLARE_FORMAT

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_FORMATS_INL_H_
