// SPDX-License-Identifier: MIT
/// @file
/// Levels of a compressed texture in memory: rows of blocks, packed. The last blocks of a row or column may reach
/// beyond the level.
#pragma once

#include "texture/store/storage.h"
#include "texture/store/stores.h"
#include "texture/texture.h"

namespace shd::texture {

/// Returns the first byte of a block, which may be borrowed.
inline const uint8_t* block_at(const Texture& texture, uint32_t block) {
  return (block < texture.borrowed_units ? texture.borrowed : texture.origin) + size_t{block} * texture.bc.size;
}

/// Returns the first byte of texel (x, y) of a block, decoded in `memory` (StoreRow::texel).
const uint8_t* texel_of_block(const Texture& texture, uint32_t block, uint32_t x, uint32_t y, TexelMemory* memory);

/// Returns the first byte of row y of the blocks of a level of an image.
inline const uint8_t* block_row(const Texture& texture, uint32_t image, uint32_t level, uint32_t y) {
  const uint32_t across = units_along(level_size(texture.width, level), texture.layout.unit.shift_x);
  return block_at(texture, first_unit(texture, image, level) + y * across);
}

}  // namespace shd::texture
