// SPDX-License-Identifier: MIT
#pragma once

#include "core/simd_target.h"
#include "texture/format/bc/decode.h"

namespace shd::texture {

/// Returns the decoder of a target with the bits of a scalar decoder.
DecodeBc kernel_of(DecodeBc decode, const core::SimdTarget& simd);

/// Four colours of RGBA bytes, the first one in the lowest bits.
struct Palette {
  uint64_t low, high;
};

/// Returns the colours of a BC1 block. `opaque`: the fourth of three colours is black, otherwise it is transparent.
Palette bc1_palette(const uint8_t* block, bool opaque);

}  // namespace shd::texture
