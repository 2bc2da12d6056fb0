// SPDX-License-Identifier: MIT
#include "texture/table/decoded.h"

#include "core/executor.h"
#include "texture/store/bc/levels.h"
#include "texture/store/storage.h"
#include "texture/store/tiles/regions.h"

namespace shd::texture {
namespace {

/// Returns the format of decoded texels.
shd_format decoded_format(const Texture& texture) {
  uint32_t format = 0;
  while (!image::is_format(format) ||
         image::format_info(static_cast<shd_format>(format)).channels != texture.channels ||
         image::format_info(static_cast<shd_format>(format)).component != texture.component) {
    ++format;
  }
  return static_cast<shd_format>(format);
}

/// Decodes a level of a layer of blocks.
void decode_level(const core::Context& context, const Texture& texture, uint32_t layer, const shd_image& out,
                  uint32_t level) {
  const size_t size = texel_size(texture);
  core::parallel_for(context, units_along(out.height, 2), [&](uint32_t row, uint32_t) {
    const uint8_t* block = block_row(texture, layer, level, row);
    for (uint32_t x = 0; x < out.width; x += 4, block += texture.blocks.size) {
      uint8_t texels[16 * 8];
      texture.blocks.decode(block, texels, 4 * size);
      const size_t columns = out.width - x < 4 ? out.width - x : 4;
      for (uint32_t y = 4 * row; y < 4 * row + 4 && y < out.height; ++y) {
        std::memcpy(static_cast<uint8_t*>(out.pixels) + y * out.row_stride + x * size, texels + y % 4 * 4 * size,
                    columns * size);
      }
    }
  });
}

/// The levels of a texture in memory.
struct Levels {
  core::Array<uint8_t> texels;
  core::Array<shd_image> images;  // [layers][levels]
};

Levels read_levels(const core::Context& context, const Texture& texture) {
  const size_t size = texel_size(texture);
  Texture plain = {};
  plain.width = texture.width, plain.height = texture.height, plain.level_count = texture.level_count;
  const size_t layer_texels = lay_out({0, 0}, &plain);
  Levels levels = {core::Array<uint8_t>(context.allocator, core::checked_mul(layer_texels * texture.layers, size)),
                   core::Array<shd_image>(context.allocator, size_t{texture.layers} * texture.level_count)};
  for (uint32_t i = 0; i < texture.layers * texture.level_count; ++i) {
    const uint32_t layer = i / texture.level_count, level = i % texture.level_count;
    shd_image image = shd_image_default();
    image.format = decoded_format(texture);
    image.width = level_size(texture.width, level);
    image.height = level_size(texture.height, level);
    image.row_stride = image.width * size;
    // All bases first, as a desc has them.
    const size_t base = size_t{texture.width} * texture.height, rest = layer_texels - base;
    const size_t first =
        level == 0 ? layer * base : texture.layers * base + layer * rest + plain.layout.offset[level] - base;
    image.pixels = levels.texels.data() + first * size;
    levels.images[level == 0 ? layer : texture.layers + layer * (texture.level_count - 1) + level - 1] = image;
    if (has_tiles(texture)) {
      read_level(texture, layer, level, image);
    } else {
      decode_level(context, texture, layer, image, level);
    }
  }
  return levels;
}

}  // namespace

void destroy_part(DecodedTexture* decoded) noexcept {
  core::destroy(*decoded->allocator, decoded);
}

void build_decoded(const core::Context& context, Texture* texture) {
  if (!(texture->tables & (SHD_TABLE_RIPMAP | SHD_TABLE_SUMMED_AREA))) return;
  const Levels levels = read_levels(context, *texture);
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = decoded_format(*texture);
  desc.width = texture->width;
  desc.height = texture->height;
  desc.layers = texture->layers;
  desc.tables = texture->tables;
  desc.texels = levels.texels.data();
  desc.level_count = texture->level_count - 1;
  desc.levels = levels.images.data() + texture->layers;
  Owned<DecodedTexture> decoded(core::create<DecodedTexture>(context.allocator));
  decoded->allocator = &context.allocator;
  build(context, desc, &decoded->texture);
  texture->decoded = static_cast<Owned<DecodedTexture>&&>(decoded);
}

}  // namespace shd::texture
