// SPDX-License-Identifier: MIT
/// @file
/// Levels of a compressed texture in memory: rows of blocks, packed. The last blocks of a row or column may reach
/// beyond the level.
#pragma once

#include "texture/store/storage.h"
#include "texture/texture.h"

namespace shd::texture {

/// Returns the number of blocks along a side of `texels` texels.
constexpr uint32_t blocks_along(uint32_t texels) {
  return (texels + image::kBlockSide - 1) / image::kBlockSide;
}

/// One level of one layer: where its texels and blocks lie.
struct BlockLevel {
  uint32_t first, end;  // texels first..end - 1 of the texture
  uint32_t width;       // [texels]
  uint32_t block;       // first block
  uint32_t across;      // blocks in a row
  uint64_t inverse;     // see row_of_texel()
  uint32_t number;      // differs between adjacent levels
};

/// Returns the level of a texel.
BlockLevel block_level_of(const Texture& texture, uint32_t texel);

/// Returns n / width for n < 2^28, with inverse = floor(2^44 / width) + 1 = (2^44 + e) / width, where 0 < e <= width.
/// The product exceeds n 2^44 / width by n e / width < 2^44 / width, so the quotient is exact. It is below 2^16, so the
/// product stays below 2^61.
constexpr uint64_t inverse_of(uint32_t width) {
  return (uint64_t{1} << 44) / width + 1;
}
constexpr uint32_t row_of_texel(uint32_t n, uint64_t inverse) {
  return static_cast<uint32_t>(n * inverse >> 44);
}

/// Returns the first byte of a block, which may be borrowed.
inline const uint8_t* block_at(const Texture& texture, uint32_t block) {
  return (block < texture.blocks.borrowed ? texture.borrowed : texture.origin) + size_t{block} * texture.blocks.size;
}

/// The latest block that texel_of() decoded.
struct DecodedBlock {
  uint32_t block = UINT32_MAX;
  alignas(16) uint8_t texels[16 * 8];  // [4][4]
};

/// Returns the first byte of a decoded texel of a compressed texture, in `buffer`.
const uint8_t* decoded_texel(const Texture& texture, uint32_t texel, DecodedBlock* buffer);

/// Returns the first byte of a texel of any texture: in memory, or decoded in `buffer`.
inline const uint8_t* texel_of(const Texture& texture, uint32_t texel, DecodedBlock* buffer) {
  return has_blocks(texture) ? decoded_texel(texture, texel, buffer) : texel_at(texture, texel);
}

/// Copies or borrows the blocks of a checked desc. `texture` has its sizes and the texels of its levels.
void copy_blocks(const core::Context& context, const shd_texture_desc& desc, Texture* texture);

/// Returns the first byte of row y of the blocks of a level of a layer.
inline const uint8_t* block_row(const Texture& texture, uint32_t layer, uint32_t level, uint32_t y) {
  const uint32_t width = texture.width >> level ? texture.width >> level : 1;
  return block_at(texture,
                  layer * texture.blocks.layer_blocks + texture.blocks.offset[level] + y * blocks_along(width));
}

}  // namespace shd::texture
