// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "texture/store/tiles/sync.h"
#include "texture/store/tiles/tile.h"
#include "texture/stream.h"

namespace shd::texture {

/// Tiles that one call keeps, and memory for copies of texels. A lease stays with its texture between calls, so that
/// the next call finds the tiles of the previous one.
struct TileLease {
  static constexpr uint32_t kKept = 1024, kNoTile = 0xffffffff;
  static constexpr size_t kSpares = 4 * Stream::kCapacity;  // copies of texels, of up to 16 bytes; 4 L of an element
                                                            // of L lanes
  static constexpr size_t kSpareBytes = kSpares * 16;

  // Tiles that no other call can evict. Tile t can only be at entry_of(t).
  alignas(64) uint32_t tile[kKept];  // or kNoTile
  int32_t first[kKept];              // index of its first texel
  uint32_t turn[kKept];              // latest stream that reads it
  uint32_t now;                      // number of the stream that is placed

  TileCache* cache;
  const Texture* texture;
  uint32_t tile_texels;  // texels of a slot
  int32_t spare;         // index of the first copy of a texel
  uint8_t* spare_bytes;
  uint32_t number;        // number of the texture; 0 = none yet
  uint32_t version;       // number of drops when the call began
  uint32_t kept;          // tiles that are kept
  uint32_t spare_offset;  // place of spare_bytes in the memory of the cache
  TileAtomic<bool> used;
  TileAtomic<uint32_t> last_number;  // `number`, for calls that look for their lease

  static uint32_t entry_of(uint32_t of_tile) { return of_tile * 0x9e3779b1u >> 22; }

  /// Begins the next stream: earlier ones read nothing any more.
  void begin_stream();

  /// Keeps a tile that is resident. Returns false if it is not, if the stream reads another tile of its entry, or if
  /// the cache lets no more tiles be kept.
  bool keep(uint32_t of_tile);

  /// Lets all tiles go.
  void clear();
};

/// A call that looks texels of a texture in tiles up. It has a lease, except while it loads tiles.
struct TileCall {
  static constexpr size_t kColumn = Stream::kColumn;

  explicit TileCall(const Texture& of);
  ~TileCall();
  TileCall(const TileCall&) = delete;
  TileCall& operator=(const TileCall&) = delete;

  void take_lease();
  void give_lease();

  const Texture& texture;
  TileCache& cache;
  TileLease* lease = nullptr;
  const uint8_t* origin;              // address of texel 0 of the cache, for texels of this size
  size_t lookup = 0, lookup_end = 0;  // first lookup of the stream that is not finished; end of the lookups
  uint8_t* needed = nullptr;          // [lookups] finest levels that lookups can use, if they must not wait; else null

  // Tiles of texels that wait for resolve(); Stream::index then has the texels within the tiles.
  alignas(64) int32_t wanted[4][kColumn];
  StreamPlaces places;
};

}  // namespace shd::texture
