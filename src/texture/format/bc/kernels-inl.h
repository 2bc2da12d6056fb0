// SPDX-License-Identifier: MIT
// Decoders with the vectors of one target, declared.

#if defined(SHD_TEXTURE_BLOCK_KERNELS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_BLOCK_KERNELS_INL_H_
#undef SHD_TEXTURE_BLOCK_KERNELS_INL_H_
#else
#define SHD_TEXTURE_BLOCK_KERNELS_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/format/bc/decode.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {

/// Returns the fastest decoder with the bits of a scalar decoder: a kernel, or the scalar decoder itself.
DecodeBc KernelOf(DecodeBc decode);

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_BLOCK_KERNELS_INL_H_
