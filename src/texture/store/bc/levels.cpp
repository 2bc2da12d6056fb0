// SPDX-License-Identifier: MIT
#include "texture/store/bc/levels.h"

#include <cstring>

#include "core/cache_pool.h"
#include "core/executor.h"
#include "texture/format/bc/decode.h"
#include "texture/store/image_list.h"

namespace shd::texture {

const uint8_t* decoded_texel(const Texture& texture, uint32_t block, uint32_t x, uint32_t y, DecodedBlock* buffer) {
  const size_t size = texel_size(texture);
  if (buffer->block != block) texture.blocks.decode(block_at(texture, block), buffer->texels, 4 * size);
  buffer->block = block;
  return buffer->texels + (y * 4 + x) * size;
}

namespace {

/// The rows of blocks of an image of the caller.
struct GivenBlocks {
  const void* first;
  size_t stride;
};

/// Copies the rows of blocks of a level of an image.
void copy_blocks_of(const GivenBlocks& given, uint32_t image, uint32_t level, Texture* texture) {
  const UnitShape unit = texture->layout.unit;
  const uint32_t rows = units_along(level_size(texture->height, level), unit.shift_y);
  const size_t row = size_t{units_along(level_size(texture->width, level), unit.shift_x)} * texture->blocks.size;
  const auto* from = static_cast<const uint8_t*>(given.first);
  for (uint32_t y = 0; y < rows; ++y, from += given.stride) {
    std::memcpy(const_cast<uint8_t*>(block_row(*texture, image, level, y)), from, row);
  }
}

/// Allocates the blocks that are not borrowed.
void allocate_blocks(const core::Context& context, const shd_texture_desc& desc, Texture* texture) {
  const size_t block_size = texture->blocks.size;
  const size_t count = lay_out({2, 2}, texture) * desc.layers;
  if (desc.flags & SHD_TEXTURE_BORROW) {  // one layer
    texture->borrowed = static_cast<const uint8_t*>(desc.texels);
    texture->borrowed_units = slice_units(*texture, 0) * image_count(*texture);
  }
  const size_t borrowed = texture->borrowed_units * block_size, size = core::checked_mul(count, block_size) - borrowed;
  texture->texels = core::Array<uint8_t>(context.allocator, size + kPadding);
  std::memset(texture->texels.data() + size, 0, kPadding);
  texture->origin = reinterpret_cast<const uint8_t*>(reinterpret_cast<uintptr_t>(texture->texels.data()) - borrowed);
}

}  // namespace

void copy_blocks(const core::Context& context, const shd_texture_desc& desc, Texture* texture) {
  texture->blocks.decode = decoder_of(desc.format);
  texture->blocks.size = static_cast<uint32_t>(image::block_info(desc.format).block_size);
  texture->blocks.caches = context.caches;
  texture->blocks.owner = context.caches ? context.caches->new_owner() : 0;
  allocate_blocks(context, desc, texture);
  const image::RowLayout rows = image::row_layout(desc.format, desc.width, desc.height);
  const size_t stride = desc.row_stride ? desc.row_stride : rows.row_size;
  const size_t layer_stride = desc.layer_stride ? desc.layer_stride : stride * rows.rows;
  const auto* base = static_cast<const uint8_t*>(desc.texels);
  if (!texture->borrowed) {
    core::parallel_for(context, image_count(*texture), [&](uint32_t image, uint32_t) {
      copy_blocks_of({base + image * layer_stride, stride}, image, 0, texture);
    });
  }
  for_given_levels(context, desc, [&](const shd_image& given, uint32_t image, uint32_t level) {
    copy_blocks_of({given.pixels, given.row_stride}, image, level, texture);
  });
}

}  // namespace shd::texture
