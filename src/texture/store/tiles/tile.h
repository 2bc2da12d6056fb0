// SPDX-License-Identifier: MIT
/// @file
/// Contract of store/tiles/: textures whose texels come from a callback of the host, tile by tile, through a cache of a
/// fixed size (shd/tile_cache.h).
///
/// Levels consist of tiles, which are numbered: layer by layer, level by level, slice by slice, row by row. A tile is
/// the unit of the Layout. Filters emit the level, column and row of each texel, as for any store. Before a stream is
/// consumed, place.cpp finds the places of its texels in the memory of the cache, and the consumer of the format runs
/// unchanged. Texels whose tiles are not at hand go to resolve.cpp, which loads the missing tiles of the whole stream
/// in one call. Tiles of compressed blocks are decoded when they are loaded.
///
/// Invariants: the memory of a cache is allocated once and never exceeds its budget. The table has one slot of a tile.
/// A slot is reused only if nothing reads it. Pins belong to the tile.
///
/// Waiting: callbacks run while their call holds no lock, no lease and reads no slot; it holds the slots that they
/// fill. A call inside a callback (core/call.h) never waits for a tile: it loads the tile a second time. It waits for a
/// slot only while some callback has no such wait inside it, so waits have no cycle. Calls outside of callbacks hold
/// nothing when they wait. Leases are held while lookups filter, and no longer. test_tile_orders.cpp runs this code in
/// every order of its threads.
///
/// | file                  | contents                                                            |
/// |-----------------------|---------------------------------------------------------------------|
/// | tile.h, tile.cpp      | shapes and numbers of tiles; the tiles of a texture                 |
/// | sync.h                | locks and atomics                                                   |
/// | table.h, .cpp         | slots by key, found without a lock                                  |
/// | slot.h, slots.cpp     | states of a slot: eviction, begin and end of loads, pins, drops     |
/// | cache.h, .cpp         | the cache: its parts, readers, counters                             |
/// | load.h, .cpp          | loads of batches of tiles by the callback of the host, and waits    |
/// | fork.cpp              | a cache in the child of a fork                                      |
/// | budget.h, .cpp        | sizes of the parts of a cache                                       |
/// | lease.h, .cpp         | tiles that a call keeps, and the texels that it places              |
/// | requests.h, .cpp      | tiles that lookups did not find                                     |
/// | regions.h, .cpp       | rectangles of tiles: load, pin, drop                                |
/// | store.cpp             | tiles as a store: single texels, levels, calls of lookups           |
/// | place.cpp             | texels of a stream to places in memory                              |
/// | place_rows.cpp        | rows of quads to places in memory, if all tiles are at hand         |
/// | kept-inl.h            | vectors of texels in the tiles of a lease                           |
/// | resolve.h, .cpp       | texels whose tiles are not at hand                                  |
#pragma once

#include <cstdint>

#include <shd/texture.h>

#include "texture/texture.h"

namespace shd::texture {

class TileCache;

/// Names a tile of any texture of a cache: the number of the texture, then the number of the tile. 0 is no tile.
using TileKey = uint64_t;

/// Returns the shape of tiles of a power of two of bytes: as wide as high, or twice as wide.
UnitShape tile_shape(uint32_t tile_bytes, size_t texel_size);

/// The tiles of a texture.
struct TileSet {
  TileCache* cache;
  core::Object* cache_handle;  // retained
  shd_tile_source source;
  const core::Allocator* allocator;  // allocator of the texture's context
  const Texture* texture;
  DecodeBc decode;                 // decoder of tiles of compressed blocks; null for texels
  uint32_t block_size;             // bytes of a block
  uint32_t number;                 // number of the texture in the cache; never 0
  core::Object* handle = nullptr;  // handle of the texture, when it is made
  TileSet* next = nullptr;         // in the cache's list

  TileKey key_of(uint32_t tile) const { return uint64_t{number} << 32 | tile; }
};

/// Returns the bytes of a row of blocks of a whole tile.
inline size_t row_of_blocks(const TileSet& set) {
  return (size_t{set.block_size} << set.texture->layout.unit.shift_x) / 4;
}

/// Returns the number of tiles of all levels and layers of a desc whose sizes and format are checked.
uint64_t tile_count(const shd_texture_desc& desc, uint32_t tile_bytes);

/// Gives tiles to a texture (StoreRow::fill). The caller then sets TileSet::handle, and TileSet::source.release, which
/// is called with the texture.
void add_tiles(const core::Context& context, const shd_texture_desc& desc, Texture* out);

/// A tile as the callback gets it, without memory.
shd_tile tile_at(const Texture& texture, uint32_t tile);

/// Returns whether two tiles are of the same level of the same layer.
bool is_same_level(const Texture& texture, uint32_t a, uint32_t b);

}  // namespace shd::texture
