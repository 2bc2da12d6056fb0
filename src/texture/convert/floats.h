// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <shd/projection.h>

#include "core/context.h"
#include "texture/texture.h"

namespace shd::texture {

/// Floats that lookups may read after the last texel.
constexpr size_t kFloatPadding = SHD_TEXTURE_PADDING / sizeof(float);

/// RGBA floats of all directions, [face][height][width][4], and kFloatPadding floats of any value.
struct DirectionFloats {
  shd_projection projection;
  uint32_t width, height;  // size of a face
  core::Array<float> texels;
};

/// Allocates the texels of `out`, whose other fields are set. Throws std::bad_alloc.
void allocate(const core::Allocator& allocator, DirectionFloats* out);

/// Makes a texture of `image`, which it borrows. Throws std::bad_alloc.
void borrow(const core::Context& context, const DirectionFloats& image, Texture* out);

/// The default sampler with another filter.
Sampler sampler_of(shd_filter filter);

}  // namespace shd::texture
