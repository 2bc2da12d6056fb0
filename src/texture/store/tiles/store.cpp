// SPDX-License-Identifier: MIT
// Tiles as a store: single texels, levels, and calls of lookups.
#include <cstring>

#include "core/status.h"
#include "texture/store/storage.h"
#include "texture/store/stores.h"
#include "texture/store/tiles/cache.h"
#include "texture/store/tiles/lease.h"
#include "texture/store/tiles/load.h"

namespace shd::texture {
namespace {

/// Calls body(texels) with the texels of a tile in the cache, after it is loaded if it is missing.
template <class Body>
void with_tile(const Texture& texture, uint32_t tile, const Body& body) {
  TileCache& cache = *texture.tiles->cache;
  uint32_t slot = cache.read(texture.tiles->key_of(tile));
  if (slot == TileTable::kNone) {
    TileHold held[kMaxTileBatch];
    uint32_t loaded = 0;
    cache.fetch(*texture.tiles, &tile, 1, held, &loaded);
    slot = held[0].slot;
  }
  body(static_cast<const uint8_t*>(cache.tile_memory(slot)));
  cache.stop_reading(slot);
}

const uint8_t* texel_in_tile(const Texture& texture, uint32_t tile, uint32_t x, uint32_t y, TexelMemory* memory) {
  const size_t size = texel_size(texture);
  with_tile(texture, tile, [&](const uint8_t* texels) {
    std::memcpy(memory->texels, texels + ((y << texture.layout.unit.shift_x) + x) * size, size);
  });
  return memory->texels;
}

void read_texels(const core::Context&, const Texture& texture, uint32_t image, uint32_t level, const shd_image& out) {
  const size_t size = texel_size(texture), pitch = size << texture.layout.unit.shift_x;
  const uint32_t first = first_unit(texture, image, level), end = first + slice_units(texture, level);
  for (uint32_t tile = first; tile < end; ++tile) {
    const shd_tile at = tile_at(texture, tile);
    with_tile(texture, tile, [&](const uint8_t* texels) {
      for (uint32_t y = 0; y < at.area.height; ++y) {
        std::memcpy(static_cast<uint8_t*>(out.pixels) + (at.area.y + y) * out.row_stride + at.area.x * size,
                    texels + y * pitch, at.area.width * size);
      }
    });
  }
}

/// The callback gives the blocks again, because the cache keeps them decoded.
void read_tiles_of_blocks(const core::Context&, const Texture& texture, uint32_t image, uint32_t level,
                          const shd_image& out) {
  const TileSet& set = *texture.tiles;
  const uint32_t first = first_unit(texture, image, level), end = first + slice_units(texture, level);
  core::Array<uint8_t> blocks(*set.allocator, (row_of_blocks(set) << texture.layout.unit.shift_y) / 4);
  for (uint32_t tile = first; tile < end; ++tile) {
    TileLoad load(nullptr, set);
    load.count = 1;
    load.tile[0] = tile;
    shd_tile at = tile_at(texture, tile);
    at.texels = blocks.data();
    at.row_stride = row_of_blocks(set);
    if (const shd_result result = call_source(&load, &at)) throw core::Failure(result, core::last_error());
    for (uint32_t y = 0; y < units_along(at.area.height, 2); ++y) {
      std::memcpy(
          static_cast<uint8_t*>(out.pixels) + (at.area.y / 4 + y) * out.row_stride + at.area.x / 4 * set.block_size,
          blocks.data() + y * at.row_stride, units_along(at.area.width, 2) * set.block_size);
    }
  }
}

void call_tiles(const Texture& texture, const CallBody& body) {
  TileCall call(texture);
  body.run(body.body, {nullptr, &call, call.origin, &call.places});
}

void begin_batch(void* state, size_t count, uint8_t* needed) {
  auto& call = *static_cast<TileCall*>(state);
  call.lookup = 0;
  call.lookup_end = count;
  call.needed = needed;
}

void pause_call(void* state) {
  static_cast<TileCall*>(state)->give_lease();
}
void resume_call(void* state) {
  static_cast<TileCall*>(state)->take_lease();
}

constexpr const char* kNoUpdate = "which shd_texture_drop_tiles() updates";

}  // namespace

const StoreRow kTileStore = {add_tiles,  texel_in_tile, read_texels, read_texels, kNoUpdate,
                             call_tiles, begin_batch,   pause_call,  resume_call};

const StoreRow kBcTileStore = {add_tiles,  texel_in_tile, read_tiles_of_blocks, read_texels, kNoUpdate,
                               call_tiles, begin_batch,   pause_call,           resume_call};

}  // namespace shd::texture
