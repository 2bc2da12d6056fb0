// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/context.h"
#include "film/framebuffer.h"

namespace shd::film {

/// State of a texel of a bake, as shd_texel_state; kShared is added where several triangles cover the centre.
constexpr uint8_t kTexelEmpty = 0, kTexelCentre = 1, kTexelTouched = 2, kTexelDilated = 3, kTexelShared = 0x80;

/// For each empty texel, the nearest texel that is not, as row * width + column; equally near ones by row, then column.
/// kNoTexel where the texel is not empty, or where all others are farther than `radius` texels. Throws Failure and
/// std::bad_alloc.
constexpr uint32_t kNoTexel = 0xffffffffu;
core::Array<uint32_t> nearest_texels(const core::Context& context, uint32_t width, uint32_t height, uint32_t radius,
                                     const uint8_t* texels);

/// Copies every plane of the nearest texel to empty texels within `radius` and marks them as dilated. Throws Failure
/// and std::bad_alloc.
/// @param texels  [height][width] states
void dilate(const core::Context& context, uint32_t radius, uint8_t* texels, Framebuffer* framebuffer);

}  // namespace shd::film
