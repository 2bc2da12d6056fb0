// SPDX-License-Identifier: MIT
#pragma once

#include "texture/store/stores.h"
#include "texture/texture.h"

namespace shd::texture {

/// Reads single texels of a texture, wherever they lie: for oracles, because filters read streams.
class TexelReader {
 public:
  explicit TexelReader(const Texture& texture)
      : texture_(texture), source_(texture), in_memory_(is_in_memory(texture)) {}

  /// Returns the first byte of texel (x, y) of an image, as it is stored or decoded. `first` is the first unit of the
  /// level of the image (first_unit()), `width` the width of the level in texels. The bytes stay until the next call.
  /// Texels of tiles load their tile; throws Failure if that fails.
  const uint8_t* at(uint32_t first, uint32_t width, uint32_t x, uint32_t y) {
    return in_memory_ ? source_.texel(first + y * width + x) : in_unit(first, width, x, y);
  }

 private:
  const uint8_t* in_unit(uint32_t first, uint32_t width, uint32_t x, uint32_t y);

  const Texture& texture_;
  const TexelSource source_;
  const bool in_memory_;
  TexelMemory memory_;
};

}  // namespace shd::texture
