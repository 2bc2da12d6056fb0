// SPDX-License-Identifier: MIT
#include <cstring>

#include "texture/store/storage.h"
#include "texture/store/tiles/lease.h"
#include "texture/store/tiles/resolve.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/store/tiles/place.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/lanes-inl.h"
#include "texture/store/place-inl.h"
#include "texture/store/tiles/kept-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

class TilePlacer : KeptTiles {
 public:
  TilePlacer(TileCall* call, Stream* stream)
      : KeptTiles(call), stream_(*stream), places_(*stream->places), texel_size_(texel_size(call->texture)) {}

  void place(size_t end) {
    const size_t lanes = hn::Lanes(DI());
    WaitingElements apart, waiting;
    size_t lookup = call_.lookup;
    lease_.begin_stream();
    for (size_t e = 0; e < end; ++e) {
      const uint32_t op = stream_.op[e];
      const size_t at = e * lanes, left = call_.lookup_end - lookup;
      if (op & kLast) lookup += lanes;
      if (op & kMerge) continue;
      if (HWY_UNLIKELY(left < lanes)) repeat_first(at, left);
      if (op & kQuad) {
        if (HWY_UNLIKELY(!(op & kNeighbours && place_quads(at)))) {
          prefetch_apart(at);
          prefetch_apart(at + lanes - 1);
          apart.add(e);
        }
      } else if (op & kRow) {
        if (HWY_UNLIKELY(!place_row(e, at))) waiting.add(e);
      } else if (HWY_UNLIKELY(!place_alone(e, at))) {
        waiting.add(e);
      }
    }
    // Their texels have been prefetched.
    for (size_t i = 0; i < apart.count; ++i) {
      const size_t e = apart.element[i];
      if (HWY_UNLIKELY(!place_apart(e, e * lanes))) waiting.add(e);
    }
    if (HWY_UNLIKELY(waiting.count != 0)) wait(waiting, end, lanes);
    call_.lookup = lookup;
  }

 private:
  /// A row of texels of a level: the number of its first tile, its first texel within the tiles, and its number.
  struct TileRow {
    VI tile, texel, y;
  };

  HWY_NOINLINE void wait(const WaitingElements& waiting, size_t end, size_t lanes) {
    for (size_t i = 0; i < waiting.count; ++i) {
      uint16_t& op = stream_.op[waiting.element[i]];
      op = static_cast<uint16_t>(op & ~kNeighbours);
    }
    resolve(&call_, waiting, end, lanes, &stream_);
  }

  /// Lets lanes from `end` on, which have no lookup, read the texels of lane 0.
  HWY_NOINLINE void repeat_first(size_t at, size_t end) {
    int32_t* columns[13] = {places_.width};
    for (size_t k = 0; k < 4; ++k) {
      columns[1 + k] = stream_.index[k];
      columns[5 + k] = places_.y[k];
      columns[9 + k] = places_.first[k];
    }
    for (int32_t* column : columns) {
      for (size_t lane = end; lane < hn::Lanes(DI()); ++lane) column[at + lane] = column[at];
    }
  }

  /// Returns the row of texel k of element e.
  HWY_INLINE TileRow row_at(size_t e, size_t at, size_t k) const {
    const VI y = load(places_.y[stream_.row_of(e, k)] + at);
    const VI across = tile_column(load(places_.width + at) + hn::Set(DI(), last_x_));
    const VI down = hn::ShiftRightSame(y, static_cast<int>(shape_.shift_y));
    return {load(places_.first[stream_.image_of(e, k)] + at) + down * across, texel_row(y), y};
  }

  /// Returns the tile of a texel of the level of the first lane at `at`.
  HWY_INLINE uint32_t tile_at(size_t at, int32_t x, int32_t y) const {
    return tile_of(places_.first[0][at], places_.width[at], x, y);
  }

  /// Returns the memory for copies of texels of an element.
  HWY_INLINE uint8_t* spare_of(size_t e) const { return lease_.spare_bytes + 4 * e * hn::Lanes(DI()) * texel_size_; }

  /// Prefetches the texels of the first and the last lane: those between them are near.
  HWY_INLINE void prefetch_ends(const int32_t* index) const {
    __builtin_prefetch(call_.origin + static_cast<size_t>(index[0]) * texel_size_);
    __builtin_prefetch(call_.origin + static_cast<size_t>(index[hn::Lanes(DI()) - 1]) * texel_size_);
  }

  /// Writes the tile and the texel within it for resolve().
  HWY_INLINE void wait_for(size_t k, size_t at, const TileRow& row) {
    const DI di;
    const VI x = load(stream_.index[k] + at);
    const auto outside = hn::Lt(hn::Or(x, row.y), hn::Zero(di));
    hn::Store(hn::IfThenElse(outside, hn::Set(di, -1), row.tile + tile_column(x)), di, call_.wanted[k] + at);
    hn::Store(row.texel + texel_column(x), di, stream_.index[k] + at);
  }

  /// Places quads of columns side by side in one tile: one of the two latest, or the tile of lane 0.
  HWY_INLINE bool place_quads(size_t at) {
    latest_ ^= 1;  // elements often alternate between two levels
    if (HWY_LIKELY(place_quads_in(at, recent_[latest_]))) return true;
    const int32_t x = stream_.index[0][at], y = places_.y[0][at];
    const int32_t first = first_texel_of(tile_at(at, x, y));
    if (HWY_UNLIKELY(first < 0)) return false;
    recent_[latest_] = {x, y, places_.first[0][at], first};
    return place_quads_in(at, recent_[latest_]);
  }

  /// Places single texels: in one of the two latest tiles, or anywhere. Returns false if tiles are not at hand or
  /// texels are the border; they then wait.
  HWY_INLINE bool place_alone(size_t e, size_t at) {
    latest_ ^= 1;
    if (HWY_LIKELY(place_alone_in(at, recent_[latest_]))) return true;
    const int32_t x = stream_.index[0][at], y = places_.y[0][at];
    if (HWY_UNLIKELY(!place_texels<1>(e, at))) return false;
    const int32_t in_tile = ((y & last_y_) << shape_.shift_x) + (x & last_x_);
    recent_[latest_] = {x, y, places_.first[0][at], stream_.index[0][at] - in_tile};
    return true;
  }

  /// A tile that the stream reads: one of its texels, the image, and the index of its first texel.
  struct Recent {
    int32_t x = 0, y = 0, image = -1, first = 0;
  };

  /// Places single texels in a tile. Returns false and changes nothing if some of them are elsewhere, or the border.
  HWY_INLINE bool place_alone_in(size_t at, const Recent& tile) {
    const DI di;
    const VI x = load(stream_.index[0] + at), y = load(places_.y[0] + at);
    const VI across = hn::ShiftRightSame(x ^ hn::Set(di, tile.x), static_cast<int>(shape_.shift_x));
    const VI down = hn::ShiftRightSame(y ^ hn::Set(di, tile.y), static_cast<int>(shape_.shift_y));
    const VI image = load(places_.first[0] + at) ^ hn::Set(di, tile.image);
    if (HWY_UNLIKELY(!all_equal(hn::Or(hn::Or(across, down), image), hn::Zero(di)))) return false;
    hn::Store(hn::Set(di, tile.first) + texel_column(x) + texel_row(y), di, stream_.index[0] + at);
    return true;
  }

  /// Places quads of columns side by side in a tile. Returns false and changes nothing if some of them are elsewhere.
  HWY_INLINE bool place_quads_in(size_t at, const Recent& tile) {
    const DI di;
    const VI x0 = load(stream_.index[0] + at), y0 = load(places_.y[0] + at), y1 = load(places_.y[1] + at);
    const VI x = hn::Set(di, tile.x), y = hn::Set(di, tile.y), x1 = x0 + hn::Set(di, 1);
    const VI across = hn::ShiftRightSame(hn::Or(x0 ^ x, x1 ^ x), static_cast<int>(shape_.shift_x));
    const VI down = hn::ShiftRightSame(hn::Or(y0 ^ y, y1 ^ y), static_cast<int>(shape_.shift_y));
    const VI image = load(places_.first[0] + at) ^ hn::Set(di, tile.image);
    if (HWY_UNLIKELY(!all_equal(hn::Or(hn::Or(across, down), image), hn::Zero(di)))) return false;
    const VI texel = hn::Set(di, tile.first) + texel_column(x0);
    hn::Store(texel + texel_row(y0), di, stream_.index[0] + at);
    hn::Store(texel + texel_row(y1), di, stream_.index[2] + at);
    prefetch_ends(stream_.index[0] + at);
    prefetch_ends(stream_.index[2] + at);
    return true;
  }

  /// Prefetches the texels of a lane if its tiles are kept.
  HWY_INLINE void prefetch_apart(size_t at) const {
    const int32_t x = stream_.index[0][at];
    if (x < 0) return;
    for (size_t k = 0; k < 2; ++k) {
      const int32_t y = places_.y[k][at];
      const uint32_t tile = tile_at(at, x, y), entry = TileLease::entry_of(tile);
      if (y < 0 || lease_.tile[entry] != tile) continue;
      const int32_t texel = lease_.first[entry] + ((y & last_y_) << shape_.shift_x) + (x & last_x_);
      __builtin_prefetch(call_.origin + static_cast<size_t>(texel) * texel_size_);
    }
  }

  /// Places a quad in several tiles.
  HWY_NOINLINE bool place_apart(size_t e, size_t at) {
    if (stream_.op[e] & kNeighbours) {
      if (stitch(e, at) || place_pairs(e, at)) return true;
      const VI left = load(stream_.index[0] + at), right = left + hn::Set(DI(), 1);
      for (size_t k = 1; k < 4; ++k) hn::Store(k % 2 ? right : left, DI(), stream_.index[k] + at);
    }
    return place_texels<4>(e, at);
  }

  /// Places quads on two rows of texels that cross tiles: both rows are copied without a gap, so that consumers load
  /// them as they load rows of a level. Returns false and changes nothing if the quads are elsewhere.
  HWY_INLINE bool stitch(size_t e, size_t at) {
    const DI di;
    const int32_t lanes = static_cast<int32_t>(hn::Lanes(di)), *const x = stream_.index[0] + at;
    const int32_t first = x[0] < x[lanes - 1] ? x[0] : x[lanes - 1], end = x[0] + x[lanes - 1] - first + 2;
    if (end - first > 2 * lanes) return false;
    const VI column = load(x) - hn::Set(di, first);
    const VI range = hn::Min(hn::Max(column, hn::Zero(di)), hn::Set(di, end - first - 2));
    VI other = hn::Zero(di);
    for (const int32_t* line : {places_.first[0] + at, places_.y[0] + at, places_.y[1] + at}) {
      other = hn::Or(other, load(line) ^ hn::Set(di, line[0]));
    }
    if (!all_equal(hn::Or(range ^ column, other), hn::Zero(di))) return false;
    for (size_t k = 0; k < 2; ++k) {
      if (!copy_row(at, first, end, places_.y[k][at], spare_of(e) + k * 2 * hn::Lanes(di) * texel_size_)) return false;
    }
    const VI copy = column + hn::Set(di, lease_.spare + static_cast<int32_t>(4 * at));
    hn::Store(copy, di, stream_.index[0] + at);
    hn::Store(copy + hn::Set(di, 2 * lanes), di, stream_.index[2] + at);
    return true;
  }

  /// Copies columns first..end - 1 of a row of the level of lane 0. Returns false if a tile is not at hand.
  HWY_INLINE bool copy_row(size_t at, int32_t first, int32_t end, int32_t y, uint8_t* to) {
    const int32_t row = (y & last_y_) << shape_.shift_x;
    for (int32_t x = first; x < end;) {
      const int32_t texel = first_texel_of(tile_at(at, x, y));
      if (texel < 0) return false;
      const int32_t tile_end = (x | last_x_) + 1, run = (end < tile_end ? end : tile_end) - x;
      const size_t bytes = static_cast<size_t>(run) * texel_size_;
      std::memcpy(to, call_.origin + static_cast<size_t>(texel + row + (x & last_x_)) * texel_size_, bytes);
      to += bytes;
      x += run;
    }
    return true;
  }

  /// Places quads of columns side by side. Pairs that cross tiles are copied. Returns false if tiles are not at hand.
  HWY_INLINE bool place_pairs(size_t e, size_t at) {
    const DI di;
    const TileRow top = row_at(e, at, 0), bottom = row_at(e, at, 2);
    const VI x0 = load(stream_.index[0] + at), x1 = x0 + hn::Set(di, 1), column = tile_column(x0);
    Kept left[2], right[2];
    if (!find_kept(top.tile + column, top.texel + texel_column(x0), &left[0])) return false;
    if (!find_kept(bottom.tile + column, bottom.texel + texel_column(x0), &left[1])) return false;
    const auto crosses = hn::Ne(column, tile_column(x1));
    const bool some_cross = !hn::AllFalse(di, crosses);
    if (some_cross) {
      if (!find_kept(top.tile + tile_column(x1), top.texel + texel_column(x1), &right[0])) return false;
      if (!find_kept(bottom.tile + tile_column(x1), bottom.texel + texel_column(x1), &right[1])) return false;
    }
    for (size_t k = 0; k < 2; ++k) {
      hn::Store(left[k].index, di, stream_.index[2 * k] + at);
      mark_read(left[k]);
      if (!some_cross) continue;
      mark_read(right[k]);
      copy_pairs(e, at, k, hn::IfThenElse(crosses, right[k].index, hn::Set(di, -1)));
    }
    return true;
  }

  /// Copies the pairs of row k whose right texel is at `right`, if it is not negative.
  HWY_INLINE void copy_pairs(size_t e, size_t at, size_t k, VI right) {
    alignas(64) int32_t texel[kMaxLanes];
    hn::Store(right, DI(), texel);
    const size_t lanes = hn::Lanes(DI());
    for (size_t lane = 0; lane < lanes; ++lane) {
      if (texel[lane] < 0) continue;
      int32_t& index = stream_.index[2 * k][at + lane];
      const size_t pair = 2 * (k * lanes + lane);
      uint8_t* const to = spare_of(e) + pair * texel_size_;
      std::memcpy(to, call_.origin + static_cast<size_t>(index) * texel_size_, texel_size_);
      std::memcpy(to + texel_size_, call_.origin + static_cast<size_t>(texel[lane]) * texel_size_, texel_size_);
      index = lease_.spare + static_cast<int32_t>(4 * at + pair);
    }
  }

  /// Places texels one by one. Returns false if tiles are not at hand or texels are the border; they then wait.
  template <size_t kCount>
  HWY_INLINE bool place_texels(size_t e, size_t at) {
    const DI di;
    Kept kept[kCount];
    bool found = true;
    for (size_t k = 0; k < kCount && found; ++k) {
      const TileRow row = row_at(e, at, k);
      const VI x = load(stream_.index[k] + at);
      found = hn::AllFalse(di, hn::Lt(hn::Or(x, row.y), hn::Zero(di))) &&
              find_kept(row.tile + tile_column(x), row.texel + texel_column(x), &kept[k]);
    }
    for (size_t k = 0; k < kCount; ++k) {
      if (HWY_UNLIKELY(!found)) {
        wait_for(k, at, row_at(e, at, k));
        continue;
      }
      hn::Store(kept[k].index, di, stream_.index[k] + at);
      mark_read(kept[k]);
    }
    if (found) stream_.op[e] = static_cast<uint16_t>(stream_.op[e] & ~kNeighbours);
    return found;
  }

  HWY_INLINE bool place_row(size_t e, size_t at) {
    const DI di;
    const TileRow row = row_at(e, at, 0);
    const VI left = load(stream_.index[2] + at), right = load(stream_.index[3] + at);
    const VI first = row.tile + tile_column(left);
    if (stream_.op[e] & kNeighbours && all_equal(first, row.tile + tile_column(right))) {
      Kept kept;
      if (find_kept(first, row.texel + texel_column(left), &kept)) {
        mark_read(kept);
        hn::Store(kept.index, di, stream_.index[2] + at);
        return true;
      }
    }
    return place_texels<4>(e, at);
  }

  Stream& stream_;
  StreamPlaces& places_;
  Recent recent_[2];
  size_t latest_ = 0;
  const size_t texel_size_;
};

}  // namespace

void PlaceInTiles(void* call, size_t end, size_t, Stream* stream) {
  TilePlacer(static_cast<TileCall*>(call), stream).place(end);
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
