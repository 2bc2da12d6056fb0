// SPDX-License-Identifier: MIT
/// @file
/// The formats: a row for each component type, with its codec (store/texel_codec.h) and the function that names its
/// consumers (formats-inl.h).
#pragma once

#define SHD_TEXTURE_FORMATS(ROW)              \
  ROW(kUnorm8, Unorm8Codec, Unorm8Kernels)    \
  ROW(kSrgb8, Srgb8Codec, Srgb8Kernels)       \
  ROW(kUnorm16, Unorm16Codec, Unorm16Kernels) \
  ROW(kFloat16, Float16Codec, Float16Kernels) \
  ROW(kFloat32, Float32Codec, Float32Kernels)
