// SPDX-License-Identifier: MIT
#include "texture/store/tiles/resolve.h"

#include <algorithm>
#include <cstring>

#include "texture/store/storage.h"
#include "texture/store/tiles/cache.h"

namespace shd::texture {
namespace {

/// Copies of the texels of a stream while its call has no lease, and the tiles that are missing.
struct Copies {
  alignas(64) uint8_t texels[TileLease::kSpareBytes];
  uint32_t missing[TileLease::kSpares];
};

class Resolver {
 public:
  Resolver(TileCall* call, const WaitingElements& waiting, size_t end, size_t lanes, Stream* stream)
      : call_(*call),
        set_(*call->texture.tiles),
        size_(texel_size(call->texture)),
        waiting_(waiting),
        end_(end),
        lanes_(lanes),
        stream_(*stream) {}

  void run() {
    bool all = true;
    for_each_texel([&](size_t k, size_t at, size_t element) {
      if (!place(k, at, element)) all = false;
    });
    if (all) return;
    if (call_.needed) {
      skip_missing();
    } else {
      load_missing();
    }
  }

 private:
  static constexpr int32_t kOutside = -1, kPlaced = -2;  // in TileCall::wanted, instead of a tile

  /// Calls body(k, at, element) for texel k of each lane of the waiting elements.
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

  size_t copy_of(size_t k, size_t at, size_t element) const { return (4 * element + k) * lanes_ + at % lanes_; }
  const uint8_t* texel(int32_t index) const { return call_.origin + static_cast<size_t>(index) * size_; }

  /// Places a texel whose tile is resident, which the lease keeps if it can. Returns false if it is not.
  bool place(size_t k, size_t at, size_t element) {
    TileLease& lease = *call_.lease;
    int32_t& wanted = call_.wanted[k][at];
    int32_t& index = stream_.index[k][at];
    if (wanted == kOutside) {
      index = ~0;
      return true;
    }
    const auto tile = static_cast<uint32_t>(wanted);
    const uint32_t entry = TileLease::entry_of(tile);
    if (lease.tile[entry] == tile || lease.keep(tile)) {
      lease.turn[entry] = lease.now;
      index += lease.first[entry];
      wanted = kPlaced;
      return true;
    }
    const uint32_t slot = call_.cache.read(set_.key_of(tile));
    if (slot == TileTable::kNone) return false;
    const size_t copy = copy_of(k, at, element);
    copy_texel(slot, index, lease.spare_bytes + copy * size_);
    call_.cache.stop_reading(slot);
    index = lease.spare + static_cast<int32_t>(copy);
    wanted = kPlaced;
    return true;
  }

  void copy_texel(uint32_t slot, int32_t index, uint8_t* to) const {
    std::memcpy(to, call_.cache.tile_memory(slot) + static_cast<uint32_t>(index) * size_, size_);
  }

  /// Gives zeros for missing texels, marks the lookups that need them, and requests their tiles.
  void skip_missing() {
    uint32_t missing[TileLease::kSpares];
    const size_t count = list_missing(missing);
    call_.cache.request(set_, missing, count);
    for_each_texel([&](size_t k, size_t at, size_t element) {
      if (call_.wanted[k][at] < 0) return;
      const size_t copy = copy_of(k, at, element);
      std::memset(call_.lease->spare_bytes + copy * size_, 0, size_);
      mark(static_cast<uint32_t>(call_.wanted[k][at]), element, at);
      stream_.index[k][at] = call_.lease->spare + static_cast<int32_t>(copy);
    });
  }

  /// Marks the lookup of a lane: it cannot use the level of the tile.
  void mark(uint32_t tile, size_t element, size_t at) {
    size_t lookup = call_.lookup + at % lanes_;
    for (size_t e = 0; e < element; ++e) lookup += stream_.op[e] & kLast ? lanes_ : 0;
    if (lookup >= call_.lookup_end) return;  // lanes behind the last lookup
    const auto level = static_cast<uint8_t>(place_of_unit(call_.texture, tile).level + 1);
    call_.needed[lookup] = std::max(call_.needed[lookup], level);
  }

  size_t list_missing(uint32_t* missing) {
    size_t count = 0;
    for_each_texel([&](size_t k, size_t at, size_t) {
      const int32_t wanted = call_.wanted[k][at];
      if (wanted >= 0) missing[count++] = static_cast<uint32_t>(wanted);
    });
    std::sort(missing, missing + count);
    return static_cast<size_t>(std::unique(missing, missing + count) - missing);
  }

  /// Loads the missing tiles without a lease. Meanwhile all texels of the stream are copies.
  [[gnu::noinline]] void load_missing() {
    Copies copies;
    size_t count = list_missing(copies.missing);
    copy_placed(&copies);
    call_.give_lease();
    TileHold held[kMaxTileBatch];
    for (uint32_t loaded = 0; count > 0;) {
      const uint32_t got = call_.cache.fetch(set_, copies.missing, count, held, &loaded);
      for (uint32_t i = 0; i < got; ++i) {
        copy_wanted(held[i], &copies);
        call_.cache.stop_reading(held[i].slot);
        count = static_cast<size_t>(std::remove(copies.missing, copies.missing + count, held[i].tile) - copies.missing);
      }
    }
    call_.take_lease();
    std::memcpy(call_.lease->spare_bytes, copies.texels, 4 * end_ * lanes_ * size_);
    use_copies();
  }

  /// Copies the texels that have a place.
  void copy_placed(Copies* copies) {
    for (size_t e = 0; e < end_; ++e) {
      const uint32_t op = stream_.op[e];
      if (op & kMerge) continue;
      if (op & kNeighbours) split(e);
      for (size_t k = 0; k < (op & (kQuad | kRow) ? 4 : 1); ++k) {
        for (size_t at = e * lanes_; at < (e + 1) * lanes_; ++at) {
          if (is_missing(e, k, at) || stream_.index[k][at] < 0) continue;
          std::memcpy(copies->texels + copy_of(k, at, e) * size_, texel(stream_.index[k][at]), size_);
        }
      }
    }
  }

  bool is_waiting(size_t element) const {
    const uint16_t* const end = waiting_.element + waiting_.count;
    return std::find(waiting_.element, end, element) != end;
  }
  bool is_missing(size_t element, size_t k, size_t at) const { return call_.wanted[k][at] >= 0 && is_waiting(element); }

  /// Writes the columns that adjacent texels leave out.
  void split(size_t e) {
    auto& index = stream_.index;
    for (size_t at = e * lanes_; at < (e + 1) * lanes_; ++at) {
      if (stream_.op[e] & kQuad) {
        index[1][at] = index[0][at] + 1;
        index[3][at] = index[2][at] + 1;
      } else {
        index[0][at] = index[2][at] + 1;
        index[1][at] = index[2][at] + 2;
        index[3][at] = index[2][at] + 3;
      }
    }
    stream_.op[e] = static_cast<uint16_t>(stream_.op[e] & ~kNeighbours);
  }

  /// Copies the texels of a tile that has come.
  void copy_wanted(const TileHold& held, Copies* copies) {
    for_each_texel([&](size_t k, size_t at, size_t element) {
      if (call_.wanted[k][at] != static_cast<int32_t>(held.tile)) return;
      copy_texel(held.slot, stream_.index[k][at], copies->texels + copy_of(k, at, element) * size_);
      stream_.index[k][at] = 0;
    });
  }

  void use_copies() {
    for (size_t e = 0; e < end_; ++e) {
      const uint32_t op = stream_.op[e];
      if (op & kMerge) continue;
      for (size_t k = 0; k < (op & (kQuad | kRow) ? 4 : 1); ++k) {
        for (size_t at = e * lanes_; at < (e + 1) * lanes_; ++at) {
          int32_t& index = stream_.index[k][at];
          if (index >= 0) index = call_.lease->spare + static_cast<int32_t>(copy_of(k, at, e));
        }
      }
    }
  }

  TileCall& call_;
  const TileSet& set_;
  const size_t size_;
  const WaitingElements& waiting_;
  const size_t end_, lanes_;
  Stream& stream_;
};

}  // namespace

void resolve(TileCall* call, const WaitingElements& waiting, size_t end, size_t lanes, Stream* stream) {
  Resolver(call, waiting, end, lanes, stream).run();
}

}  // namespace shd::texture
