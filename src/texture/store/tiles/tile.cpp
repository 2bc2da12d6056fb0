// SPDX-License-Identifier: MIT
#include "texture/store/tiles/tile.h"

#include <algorithm>

#include "texture/store/storage.h"
#include "texture/store/tiles/cache.h"

namespace shd::texture {
namespace {

uint32_t tiles_along(uint32_t texels, uint32_t shift) {
  return (texels + (1u << shift) - 1) >> shift;
}

}  // namespace

TileShape tile_shape(uint32_t tile_bytes, size_t texel_size) {
  uint32_t shift = 0;
  while ((texel_size << (shift + 1)) <= tile_bytes) ++shift;
  return {(shift + 1) / 2, shift / 2};
}

TileSetOwner::~TileSetOwner() {
  if (!set_) return;
  const core::Allocator& allocator = *set_->allocator;
  set_->cache->remove(set_);
  if (set_->source.release) set_->source.release(set_->source.user_data);
  core::Object* const cache = set_->cache_handle;
  core::destroy(allocator, set_);
  core::release(cache, static_cast<uint32_t>(core::ObjectType::kTileCache));
}

uint64_t tile_count(const shd_texture_desc& desc, uint32_t tile_bytes) {
  const TileShape shape = tile_shape(tile_bytes, image::format_info(desc.format).pixel_size);
  const bool full = desc.level_count == 0 && desc.tables & SHD_TABLE_MIPMAP;
  const uint32_t levels = full ? full_level_count(desc.width, desc.height) : desc.level_count + 1;
  uint64_t tiles = 0;
  for (uint32_t level = 0; level < levels; ++level) {
    tiles += uint64_t{tiles_along(level_size(desc.width, level), shape.shift_x)} *
             tiles_along(level_size(desc.height, level), shape.shift_y);
  }
  return tiles * desc.layers;
}

void lay_out_tiles(const TileShape& shape, Texture* texture) {
  uint64_t tiles = 0;
  for (uint32_t level = 0; level < kMaxLevels; ++level) {
    texture->offset[level] = static_cast<uint32_t>(tiles);
    if (level >= texture->level_count) continue;
    tiles += uint64_t{tiles_along(level_size(texture->width, level), shape.shift_x)} *
             tiles_along(level_size(texture->height, level), shape.shift_y);
  }
  texture->layer_texels = static_cast<uint32_t>(tiles);
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
  set->shape = tile_shape(set->cache->tile_bytes(), texel_size(*out));
  lay_out_tiles(set->shape, out);
  try {
    set->cache->add(set);
  } catch (...) {
    core::destroy(context.allocator, set);
    throw;
  }
  core::retain(handle, kType);
  out->tiles = TileSetOwner(set);
}

uint32_t level_of_tile(const Texture& texture, uint32_t tile) {
  const uint32_t in_layer = tile % texture.layer_texels;
  const uint32_t* const end = texture.offset + texture.level_count;
  return static_cast<uint32_t>(std::upper_bound(texture.offset, end, in_layer) - texture.offset) - 1;
}

bool is_same_level(const Texture& texture, uint32_t a, uint32_t b) {
  return a / texture.layer_texels == b / texture.layer_texels && level_of_tile(texture, a) == level_of_tile(texture, b);
}

shd_tile tile_at(const Texture& texture, uint32_t tile) {
  const TileShape shape = texture.tiles->shape;
  shd_tile at = {};
  at.layer = tile / texture.layer_texels;
  at.level = level_of_tile(texture, tile);
  const uint32_t width = level_size(texture.width, at.level), height = level_size(texture.height, at.level);
  const uint32_t in_level = tile % texture.layer_texels - texture.offset[at.level];
  const uint32_t across = tiles_along(width, shape.shift_x);
  at.x = in_level % across << shape.shift_x;
  at.y = in_level / across << shape.shift_y;
  at.width = std::min(1u << shape.shift_x, width - at.x);
  at.height = std::min(1u << shape.shift_y, height - at.y);
  return at;
}

}  // namespace shd::texture
