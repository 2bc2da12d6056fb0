// SPDX-License-Identifier: MIT
#include "texture/store/bc/levels.h"

#include <cstring>

#include "core/executor.h"
#include "texture/format/bc/decode.h"
#include "texture/store/bc/cache.h"
#include "texture/store/image_list.h"
#include "texture/store/stores.h"

namespace shd::texture {
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
  const size_t row = size_t{units_along(level_size(texture->width, level), unit.shift_x)} * texture->bc.size;
  const auto* from = static_cast<const uint8_t*>(given.first);
  for (uint32_t y = 0; y < rows; ++y, from += given.stride) {
    std::memcpy(const_cast<uint8_t*>(block_row(*texture, image, level, y)), from, row);
  }
}

/// Allocates the blocks that are not borrowed.
void allocate_blocks(const core::Context& context, const shd_texture_desc& desc, Texture* texture) {
  const size_t block_size = texture->bc.size;
  const size_t count = lay_out({2, 2}, texture) * desc.layer_count;
  if (desc.flags & SHD_TEXTURE_BORROW) {  // one layer
    texture->borrowed = static_cast<const uint8_t*>(desc.texels);
    texture->borrowed_units = slice_units(*texture, 0) * image_count(*texture);
  }
  const size_t borrowed = texture->borrowed_units * block_size, size = core::checked_mul(count, block_size) - borrowed;
  texture->texels = core::Array<uint8_t>(context.allocator, size + kPadding);
  std::memset(texture->texels.data() + size, 0, kPadding);
  texture->origin = reinterpret_cast<const uint8_t*>(reinterpret_cast<uintptr_t>(texture->texels.data()) - borrowed);
}

void copy_blocks(const core::Context& context, const shd_texture_desc& desc, Texture* texture) {
  texture->bc.decode = decoder_of(desc.format);
  texture->bc.size = static_cast<uint32_t>(image::block_info(desc.format).block_size);
  texture->bc.caches = context.caches;
  texture->bc.owner = context.caches ? context.caches->new_owner() : 0;
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

void read_blocks(const core::Context&, const Texture& texture, uint32_t image, uint32_t level, const shd_image& out) {
  const image::RowLayout layout = image::row_layout(out.format, out.width, out.height);
  for (uint32_t y = 0; y < layout.rows; ++y) {
    std::memcpy(static_cast<uint8_t*>(out.pixels) + y * out.row_stride, block_row(texture, image, level, y),
                layout.row_size);
  }
}

void decode_blocks(const core::Context& context, const Texture& texture, uint32_t image, uint32_t level,
                   const shd_image& out) {
  const size_t size = texel_size(texture);
  core::parallel_for(context, units_along(out.height, 2), [&](uint32_t row, uint32_t) {
    const uint8_t* block = block_row(texture, image, level, row);
    for (uint32_t x = 0; x < out.width; x += 4, block += texture.bc.size) {
      uint8_t texels[16 * 8];
      texture.bc.decode(block, texels, 4 * size);
      const size_t columns = out.width - x < 4 ? out.width - x : 4;
      for (uint32_t y = 4 * row; y < 4 * row + 4 && y < out.height; ++y) {
        std::memcpy(static_cast<uint8_t*>(out.pixels) + y * out.row_stride + x * size, texels + y % 4 * 4 * size,
                    columns * size);
      }
    }
  });
}

/// Runs a call with a cache of decoded blocks.
void call_blocks(const Texture& texture, const CallBody& body) {
  CacheLease lease(texture);
  body.run(body.body, {nullptr, &lease, lease.cache()->texels, lease.places()});
}

void begin_blocks(void*, size_t, uint8_t*) {}
void pause_blocks(void*) {}

}  // namespace

const uint8_t* texel_of_block(const Texture& texture, uint32_t block, uint32_t x, uint32_t y, TexelMemory* memory) {
  const size_t size = texel_size(texture);
  if (memory->unit != block) texture.bc.decode(block_at(texture, block), memory->texels, 4 * size);
  memory->unit = block;
  return memory->texels + (y * 4 + x) * size;
}

const StoreRow kBcStore = {copy_blocks, texel_of_block, read_blocks,  decode_blocks, "which cannot be updated",
                           call_blocks, begin_blocks,   pause_blocks, pause_blocks};

}  // namespace shd::texture
