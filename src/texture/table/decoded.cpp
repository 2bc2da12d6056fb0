// SPDX-License-Identifier: MIT
#include "texture/table/decoded.h"

#include "texture/store/storage.h"
#include "texture/store/stores.h"

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
    functions_of(texture.store).decode_level(context, texture, layer, level, image);
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
  desc.layer_count = texture->layers;
  desc.tables = texture->tables;
  desc.texels = levels.texels.data();
  desc.level_count = texture->level_count - 1;
  desc.level_images = levels.images.data() + texture->layers;
  Owned<DecodedTexture> decoded(core::create<DecodedTexture>(context.allocator));
  decoded->allocator = &context.allocator;
  build(context, desc, &decoded->texture);
  texture->decoded = static_cast<Owned<DecodedTexture>&&>(decoded);
}

}  // namespace shd::texture
