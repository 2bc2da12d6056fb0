// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <shd/image.h>

#include "core/simd_target.h"
#include "image/format.h"

namespace shd::image {

/// Whether planes can be encoded to the format: interleaved RGBA of any component type.
constexpr bool can_encode(shd_format format) {
  return format_info(format).channels == 4;
}

/// Encodes `count` pixels of four planes, r, g, b and a, to interleaved pixels. Integer formats clamp to 0..1 (NaN to
/// 0) and round to nearest; colour of RGBA8_SRGB is encoded by IEC 61966-2-1 before it is rounded, alpha is not.
/// @param format  accepted by can_encode()
void encode_pixels(const core::SimdTarget& simd, shd_format format, const float* const plane[4], size_t count,
                   void* out);

// Channels that a format lacks decode to 0, alpha to 1. Decoded pixels are encoded to the same bits, except for the
// bits of NaN.

/// Decodes `count` packed pixels of any format to four planes of linear values.
void decode_pixels(shd_format format, const void* in, size_t count, float* const plane[4]);

/// Decodes `count` pixels of any format, which lie `step` bytes apart, to packed RGBA of linear values.
void decode_pixels(shd_format format, const void* in, ptrdiff_t step, size_t count, float* rgba);

}  // namespace shd::image
