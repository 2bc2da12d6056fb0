// SPDX-License-Identifier: MIT
#include "texture/tile/resolve.h"

#include <algorithm>
#include <cstring>

#include "texture/store/storage.h"
#include "texture/tile/cache.h"

namespace shd::texture {
namespace {

class Resolver {
 public:
  Resolver(TileLease* lease, const WaitingElements& waiting, size_t lanes, Stream* stream)
      : lease_(*lease), set_(*lease->texture->tiles), waiting_(waiting), lanes_(lanes), stream_(*stream) {}

  void run() {
    const size_t missing = find_missing();
    if (missing && !lease_.needed) {
      set_.cache->load(set_, lease_.missing, missing);
      for (size_t i = 0; i < missing; ++i) lease_.keep(lease_.missing[i]);
    } else if (missing) {
      set_.cache->request(set_, lease_.missing, missing);
    }
    for_each_texel([&](size_t k, size_t at, size_t element) { place(k, at, element); });
  }

 private:
  /// Calls body(k, at, element) for texel k of each lane of the elements.
  template <class Body>
  void for_each_texel(Body&& body) {
    for (size_t i = 0; i < waiting_.count; ++i) {
      const size_t e = waiting_.element[i];
      const size_t count = stream_.op[e] & (kQuad | kRow) ? 4 : 1;
      for (size_t k = 0; k < count; ++k) {
        for (size_t lane = 0; lane < lanes_; ++lane) body(k, e * lanes_ + lane, e);
      }
    }
  }

  bool is_kept(uint32_t tile) const { return lease_.tile[TileLease::entry_of(tile)] == tile; }

  /// Keeps the tiles that are resident. Returns the number of the others, which are then in TileLease::missing.
  size_t find_missing() {
    size_t count = 0;
    uint32_t latest = TileLease::kNoTile;
    for_each_texel([&](size_t k, size_t at, size_t) {
      const int32_t wanted = lease_.wanted[k][at];
      const auto tile = static_cast<uint32_t>(wanted);
      if (wanted < 0 || tile == latest) return;
      latest = tile;
      if (is_kept(tile)) {
        lease_.turn[TileLease::entry_of(tile)] = lease_.now;
      } else if (!lease_.keep(tile) && !is_resident(tile)) {
        lease_.missing[count++] = tile;
      }
    });
    std::sort(lease_.missing, lease_.missing + count);
    return static_cast<size_t>(std::unique(lease_.missing, lease_.missing + count) - lease_.missing);
  }

  bool is_resident(uint32_t tile) {
    const uint32_t slot = set_.cache->read(set_.key_of(tile));
    if (slot == TileTable::kNone) return false;
    set_.cache->stop_reading(slot);
    return true;
  }

  void place(size_t k, size_t at, size_t element) {
    const int32_t wanted = lease_.wanted[k][at];
    int32_t& index = stream_.index[k][at];
    if (wanted < 0) {
      index = ~0;
      return;
    }
    const auto tile = static_cast<uint32_t>(wanted);
    if (is_kept(tile)) {
      index += lease_.first[TileLease::entry_of(tile)];
      return;
    }
    const uint32_t slot = lease_.needed ? set_.cache->read(set_.key_of(tile)) : set_.cache->read_or_load(set_, tile);
    const size_t size = texel_size(*lease_.texture), copy = (4 * element + k) * lanes_ + at % lanes_;
    uint8_t* const to = lease_.spare_bytes + copy * size;
    if (slot == TileTable::kNone) {
      std::memset(to, 0, size);
      mark(tile, element, at);
    } else {
      std::memcpy(to, set_.cache->tile_memory(slot) + static_cast<uint32_t>(index) * size, size);
      set_.cache->stop_reading(slot);
    }
    index = lease_.spare + static_cast<int32_t>(copy);
  }

  /// Marks the lookup of a lane: it cannot use the level of the tile.
  void mark(uint32_t tile, size_t element, size_t at) {
    size_t lookup = lease_.lookup + at % lanes_;
    for (size_t e = 0; e < element; ++e) lookup += stream_.op[e] & kLast ? lanes_ : 0;
    if (lookup >= lease_.lookup_end) return;  // lanes behind the last lookup
    const auto level = static_cast<uint8_t>(level_of_tile(*lease_.texture, tile) + 1);
    lease_.needed[lookup] = std::max(lease_.needed[lookup], level);
  }

  TileLease& lease_;
  const TileSet& set_;
  const WaitingElements& waiting_;
  const size_t lanes_;
  Stream& stream_;
};

}  // namespace

void resolve(TileLease* lease, const WaitingElements& waiting, size_t lanes, Stream* stream) {
  Resolver(lease, waiting, lanes, stream).run();
}

}  // namespace shd::texture
