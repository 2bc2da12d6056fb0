// SPDX-License-Identifier: MIT
#include <shd/texture.h>

#include <cstring>

#include "abi/desc.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "abi/levels.h"
#include "image/format.h"
#include "texture/block/levels.h"
#include "texture/store/storage.h"
#include "texture/texture.h"
#include "texture/tile/cache.h"
#include "texture/tile/regions.h"

namespace {

using namespace shd;
using namespace shd::abi;

/// Texel indices of all levels, times four channels, stay within 32-bit gathers.
constexpr uint64_t kMaxTexels = uint64_t{1} << 28;
constexpr uint64_t kMaxRipmapTexels = uint64_t{1} << 26;
constexpr uint64_t kMaxTiles = uint64_t{1} << 30;

/// Size, layers and tables of a texture of directions.
shd_result check_directions(const shd_texture_desc& desc) {
  if (desc.projection == SHD_PROJECTION_NONE) return SHD_OK;
  const int projection = static_cast<int>(desc.projection);
  if (desc.projection != SHD_PROJECTION_LAT_LONG && desc.width != desc.height) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "texture.height: %u, but images of projection %d are square, %u x %u",
                      desc.height, projection, desc.width, desc.width);
  }
  if (desc.projection == SHD_PROJECTION_CUBE && desc.layers != 6) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "texture.layers: %u, but SHD_PROJECTION_CUBE has 6 faces",
                      desc.layers);
  }
  if (desc.tables & ~uint32_t{SHD_TABLE_MIPMAP}) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT,
                      "texture.tables: 0x%x, but a texture with projection %d has SHD_TABLE_MIPMAP only", desc.tables,
                      projection);
  }
  return SHD_OK;
}

/// 2D, 3D, or directions.
shd_result check_kind(const shd_texture_desc& desc) {
  SHD_TRY(check_count("texture.depth", desc.depth, 0, 65536));
  SHD_TRY(check_enum("texture.projection", desc.projection, SHD_PROJECTION_NONE, SHD_PROJECTION_OCTAHEDRAL));
  if (desc.depth != 0 && desc.projection != SHD_PROJECTION_NONE) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "texture.projection: %d, but texture.depth is %u, not 0",
                      static_cast<int>(desc.projection), desc.depth);
  }
  SHD_TRY(check_directions(desc));
  if (desc.depth == 0) return SHD_OK;
  if (desc.layers != 1) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "texture.layers: %u, but texture.depth is %u, not 0", desc.layers,
                      desc.depth);
  }
  if (desc.tables & ~uint32_t{SHD_TABLE_MIPMAP}) {
    return core::fail(SHD_ERROR_UNSUPPORTED, "texture.tables: %#x, but a 3D texture has SHD_TABLE_MIPMAP only",
                      desc.tables);
  }
  return SHD_OK;
}

/// Layers of a texture, or slices of a 3D texture.
uint32_t image_count(const shd_texture_desc& desc) {
  return desc.depth != 0 ? desc.depth : desc.layers;
}

/// `layer_size` is the size of one layer in bytes, with its row stride.
shd_result check_layers(const shd_texture_desc& desc, size_t alignment, size_t layer_size) {
  const size_t stride = desc.layer_stride ? desc.layer_stride : layer_size;
  if (stride < layer_size) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "texture.layer_stride: %zu is below %zu", stride, layer_size);
  }
  if (stride % alignment != 0) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "texture.layer_stride: %zu is not a multiple of %zu", stride,
                      alignment);
  }
  size_t bytes;
  if (__builtin_mul_overflow(stride, size_t{image_count(desc)}, &bytes) || bytes > PTRDIFF_MAX) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "texture.layer_stride: %zu times %u layers exceeds the address space",
                      stride, image_count(desc));
  }
  return SHD_OK;
}

shd_result check_rows(const shd_texture_desc& desc) {
  SHD_TRY(check_not_null("texture.texels", desc.texels));
  const image::RowLayout layout = image::row_layout(desc.format, desc.width, desc.height);
  const size_t row = layout.row_size;
  const size_t stride = desc.row_stride ? desc.row_stride : row;
  if (stride < row) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "texture.row_stride: %zu is below %zu", stride, row);
  }
  if (stride % layout.alignment != 0) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "texture.row_stride: %zu is not a multiple of %zu", stride,
                      layout.alignment);
  }
  size_t bytes;
  if (__builtin_mul_overflow(stride, size_t{layout.rows}, &bytes) || bytes > PTRDIFF_MAX) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "texture.row_stride: %zu times %u rows exceeds the address space",
                      stride, layout.rows);
  }
  SHD_TRY(check_layers(desc, layout.alignment, bytes));
  if (reinterpret_cast<uintptr_t>(desc.texels) % layout.alignment != 0) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "texture.texels: not aligned to %zu bytes", layout.alignment);
  }
  return SHD_OK;
}

/// Checks texels that are not copied; their rows are checked already.
shd_result check_borrow(const shd_texture_desc& desc, const image::FormatInfo& format) {
  SHD_TRY(check_flags("texture.flags", desc.flags, SHD_TEXTURE_BORROW | SHD_TEXTURE_BORROW_LEVELS));
  if (!(desc.flags & SHD_TEXTURE_BORROW)) {
    if (desc.flags == 0) return SHD_OK;
    return core::fail(SHD_ERROR_INVALID_ARGUMENT,
                      "texture.flags: SHD_TEXTURE_BORROW_LEVELS without SHD_TEXTURE_BORROW");
  }
  if (format.channels == 3) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "texture.flags: SHD_TEXTURE_BORROW, but format %u has three channels",
                      desc.format);
  }
  if (desc.layers != 1) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "texture.flags: SHD_TEXTURE_BORROW, but %u layers, not 1",
                      desc.layers);
  }
  const image::RowLayout layout = image::row_layout(desc.format, desc.width, desc.height);
  const size_t row = layout.row_size;
  if (desc.row_stride != 0 && desc.row_stride != row) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT,
                      "texture.flags: SHD_TEXTURE_BORROW, but texture.row_stride %zu, not %zu", desc.row_stride, row);
  }
  if (desc.depth > 1 && desc.layer_stride != 0 && desc.layer_stride != row * desc.height) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT,
                      "texture.flags: SHD_TEXTURE_BORROW, but texture.layer_stride %zu, not %zu", desc.layer_stride,
                      row * desc.height);
  }
  if (image::is_block_format(enum_bits(desc.format))) return SHD_OK;
  const size_t alignment = format.pixel_size < 4 ? format.pixel_size : 4;
  if (reinterpret_cast<uintptr_t>(desc.texels) % alignment != 0) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT,
                      "texture.flags: SHD_TEXTURE_BORROW, but texture.texels not aligned to %zu bytes", alignment);
  }
  return SHD_OK;
}

shd_result check_given_levels(const shd_texture_desc& desc) {
  if (desc.level_count == 0) return SHD_OK;
  if (!(desc.tables & SHD_TABLE_MIPMAP)) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "texture.level_count: %u without SHD_TABLE_MIPMAP", desc.level_count);
  }
  SHD_TRY(check_count("texture.level_count", desc.level_count, 0,
                      texture::full_level_count(desc.width, desc.height, desc.depth) - 1));
  SHD_TRY(check_not_null("texture.levels", desc.levels));
  if (desc.depth != 0) {
    return check_slices("texture.levels", desc.levels, desc.level_count, desc.format, desc.width, desc.height,
                        desc.depth);
  }
  return check_levels("texture.levels", desc.levels, desc.layers, desc.level_count, desc.format, desc.width,
                      desc.height);
}

/// Whether the levels that are borrowed follow one another in memory; they are checked already.
shd_result check_borrowed_levels(const shd_texture_desc& desc) {
  if (!(desc.flags & SHD_TEXTURE_BORROW_LEVELS)) return SHD_OK;
  if (desc.depth != 0 || image::is_block_format(enum_bits(desc.format))) {
    return core::fail(SHD_ERROR_UNSUPPORTED, "texture.flags: SHD_TEXTURE_BORROW_LEVELS, but the texture %s",
                      desc.depth != 0 ? "is 3D" : "has compressed blocks");
  }
  if (desc.tables & ~uint32_t{SHD_TABLE_MIPMAP} || desc.level_count == 0) {
    return core::fail(
        SHD_ERROR_INVALID_ARGUMENT,
        "texture.flags: SHD_TEXTURE_BORROW_LEVELS, but texture.level_count %u and texture.tables %#x, not "
        "1 or more and SHD_TABLE_MIPMAP alone",
        desc.level_count, desc.tables);
  }
  const size_t size = image::format_info(desc.format).pixel_size;
  const uint8_t* next = static_cast<const uint8_t*>(desc.texels) + size * desc.width * desc.height;
  for (uint32_t level = 0; level < desc.level_count; ++level) {
    const shd_image image = texture::image_at(desc.levels, level);
    if (image.pixels != next || image.row_stride != image.width * size) {
      return core::fail(SHD_ERROR_INVALID_ARGUMENT,
                        "texture.levels[%u].%s, but SHD_TEXTURE_BORROW_LEVELS has packed levels one after another",
                        level, image.pixels != next ? "pixels: not behind the finer level" : "row_stride: not packed");
    }
    next += size * image.width * image.height;
  }
  return SHD_OK;
}

/// A texture in tiles: what it can have, and how many tiles.
shd_result check_tiles(const shd_texture_desc& desc) {
  texture::TileCache* cache;
  SHD_TRY(read_handle("texture.tiles.cache", desc.tiles.cache, core::ObjectType::kTileCache, &cache));
  SHD_TRY(check_not_null("texture.tiles.load", reinterpret_cast<const void*>(desc.tiles.load)));
  if (desc.texels || desc.levels) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "texture.%s: not NULL, but texture.tiles has a cache",
                      desc.texels ? "texels" : "levels");
  }
  SHD_TRY(check_zero("texture.row_stride", desc.row_stride));
  SHD_TRY(check_zero("texture.layer_stride", desc.layer_stride));
  SHD_TRY(check_zero("texture.flags", desc.flags));
  const image::FormatInfo format = image::format_info(desc.format);
  if (image::is_block_format(enum_bits(desc.format)) || format.channels == 3) {
    return core::fail(SHD_ERROR_UNSUPPORTED, "texture.format: %d has %s, but texture.tiles has a cache",
                      static_cast<int>(desc.format), format.channels == 3 ? "three channels" : "compressed blocks");
  }
  if (desc.tables & ~uint32_t{SHD_TABLE_MIPMAP} || desc.depth != 0 || desc.projection != SHD_PROJECTION_NONE) {
    return core::fail(SHD_ERROR_UNSUPPORTED,
                      "texture.tables: %#x, depth %u, projection %d, but a texture in tiles is 2D and has "
                      "SHD_TABLE_MIPMAP only",
                      desc.tables, desc.depth, static_cast<int>(desc.projection));
  }
  if (desc.level_count != 0) {
    if (!(desc.tables & SHD_TABLE_MIPMAP)) {
      return core::fail(SHD_ERROR_INVALID_ARGUMENT, "texture.level_count: %u without SHD_TABLE_MIPMAP",
                        desc.level_count);
    }
    SHD_TRY(check_count("texture.level_count", desc.level_count, 0,
                        texture::full_level_count(desc.width, desc.height) - 1));
  }
  const uint64_t tiles = texture::tile_count(desc, cache->tile_bytes());
  return check_count("texture.tiles: number of tiles of all levels and layers", tiles, 1, kMaxTiles);
}

/// Kind, tables and levels of a texture of compressed blocks.
shd_result check_blocks(const shd_texture_desc& desc) {
  if (!image::is_block_format(enum_bits(desc.format))) return SHD_OK;
  if (desc.depth != 0) {
    return core::fail(SHD_ERROR_UNSUPPORTED,
                      "texture.depth: %u, but format %u has compressed blocks, which 2D has only", desc.depth,
                      desc.format);
  }
  if (desc.tables & ~uint32_t{SHD_TABLE_MIPMAP}) {
    return core::fail(SHD_ERROR_UNSUPPORTED,
                      "texture.tables: %#x, but a texture of compressed blocks has SHD_TABLE_MIPMAP only", desc.tables);
  }
  if (desc.tables & SHD_TABLE_MIPMAP && desc.level_count == 0 && (desc.width > 1 || desc.height > 1)) {
    return core::fail(SHD_ERROR_UNSUPPORTED,
                      "texture.level_count: 0, but mip levels of compressed blocks must be given in texture.levels");
  }
  return SHD_OK;
}

shd_result check_texels(const shd_texture_desc& desc) {
  const char* const product = desc.depth != 0 ? "texture.width * texture.height * texture.depth"
                                              : "texture.width * texture.height * texture.layers";
  const uint64_t slice = uint64_t{desc.width} * desc.height;  // at most 2^32
  return check_count(product, slice * image_count(desc), 1,
                     desc.tables & SHD_TABLE_RIPMAP ? kMaxRipmapTexels : kMaxTexels);
}

/// Texels and levels in memory.
shd_result check_memory(const shd_texture_desc& desc) {
  SHD_TRY(check_texels(desc));
  SHD_TRY(check_blocks(desc));
  SHD_TRY(check_rows(desc));
  SHD_TRY(check_borrow(desc, image::format_info(desc.format)));
  SHD_TRY(check_given_levels(desc));
  return check_borrowed_levels(desc);
}

shd_result check_texture_desc(const shd_texture_desc& desc) {
  const uint32_t bits = enum_bits(desc.format);
  if (!image::is_format(bits) && !image::is_block_format(bits)) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "texture.format: %u is not a format", bits);
  }
  const uint32_t largest = desc.tiles.cache ? 1u << 20 : 65536;
  SHD_TRY(check_count("texture.width", desc.width, 1, largest));
  SHD_TRY(check_count("texture.height", desc.height, 1, largest));
  SHD_TRY(check_count("texture.layers", desc.layers, 1, 2048));
  SHD_TRY(check_kind(desc));
  SHD_TRY(check_flags("texture.tables", desc.tables, SHD_TABLE_MIPMAP | SHD_TABLE_RIPMAP | SHD_TABLE_SUMMED_AREA));
  SHD_TRY(desc.tiles.cache ? check_tiles(desc) : check_memory(desc));
  for (const shd_channel channel : desc.swizzle) {
    SHD_TRY(check_enum("texture.swizzle", channel, SHD_CHANNEL_DEFAULT, SHD_CHANNEL_FILL));
  }
  return check_finite("texture.fill", desc.fill, 4);
}

shd_texture_flags flags_of(const texture::Texture& texture) {
  if (!texture.borrowed) return SHD_TEXTURE_NONE;
  const bool base_only = texture.borrowed_texels <= texture.width * texture.height * texture::image_count(texture);
  return base_only ? SHD_TEXTURE_BORROW : SHD_TEXTURE_BORROW | SHD_TEXTURE_BORROW_LEVELS;
}

/// Whether a texture has texels that an update can write.
shd_result check_updatable(const texture::Texture& texture) {
  if (texture::has_blocks(texture)) {
    return core::fail(SHD_ERROR_UNSUPPORTED, "texture: format %d has compressed blocks, which cannot be updated",
                      static_cast<int>(texture.format));
  }
  if (texture::has_tiles(texture)) {
    return core::fail(SHD_ERROR_UNSUPPORTED, "texture: in tiles, which shd_texture_drop_tiles() updates");
  }
  if (flags_of(texture) & SHD_TEXTURE_BORROW_LEVELS) {
    return core::fail(SHD_ERROR_UNSUPPORTED, "texture: its levels are borrowed, so they cannot be updated");
  }
  return SHD_OK;
}

/// The caller's texels of an update; those of a borrowed base level are there already.
shd_result read_update_texels(const texture::Texture& texture, const shd_image* in, shd_image* out) {
  if (!texture.borrowed) return read_image("texels", in, out);
  shd_image image = shd_image_default();
  SHD_TRY(read_desc("texels", in, false, &image));
  if (image.pixels) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "texels.pixels: not NULL, but the base level is borrowed");
  }
  image.struct_size = sizeof image;
  image.pixels = const_cast<uint8_t*>(texture.borrowed);
  return read_image("texels", &image, out);
}

/// Texels of an update: their format, and that the rectangle lies in the base level.
shd_result check_update(const texture::Texture& texture, uint32_t layer, uint32_t x, uint32_t y,
                        const shd_image& texels) {
  SHD_TRY(check_count("layer", layer, 0, texture::image_count(texture) - 1));
  SHD_TRY(check_count("x", x, 0, texture.width - 1));
  SHD_TRY(check_count("y", y, 0, texture.height - 1));
  SHD_TRY(check_count("texels.width", texels.width, 1, texture.width - x));
  SHD_TRY(check_count("texels.height", texels.height, 1, texture.height - y));
  if (texels.format != texture.format && texels.format != texture.given_format) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "texels.format: %d is not the texture's %d",
                      static_cast<int>(texels.format), static_cast<int>(texture.given_format));
  }
  return SHD_OK;
}

}  // namespace

extern "C" {

shd_result shd_texture_create(shd_context* context, const shd_texture_desc* desc, shd_texture** out_texture) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_not_null("out_texture", out_texture));
    *out_texture = nullptr;
    SHD_TRY(check_context(context));
    shd_texture_desc read = shd_texture_desc_default();
    SHD_TRY(read_desc("texture", desc, false, &read));
    SHD_TRY(check_texture_desc(read));

    core::Context& owner = context_of(context);
    auto* body = core::create<texture::Texture>(owner.allocator);
    try {
      texture::build(owner, read, body);
    } catch (...) {
      core::destroy(owner.allocator, body);
      throw;
    }
    make_handle(owner, core::ObjectType::kTexture, body, out_texture);
    if (body->tiles) body->tiles->source.release = read.tiles.release;
    return SHD_OK;
  });
}

void shd_texture_retain(shd_texture* texture) {
  retain_handle(texture, core::ObjectType::kTexture);
}

void shd_texture_release(shd_texture* texture) {
  release_handle(texture, core::ObjectType::kTexture);
}

shd_result shd_texture_get_info(const shd_texture* texture, shd_texture_info* out_info) {
  return guard([&]() -> shd_result {
    SHD_TRY(begin_output("out_info", out_info));
    const texture::Texture* body;
    SHD_TRY(read_handle("texture", texture, core::ObjectType::kTexture, &body));
    shd_texture_info info = shd_texture_info_default();
    info.format = body->format;
    info.width = body->width;
    info.height = body->height;
    info.layers = body->layers;
    info.level_count = body->level_count;
    info.tables = body->tables;
    info.flags = flags_of(*body);
    info.byte_size = texture::has_tiles(*body) ? 0 : texture::byte_size(*body);
    info.depth = body->depth;
    info.projection = body->projection;
    write_desc(info, out_info);
    return SHD_OK;
  });
}

shd_result shd_texture_update(shd_texture* texture, uint32_t layer, uint32_t x, uint32_t y, const shd_image* texels) {
  return guard([&]() -> shd_result {
    texture::Texture* body;
    SHD_TRY(read_handle("texture", texture, core::ObjectType::kTexture, &body));
    SHD_TRY(check_updatable(*body));
    shd_image image;
    SHD_TRY(read_update_texels(*body, texels, &image));
    SHD_TRY(check_update(*body, layer, x, y, image));
    texture::update(*object_of(texture)->context, layer, x, y, image, body);
    return SHD_OK;
  });
}

shd_result shd_texture_read_level(const shd_texture* texture, uint32_t layer, uint32_t level, const shd_image* out) {
  return guard([&]() -> shd_result {
    const texture::Texture* body;
    SHD_TRY(read_handle("texture", texture, core::ObjectType::kTexture, &body));
    SHD_TRY(check_count("level", level, 0, body->level_count - 1));
    const uint32_t slices = texture::level_size(body->depth, level);
    SHD_TRY(check_count("layer", layer, 0, (body->depth != 0 ? slices : body->layers) - 1));
    shd_image image;
    SHD_TRY(read_pixels_or_blocks("out", out, &image));
    if (image.format != body->format) {
      return core::fail(SHD_ERROR_INVALID_ARGUMENT, "out.format: %d is not the texture's %d",
                        static_cast<int>(image.format), static_cast<int>(body->format));
    }
    const uint32_t width = texture::level_size(body->width, level), height = texture::level_size(body->height, level);
    SHD_TRY(check_count("out.width", image.width, width, width));
    SHD_TRY(check_count("out.height", image.height, height, height));
    if (texture::has_tiles(*body)) {
      texture::read_level(*body, layer, level, image);
      return SHD_OK;
    }
    const image::RowLayout layout = image::row_layout(image.format, width, height);
    auto* pixels = static_cast<uint8_t*>(image.pixels);
    for (uint32_t y = 0; y < layout.rows; ++y) {
      const uint8_t* row = texture::has_blocks(*body) ? texture::block_row(*body, layer, level, y)
                                                      : texture::row_of(*body, layer, level, y);
      std::memcpy(pixels + y * image.row_stride, row, layout.row_size);
    }
    return SHD_OK;
  });
}

}  // extern "C"
