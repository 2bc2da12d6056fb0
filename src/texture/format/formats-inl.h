// SPDX-License-Identifier: MIT
// The formats: a row for each component type, with the function that names its consumers.

#if defined(SHD_TEXTURE_FORMATS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_FORMATS_INL_H_
#undef SHD_TEXTURE_FORMATS_INL_H_
#else
#define SHD_TEXTURE_FORMATS_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/stream.h"

#ifndef SHD_TEXTURE_FORMATS
#define SHD_TEXTURE_FORMATS(ROW)                  \
  ROW(image::Component::kUnorm8, Unorm8Kernels)   \
  ROW(image::Component::kSrgb8, Srgb8Kernels)     \
  ROW(image::Component::kUnorm16, Unorm16Kernels) \
  ROW(image::Component::kFloat16, Float16Kernels) \
  ROW(image::Component::kFloat32, Float32Kernels)
#endif

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {

#define SHD_TEXTURE_DECLARE_FORMAT(component, kernels) FormatKernels kernels();
SHD_TEXTURE_FORMATS(SHD_TEXTURE_DECLARE_FORMAT)
#undef SHD_TEXTURE_DECLARE_FORMAT

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_FORMATS_INL_H_
