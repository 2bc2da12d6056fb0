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
  return lay_out(tile_shape(tile_bytes, decoded_texel_size(desc.format)), &texture) * desc.layer_count;
}

void add_tiles(const core::Context& context, const shd_texture_desc& desc, Texture* out) {
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

bool is_same_level(const Texture& texture, uint32_t a, uint32_t b) {
  const uint32_t layer_units = texture.layout.layer_units;
  return a / layer_units == b / layer_units && place_of_unit(texture, a).level == place_of_unit(texture, b).level;
}

shd_tile tile_at(const Texture& texture, uint32_t tile) {
  const UnitPlace place = place_of_unit(texture, tile);
  const UnitShape unit = texture.layout.unit;
  const uint32_t width = level_size(texture.width, place.level), height = level_size(texture.height, place.level);
  const uint32_t across = units_along(width, unit.shift_x);
  shd_tile at = {};
  at.layer = place.image;
  at.level = place.level;
  at.area.x = place.in_level % across << unit.shift_x;
  at.area.y = place.in_level / across << unit.shift_y;
  at.area.width = std::min(1u << unit.shift_x, width - at.area.x);
  at.area.height = std::min(1u << unit.shift_y, height - at.area.y);
  return at;
}

}  // namespace shd::texture
