// SPDX-License-Identifier: MIT
#include "texture/store/tiles/tile.h"

#include <algorithm>

#include "texture/format/bc/decode.h"
#include "texture/store/storage.h"
#include "texture/store/tiles/cache.h"

namespace shd::texture {
UnitShape tile_shape(uint32_t tile_bytes, size_t texel_size) {
  uint32_t shift = 0;
  while ((texel_size << (shift + 1)) <= tile_bytes) ++shift;
  return {(shift + 1) / 2, shift / 2};
}

void destroy_part(TileSet* tiles) noexcept {
  const core::Allocator& allocator = *tiles->allocator;
  tiles->cache->remove(tiles);
  if (tiles->source.release) tiles->source.release(tiles->source.user_data);
  core::Object* const cache = tiles->cache_handle;
  core::destroy(allocator, tiles);
  core::release(cache, static_cast<uint32_t>(core::ObjectType::kTileCache));
}

namespace {

/// Returns the size of a texel in the cache.
size_t decoded_texel_size(shd_format format) {
  const image::BlockInfo blocks = image::block_info(format);
  if (blocks.block_size == 0) return image::format_info(format).pixel_size;
  return image::format_info(blocks.stored, blocks.component).pixel_size;
}

}  // namespace

uint64_t tile_count(const shd_texture_desc& desc, uint32_t tile_bytes) {
  Texture texture = {};
  texture.width = desc.width;
  texture.height = desc.height;
  texture.depth = desc.depth;
  const bool full = desc.level_count == 0 && desc.tables & SHD_TABLE_MIPMAP;
  texture.level_count = full ? full_level_count(desc.width, desc.height, desc.depth) : desc.level_count + 1;
  return lay_out(tile_shape(tile_bytes, decoded_texel_size(desc.format)), &texture) * desc.layers;
}

void build_tiles(const core::Context& context, const shd_texture_desc& desc, Texture* out) {
  auto* const handle = reinterpret_cast<core::Object*>(desc.tiles.cache);
  constexpr auto kType = static_cast<uint32_t>(core::ObjectType::kTileCache);
  auto* const set = core::create<TileSet>(context.allocator);
  set->cache = static_cast<TileCache*>(core::body_of(handle, kType));
  set->cache_handle = handle;
  set->source = desc.tiles;
  set->source.release = nullptr;  // until the texture is made
  set->allocator = &context.allocator;
  set->texture = out;
  set->decode = image::is_block_format(static_cast<uint32_t>(desc.format)) ? decoder_of(desc.format) : nullptr;
  set->block_size = static_cast<uint32_t>(image::block_info(desc.format).block_size);
  lay_out(tile_shape(set->cache->tile_bytes(), texel_size(*out)), out);
  try {
    set->cache->add(set);
  } catch (...) {
    core::destroy(context.allocator, set);
    throw;
  }
  core::retain(handle, kType);
  out->tiles = Owned<TileSet>(set);
}

uint32_t level_of_tile(const Texture& texture, uint32_t tile) {
  const Layout& layout = texture.layout;
  const uint32_t* const end = layout.offset + texture.level_count;
  return static_cast<uint32_t>(std::upper_bound(layout.offset, end, tile % layout.layer_units) - layout.offset) - 1;
}

bool is_same_level(const Texture& texture, uint32_t a, uint32_t b) {
  const uint32_t layer_units = texture.layout.layer_units;
  return a / layer_units == b / layer_units && level_of_tile(texture, a) == level_of_tile(texture, b);
}

shd_tile tile_at(const Texture& texture, uint32_t tile) {
  const Layout& layout = texture.layout;
  shd_tile at = {};
  at.layer = tile / layout.layer_units;
  at.level = level_of_tile(texture, tile);
  const uint32_t width = level_size(texture.width, at.level), height = level_size(texture.height, at.level);
  const uint32_t in_level = tile % layout.layer_units - layout.offset[at.level];
  const uint32_t in_slice = in_level % slice_units(texture, at.level),
                 slice = in_level / slice_units(texture, at.level);
  if (texture.depth != 0) at.layer = slice;
  const uint32_t across = units_along(width, layout.unit.shift_x);
  at.x = in_slice % across << layout.unit.shift_x;
  at.y = in_slice / across << layout.unit.shift_y;
  at.width = std::min(1u << layout.unit.shift_x, width - at.x);
  at.height = std::min(1u << layout.unit.shift_y, height - at.y);
  return at;
}

}  // namespace shd::texture
