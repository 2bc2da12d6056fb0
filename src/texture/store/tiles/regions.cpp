// SPDX-License-Identifier: MIT
#include "texture/store/tiles/regions.h"

#include "texture/store/storage.h"
#include "texture/store/tiles/cache.h"

namespace shd::texture {
namespace {

/// Rows and columns of tiles that cover a region.
struct TileRange {
  uint32_t first;  // number of tile (0, 0) of the level
  uint32_t across;
  AxisRange x, y;

  uint64_t size() const { return uint64_t{x.size()} * y.size(); }
  uint32_t tile(uint64_t i) const {
    const auto row = static_cast<uint32_t>(i / x.size()), column = static_cast<uint32_t>(i % x.size());
    return first + (y.first + row) * across + x.first + column;
  }
};

TileRange range_of(const Texture& texture, const shd_tile_region& region) {
  const UnitShape unit = texture.layout.unit;
  const auto range = [](uint32_t first, uint32_t size, uint32_t shift) {
    return AxisRange{first >> shift, ((first + size - 1) >> shift) + 1};
  };
  return {first_unit(texture, region.layer, region.level),
          units_along(level_size(texture.width, region.level), unit.shift_x),
          range(region.area.x, region.area.width, unit.shift_x),
          range(region.area.y, region.area.height, unit.shift_y)};
}

/// Returns whether the slice of a tile averages the slice of a region.
bool is_above(const Texture& texture, const shd_tile_region& region, const shd_tile& tile) {
  const AxisRange z = level_range({region.layer, region.layer + 1}, level_size(texture.depth, region.level),
                                  level_size(texture.depth, tile.level));
  return z.first <= tile.layer && tile.layer < z.end;
}

bool overlap(const AxisRange& range, uint32_t first, uint32_t size) {
  return first < range.end && range.first < first + size;
}

}  // namespace

void load_region(const Texture& texture, const shd_tile_region& region) {
  const TileRange range = range_of(texture, region);
  uint32_t tiles[kMaxTileBatch];
  for (uint64_t i = 0; i < range.size();) {
    size_t count = 0;
    while (count < kMaxTileBatch && i < range.size()) tiles[count++] = range.tile(i++);
    texture.tiles->cache->load(*texture.tiles, tiles, count);
  }
}

bool pin_region(const Texture& texture, const shd_tile_region& region) {
  const TileSet& set = *texture.tiles;
  const TileRange range = range_of(texture, region);
  uint64_t pinned = 0;
  const auto unpin = [&] {
    while (pinned > 0) set.cache->unpin(set, range.tile(--pinned));
  };
  try {
    for (; pinned < range.size(); ++pinned) {
      if (set.cache->pin(set, range.tile(pinned))) continue;
      unpin();
      return false;
    }
  } catch (...) {
    unpin();
    throw;
  }
  return true;
}

bool unpin_region(const Texture& texture, const shd_tile_region& region) {
  const TileSet& set = *texture.tiles;
  const TileRange range = range_of(texture, region);
  for (uint64_t i = 0; i < range.size(); ++i) {
    if (!set.cache->is_pinned(set, range.tile(i))) return false;
  }
  for (uint64_t i = 0; i < range.size(); ++i) set.cache->unpin(set, range.tile(i));
  return true;
}

void drop_region(const Texture& texture, const shd_tile_region& region) {
  const uint32_t width = level_size(texture.width, region.level), height = level_size(texture.height, region.level);
  texture.tiles->cache->drop(*texture.tiles, [&](uint32_t tile) {
    const shd_tile at = tile_at(texture, tile);
    if (at.level < region.level) return false;
    if (texture.depth == 0 ? at.layer != region.layer : !is_above(texture, region, at)) return false;
    const AxisRange x =
        level_range({region.area.x, region.area.x + region.area.width}, width, level_size(texture.width, at.level));
    const AxisRange y =
        level_range({region.area.y, region.area.y + region.area.height}, height, level_size(texture.height, at.level));
    return overlap(x, at.area.x, at.area.width) && overlap(y, at.area.y, at.area.height);
  });
}

}  // namespace shd::texture
