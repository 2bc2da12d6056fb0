// SPDX-License-Identifier: MIT
#include "abi/texture_desc.h"

#include "abi/desc.h"
#include "abi/handle.h"
#include "abi/levels.h"
#include "image/format.h"
#include "projection/projection.h"
#include "texture/store/image_list.h"
#include "texture/store/storage.h"
#include "texture/store/stores.h"
#include "texture/store/tiles/cache.h"

namespace shd::abi {
namespace {

/// Texel indices of all levels, times four channels, stay within 32-bit gathers.
constexpr uint64_t kMaxTexels = uint64_t{1} << 28;
constexpr uint64_t kMaxRipmapTexels = uint64_t{1} << 26;
constexpr uint64_t kMaxTiles = uint64_t{1} << 30;

/// Size, layers and tables of a texture of directions.
shd_result check_directions(const shd_texture_desc& desc) {
  const int projection = static_cast<int>(desc.projection);
  if (desc.projection != SHD_PROJECTION_LAT_LONG && desc.width != desc.height) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "texture.height: %u, but images of projection %d are square, %u x %u",
                      desc.height, projection, desc.width, desc.width);
  }
  if (desc.tables & ~uint32_t{SHD_TABLE_MIPMAP}) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT,
                      "texture.tables: 0x%x, but a texture with projection %d has SHD_TABLE_MIPMAP only", desc.tables,
                      projection);
  }
  return SHD_OK;
}

/// Tables and shape of a kind.
shd_result check_kind(const shd_texture_desc& desc) {
  if (desc.projection != SHD_PROJECTION_NONE) return check_directions(desc);
  if (desc.depth == 0) return SHD_OK;
  if (desc.tables & ~uint32_t{SHD_TABLE_MIPMAP}) {
    return core::fail(SHD_ERROR_UNSUPPORTED, "texture.tables: %#x, but a 3D texture has SHD_TABLE_MIPMAP only",
                      desc.tables);
  }
  return SHD_OK;
}

/// Layers of a texture, or slices of a 3D texture.
uint32_t image_count(const shd_texture_desc& desc) {
  return desc.depth != 0 ? desc.depth : static_cast<uint32_t>(desc.layer_count);
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
  SHD_TRY(check_flags("texture.flags", desc.flags,
                      SHD_TEXTURE_BORROW | SHD_TEXTURE_BORROW_LEVELS | SHD_TEXTURE_PREMULTIPLIED));
  if (!(desc.flags & SHD_TEXTURE_BORROW)) {
    if (!(desc.flags & SHD_TEXTURE_BORROW_LEVELS)) return SHD_OK;
    return core::fail(SHD_ERROR_INVALID_ARGUMENT,
                      "texture.flags: SHD_TEXTURE_BORROW_LEVELS without SHD_TEXTURE_BORROW");
  }
  if (image::has_three_numbers(format)) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "texture.flags: SHD_TEXTURE_BORROW, but format %u has three channels",
                      desc.format);
  }
  if (desc.layer_count != 1) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "texture.flags: SHD_TEXTURE_BORROW, but %zu layers, not 1",
                      desc.layer_count);
  }
  const image::RowLayout layout = image::row_layout(desc.format, desc.width, desc.height);
  const size_t row = layout.row_size;
  if (desc.row_stride != 0 && desc.row_stride != row) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT,
                      "texture.flags: SHD_TEXTURE_BORROW, but texture.row_stride %zu, not %zu", desc.row_stride, row);
  }
  if (desc.depth > 1 && desc.layer_stride != 0 && desc.layer_stride != row * layout.rows) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT,
                      "texture.flags: SHD_TEXTURE_BORROW, but texture.layer_stride %zu, not %zu", desc.layer_stride,
                      row * layout.rows);
  }
  if (image::is_block_format(enum_bits(desc.format))) return SHD_OK;
  const size_t alignment = format.pixel_size < 4 ? format.pixel_size : 4;
  if (reinterpret_cast<uintptr_t>(desc.texels) % alignment != 0) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT,
                      "texture.flags: SHD_TEXTURE_BORROW, but texture.texels not aligned to %zu bytes", alignment);
  }
  return SHD_OK;
}

shd_result check_level_count(const shd_texture_desc& desc) {
  if (desc.level_count == 0) return SHD_OK;
  if (!(desc.tables & SHD_TABLE_MIPMAP)) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "texture.level_count: %zu without SHD_TABLE_MIPMAP",
                      desc.level_count);
  }
  return check_count("texture.level_count", desc.level_count, 0,
                     texture::full_level_count(desc.width, desc.height, desc.depth) - 1);
}

shd_result check_given_levels(const shd_texture_desc& desc) {
  SHD_TRY(check_level_count(desc));
  if (desc.level_count == 0) return SHD_OK;
  SHD_TRY(check_not_null("texture.level_images", desc.level_images));
  if (desc.depth != 0) {
    return check_slices("texture.level_images", desc.level_images, static_cast<uint32_t>(desc.level_count), desc.format,
                        desc.width, desc.height, desc.depth);
  }
  return check_levels("texture.level_images", desc.level_images, static_cast<uint32_t>(desc.layer_count),
                      static_cast<uint32_t>(desc.level_count), desc.format, desc.width, desc.height);
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
        "texture.flags: SHD_TEXTURE_BORROW_LEVELS, but texture.level_count %zu and texture.tables %#x, not "
        "1 or more and SHD_TABLE_MIPMAP alone",
        desc.level_count, desc.tables);
  }
  const size_t size = image::format_info(desc.format).pixel_size;
  const uint8_t* next = static_cast<const uint8_t*>(desc.texels) + size * desc.width * desc.height;
  for (uint32_t level = 0; level < desc.level_count; ++level) {
    const shd_image image = texture::image_at(desc.level_images, level);
    if (image.pixels != next || image.row_stride != image.width * size) {
      return core::fail(
          SHD_ERROR_INVALID_ARGUMENT,
          "texture.level_images[%u].%s, but SHD_TEXTURE_BORROW_LEVELS has packed levels one after another", level,
          image.pixels != next ? "pixels: not behind the finer level" : "row_stride: not packed");
    }
    next += size * image.width * image.height;
  }
  return SHD_OK;
}

shd_result check_texels(const shd_texture_desc& desc) {
  const char* const product = desc.depth != 0 ? "texture.width * texture.height * texture.depth"
                                              : "texture.width * texture.height * texture.layer_count";
  const uint64_t slice = uint64_t{desc.width} * desc.height;  // at most 2^32
  return check_count(product, slice * image_count(desc), 1,
                     desc.tables & SHD_TABLE_RIPMAP ? kMaxRipmapTexels : kMaxTexels);
}

/// A texture in tiles: its fields, and how many tiles.
shd_result check_tiles(const shd_texture_desc& desc) {
  texture::TileCache* cache;
  SHD_TRY(read_handle("texture.tiles.cache", desc.tiles.cache, core::ObjectType::kTileCache, &cache));
  SHD_TRY(check_not_null("texture.tiles.load", reinterpret_cast<const void*>(desc.tiles.load)));
  if (desc.texels || desc.level_images) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "texture.%s: not NULL, but texture.tiles has a cache",
                      desc.texels ? "texels" : "level_images");
  }
  if (desc.flags & ~uint32_t{SHD_TEXTURE_PREMULTIPLIED}) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "texture.flags: %#x, but texture.tiles has a cache", desc.flags);
  }
  if (image::has_three_numbers(image::format_info(desc.format))) {
    return core::fail(SHD_ERROR_UNSUPPORTED, "texture.format: %d has three channels, but texture.tiles has a cache",
                      static_cast<int>(desc.format));
  }
  if (desc.tables & ~uint32_t{SHD_TABLE_MIPMAP}) SHD_TRY(check_texels(desc));
  SHD_TRY(check_level_count(desc));
  const uint64_t tiles = texture::tile_count(desc, cache->tile_bytes());
  return check_count("texture.tiles: number of tiles of all levels and layers", tiles, 1, kMaxTiles);
}

/// Kind, tables and levels of a texture of compressed blocks.
shd_result check_blocks(const shd_texture_desc& desc) {
  if (!image::is_block_format(enum_bits(desc.format))) return SHD_OK;
  if (desc.tables & SHD_TABLE_MIPMAP && desc.level_count == 0 && (desc.width > 1 || desc.height > 1)) {
    return core::fail(
        SHD_ERROR_UNSUPPORTED,
        "texture.level_count: 0, but mip levels of compressed blocks must be given in texture.level_images");
  }
  return SHD_OK;
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

/// The largest width and height of textures of a store, and the check of what they are made from.
struct StoreCheck {
  uint32_t largest;
  shd_result (*check)(const shd_texture_desc& desc);
};

StoreCheck check_of(texture::Store store) {
  switch (store) {
    case texture::Store::kMemory:
    case texture::Store::kBorrowed:
    case texture::Store::kBc: return {65536, check_memory};
    case texture::Store::kTiles:
    case texture::Store::kTilesOfBc: return {1u << 20, check_tiles};
  }
  SHD_UNREACHABLE();
}

/// Sets the layers of a cube map, which 1 and 6 both mean.
shd_result count_faces(shd_texture_desc* desc) {
  const uint32_t faces = projection::face_count(desc->projection);
  if (faces == 1) return SHD_OK;
  if (desc->layer_count != 1 && desc->layer_count != faces) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "texture.layer_count: %zu, but images of projection %d have %u faces",
                      desc->layer_count, static_cast<int>(desc->projection), faces);
  }
  desc->layer_count = faces;
  return SHD_OK;
}

}  // namespace

shd_result check_kind_fields(shd_texture_desc* desc) {
  SHD_TRY(check_enum("texture.kind", desc->kind, SHD_TEXTURE_KIND_2D, SHD_TEXTURE_KIND_DIRECTIONS));
  if (desc->kind == SHD_TEXTURE_KIND_3D) {
    SHD_TRY(check_count("texture.depth", desc->depth, 1, 65536));
    SHD_TRY(check_count("texture.layer_count", desc->layer_count, 1, 1));
  } else if (desc->depth != 0) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "texture.depth: %u, but texture.kind is not SHD_TEXTURE_KIND_3D",
                      desc->depth);
  }
  if (desc->kind == SHD_TEXTURE_KIND_DIRECTIONS) {
    SHD_TRY(check_enum("texture.projection", desc->projection, SHD_PROJECTION_LAT_LONG, projection::kLastProjection));
    SHD_TRY(count_faces(desc));
  } else if (desc->projection != SHD_PROJECTION_NONE) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT,
                      "texture.projection: %u, but texture.kind is not SHD_TEXTURE_KIND_DIRECTIONS",
                      enum_bits(desc->projection));
  }
  if (desc->tiles.cache) desc->row_stride = desc->layer_stride = 0;
  return SHD_OK;
}

shd_result check_texture_desc(const shd_texture_desc& desc) {
  const uint32_t bits = enum_bits(desc.format);
  if (!image::is_format(bits) && !image::is_block_format(bits)) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "texture.format: %u is not a format", bits);
  }
  const StoreCheck store = check_of(texture::store_of(desc));
  SHD_TRY(check_count("texture.width", desc.width, 1, store.largest));
  SHD_TRY(check_count("texture.height", desc.height, 1, store.largest));
  SHD_TRY(check_count("texture.layer_count", desc.layer_count, 1, 2048));
  SHD_TRY(check_kind(desc));
  SHD_TRY(check_flags("texture.tables", desc.tables, SHD_TABLE_MIPMAP | SHD_TABLE_RIPMAP | SHD_TABLE_SUMMED_AREA));
  SHD_TRY(store.check(desc));
  for (const shd_channel channel : desc.swizzle) {
    SHD_TRY(check_enum("texture.swizzle", channel, SHD_CHANNEL_DEFAULT, SHD_CHANNEL_FILL));
  }
  return check_finite("texture.fill", desc.fill, 4);
}

}  // namespace shd::abi
