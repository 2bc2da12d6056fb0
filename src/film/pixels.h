// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <shd/image.h>

#include "core/simd_target.h"

namespace shd::film {

/// Whether colour can be encoded to the format: interleaved RGBA of any component type.
bool can_encode(shd_format format);

/// Whether framebuffers can have the format. decode_pixels() decodes these formats, except for RGBA32F.
bool can_draw(shd_format format);

/// Encodes `count` pixels of four planes, r, g, b and a, to interleaved pixels. Integer formats clamp to 0..1 (NaN to
/// 0) and round to nearest; colour of RGBA8_SRGB is encoded by IEC 61966-2-1 before it is rounded, alpha is not.
/// @param format  accepted by can_encode()
void encode_pixels(const core::SimdTarget& simd, shd_format format, const float* const plane[4], size_t count,
                   void* out);

/// Decodes `count` interleaved pixels to four planes of linear values. Decoded pixels are encoded to the same bits,
/// except for the bits of NaN.
/// @param format  RGBA8, RGBA8_SRGB or RGBA16F
void decode_pixels(shd_format format, const void* in, size_t count, float* const plane[4]);

}  // namespace shd::film
