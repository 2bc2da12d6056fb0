// SPDX-License-Identifier: MIT
#pragma once

#include "core/simd_target.h"
#include "texture/block/decode.h"

namespace shd::texture {

/// Returns the decoder of a target with the bits of a scalar decoder.
DecodeBlock kernel_of(DecodeBlock decode, const core::SimdTarget& simd);

/// Sets the four colours of a BC1 block. `opaque`: the fourth of three colours is black, otherwise it is transparent.
void bc1_palette(const uint8_t* block, bool opaque, uint32_t (&palette)[4]);

}  // namespace shd::texture
