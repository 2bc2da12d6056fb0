// SPDX-License-Identifier: MIT
#include "texture/store/reader.h"

#include <cstring>

#include "texture/store/storage.h"
#include "texture/store/tiles/cache.h"

namespace shd::texture {

const uint8_t* TexelReader::at(uint32_t first, uint32_t width, uint32_t x, uint32_t y) {
  const UnitShape unit = texture_.layout.unit;
  const uint32_t number = first + (y >> unit.shift_y) * units_along(width, unit.shift_x) + (x >> unit.shift_x);
  if (has_tiles(texture_)) return in_tile(number, x, y);
  if (has_blocks(texture_)) return decoded_texel(texture_, number, x % 4, y % 4, &decoded_);
  return texel_at(texture_, number);
}

const uint8_t* TexelReader::in_tile(uint32_t tile, uint32_t x, uint32_t y) {
  const UnitShape unit = texture_.layout.unit;
  const size_t size = texel_size(texture_);
  const uint32_t column = x & ((1u << unit.shift_x) - 1), row = y & ((1u << unit.shift_y) - 1);
  TileCache& cache = *texture_.tiles->cache;
  uint32_t slot = cache.read(texture_.tiles->key_of(tile));
  if (slot == TileTable::kNone) {
    TileHold held[kMaxTileBatch];
    uint32_t loaded = 0;
    cache.fetch(*texture_.tiles, &tile, 1, held, &loaded);
    slot = held[0].slot;
  }
  std::memcpy(decoded_.texels, cache.tile_memory(slot) + ((row << unit.shift_x) + column) * size, size);
  cache.stop_reading(slot);
  return decoded_.texels;
}

}  // namespace shd::texture
