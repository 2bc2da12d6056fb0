// SPDX-License-Identifier: MIT
#include "texture/store/bc/levels.h"

#include <cstring>

#include "core/cache_pool.h"
#include "core/executor.h"
#include "texture/format/bc/decode.h"
#include "texture/store/image_list.h"
#include "texture/store/storage.h"

namespace shd::texture {
BlockLevel block_level_of(const Texture& texture, uint32_t texel) {
  const uint32_t layer = texel / texture.layer_texels, first = layer * texture.layer_texels;
  uint32_t level = 0;
  while (level + 1 < texture.level_count && texel - first >= texture.offset[level + 1]) ++level;
  BlockLevel out;
  out.width = level_size(texture.width, level);
  out.first = first + texture.offset[level];
  out.end = out.first + out.width * level_size(texture.height, level);
  out.block = layer * texture.blocks.layer_blocks + texture.blocks.offset[level];
  out.across = blocks_along(out.width);
  out.inverse = inverse_of(out.width);
  out.number = layer * texture.level_count + level;
  return out;
}

const uint8_t* decoded_texel(const Texture& texture, uint32_t texel, DecodedBlock* buffer) {
  const BlockLevel level = block_level_of(texture, texel);
  const uint32_t y = (texel - level.first) / level.width, x = (texel - level.first) % level.width;
  const uint32_t block = level.block + y / image::kBlockSide * level.across + x / image::kBlockSide;
  const size_t size = texel_size(texture);
  if (buffer->block != block) texture.blocks.decode(block_at(texture, block), buffer->texels, 4 * size);
  buffer->block = block;
  return buffer->texels + (y % 4 * 4 + x % 4) * size;
}

namespace {

/// Sets the layout of all levels. Returns the number of blocks.
size_t lay_out(shd_format format, Texture* texture) {
  BlockLayout& blocks = texture->blocks;
  blocks.decode = decoder_of(format);
  blocks.size = static_cast<uint32_t>(image::block_info(format).block_size);
  size_t count = 0;
  for (uint32_t level = 0; level < kMaxLevels; ++level) {
    blocks.offset[level] = static_cast<uint32_t>(count);
    if (level >= texture->level_count) continue;
    count += size_t{blocks_along(level_size(texture->width, level))} * blocks_along(level_size(texture->height, level));
  }
  blocks.layer_blocks = static_cast<uint32_t>(count);
  return count * texture->layers;
}

/// Copies rows of blocks from a caller's level.
void copy_level(const uint8_t* from, size_t stride, uint32_t layer, uint32_t level, Texture* texture) {
  const uint32_t rows = blocks_along(level_size(texture->height, level));
  const size_t row = size_t{blocks_along(level_size(texture->width, level))} * texture->blocks.size;
  for (uint32_t y = 0; y < rows; ++y, from += stride) {
    std::memcpy(const_cast<uint8_t*>(block_row(*texture, layer, level, y)), from, row);
  }
}

}  // namespace

void copy_blocks(const core::Context& context, const shd_texture_desc& desc, Texture* texture) {
  const size_t count = lay_out(desc.format, texture), block_size = texture->blocks.size;
  texture->blocks.caches = context.caches;
  texture->blocks.owner = context.caches ? context.caches->new_owner() : 0;
  const image::RowLayout rows = image::row_layout(desc.format, desc.width, desc.height);
  if (desc.flags & SHD_TEXTURE_BORROW) {  // one layer
    texture->borrowed = static_cast<const uint8_t*>(desc.texels);
    texture->blocks.borrowed = static_cast<uint32_t>(rows.row_size / block_size * rows.rows);
  }
  const size_t borrowed = texture->blocks.borrowed * block_size, size = core::checked_mul(count, block_size) - borrowed;
  texture->texels = core::Array<uint8_t>(context.allocator, size + kPadding);
  std::memset(texture->texels.data() + size, 0, kPadding);
  texture->origin = reinterpret_cast<const uint8_t*>(reinterpret_cast<uintptr_t>(texture->texels.data()) - borrowed);
  const size_t stride = desc.row_stride ? desc.row_stride : rows.row_size;
  const size_t layer_stride = desc.layer_stride ? desc.layer_stride : stride * rows.rows;
  const auto* base = static_cast<const uint8_t*>(desc.texels);
  core::parallel_for(context, desc.layers * texture->level_count, [&](uint32_t task, uint32_t) {
    const uint32_t layer = task / texture->level_count, level = task % texture->level_count;
    if (level == 0) {
      if (!texture->borrowed) copy_level(base + layer * layer_stride, stride, layer, 0, texture);
      return;
    }
    const shd_image image = image_at(desc.levels, size_t{layer} * desc.level_count + level - 1);
    copy_level(static_cast<const uint8_t*>(image.pixels), image.row_stride, layer, level, texture);
  });
}

}  // namespace shd::texture
