// SPDX-License-Identifier: MIT
#include "texture/tile/lease.h"
#include "texture/tile/resolve.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/tile/place.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/footprint/shapes-inl.h"
#include "texture/tile/place-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

class TilePlacer {
  using DI = hn::RebindToSigned<BatchTag>;
  using VI = hn::Vec<DI>;

 public:
  TilePlacer(TileLease* lease, Stream* stream)
      : lease_(*lease),
        stream_(*stream),
        shape_(lease->texture->tiles->shape),
        last_x_((1 << shape_.shift_x) - 1),
        last_y_((1 << shape_.shift_y) - 1) {}

  void place(size_t end) {
    const size_t lanes = hn::Lanes(DI());
    WaitingElements waiting;
    size_t lookup = lease_.lookup;
    lease_.begin_stream();
    for (size_t e = 0; e < end; ++e) {
      const uint32_t op = stream_.op[e];
      const size_t at = e * lanes, left = lease_.lookup_end - lookup;
      if (op & kLast) lookup += lanes;
      if (op & kMerge) continue;
      if (HWY_UNLIKELY(left < lanes)) repeat_first(at, left);
      const bool placed = op & kQuad ? place_quad(e, at) : op & kRow ? place_row(e, at) : place_texel(at);
      if (HWY_LIKELY(placed)) continue;
      stream_.op[e] = static_cast<uint16_t>(stream_.op[e] & ~kNeighbours);
      waiting.element[waiting.count++] = static_cast<uint16_t>(e);
    }
    if (HWY_UNLIKELY(waiting.count != 0)) resolve(&lease_, waiting, lanes, &stream_);
    lease_.lookup = lookup;
  }

 private:
  /// A row of texels of a level: the number of its first tile, and its first texel within the tiles.
  struct TileRow {
    VI tile, texel;
  };

  /// Lets lanes from `end` on, which have no lookup, read the texels of lane 0.
  HWY_NOINLINE void repeat_first(size_t at, size_t end) {
    int32_t* const columns[] = {stream_.index[0], stream_.index[1], stream_.index[2],  stream_.index[3],
                                lease_.y[0],      lease_.y[1],      lease_.first_tile, lease_.width};
    for (int32_t* column : columns) {
      for (size_t lane = end; lane < hn::Lanes(DI()); ++lane) column[at + lane] = column[at];
    }
  }

  HWY_INLINE VI load(const int32_t* values) const { return hn::Load(DI(), values); }
  HWY_INLINE VI tile_column(VI x) const { return hn::ShiftRightSame(x, static_cast<int>(shape_.shift_x)); }
  HWY_INLINE VI texel_column(VI x) const { return hn::And(x, hn::Set(DI(), last_x_)); }

  HWY_INLINE TileRow row_at(size_t at, VI y) const {
    const DI di;
    const VI across = tile_column(load(lease_.width + at) + hn::Set(di, last_x_));
    const VI down = hn::ShiftRightSame(y, static_cast<int>(shape_.shift_y));
    const VI texel = hn::ShiftLeftSame(hn::And(y, hn::Set(di, last_y_)), static_cast<int>(shape_.shift_x));
    return {load(lease_.first_tile + at) + down * across, texel};
  }

  HWY_INLINE static bool all_equal(VI a, VI b) { return hn::AllTrue(DI(), hn::Eq(a, b)); }

  /// Returns the index of the first texel of a tile, or -1 if the lease does not keep it and cannot.
  HWY_INLINE int32_t first_texel_of(uint32_t tile) {
    const uint32_t entry = TileLease::entry_of(tile);
    if (HWY_UNLIKELY(lease_.tile[entry] != tile)) {
      if (!lease_.keep(tile)) return -1;
    }
    lease_.turn[entry] = lease_.now;
    return lease_.first[entry];
  }

  /// Writes the tiles and the texels within them for resolve().
  HWY_INLINE void wait_for(size_t k, size_t at, const TileRow& row, VI x) {
    const DI di;
    const VI tile = row.tile + tile_column(x);
    hn::Store(tile, di, lease_.wanted[k] + at);
    hn::Store(row.texel + texel_column(x), di, stream_.index[k] + at);
  }
  HWY_INLINE void wait_for_bordered(size_t k, size_t at, const TileRow& row, VI x, VI y) {
    const DI di;
    wait_for(k, at, row, x);
    const auto outside = hn::Lt(hn::Or(x, y), hn::Zero(di));
    hn::Store(hn::IfThenElse(outside, hn::Set(di, -1), load(lease_.wanted[k] + at)), di, lease_.wanted[k] + at);
  }

  /// Places texels whose tiles the lease keeps. Returns false and changes nothing if it does not keep them all.
  HWY_INLINE bool find_kept(VI tile, VI texel, VI* index) const {
    const DI di;
    const hn::RebindToUnsigned<DI> du;
    const auto hash = hn::BitCast(du, tile) * hn::Set(du, 0x9e3779b1u);
    const VI entry = hn::BitCast(di, hn::ShiftRight<24>(hash));
    if (!all_equal(hn::GatherIndex(di, reinterpret_cast<const int32_t*>(lease_.tile), entry), tile)) return false;
    *index = hn::GatherIndex(di, lease_.first, entry) + texel;
    return true;
  }
  HWY_INLINE void mark_read(VI tile) {
    const DI di;
    alignas(64) uint32_t tiles[kMaxLanes];
    hn::Store(hn::BitCast(hn::RebindToUnsigned<DI>(), tile), hn::RebindToUnsigned<DI>(), tiles);
    for (size_t lane = 0; lane < hn::Lanes(di); ++lane) lease_.turn[TileLease::entry_of(tiles[lane])] = lease_.now;
  }

  HWY_INLINE bool place_quad(size_t e, size_t at) {
    const DI di;
    const VI x0 = load(stream_.index[0] + at), x1 = load(stream_.index[1] + at);
    const VI y0 = load(lease_.y[0] + at), y1 = load(lease_.y[1] + at);
    const TileRow top = row_at(at, y0), bottom = row_at(at, y1);
    const VI first = top.tile + tile_column(x0), last = bottom.tile + tile_column(x1);
    const bool adjacent = all_equal(x1, x0 + hn::Set(di, 1));
    const auto outside = hn::Lt(hn::Or(hn::Or(x0, x1), hn::Or(y0, y1)), hn::Zero(di));
    if (HWY_UNLIKELY(!hn::AllFalse(di, outside))) {
      wait_for_bordered(0, at, top, x0, y0);
      wait_for_bordered(1, at, top, x1, y0);
      wait_for_bordered(2, at, bottom, x0, y1);
      wait_for_bordered(3, at, bottom, x1, y1);
      return false;
    }
    const VI one = hn::Set(di, hn::GetLane(first));
    if (HWY_LIKELY(adjacent && hn::AllTrue(di, hn::And(hn::Eq(first, one), hn::Eq(last, one))))) {
      const int32_t base = first_texel_of(static_cast<uint32_t>(hn::GetLane(first)));
      if (HWY_LIKELY(base >= 0)) {
        const VI column = hn::Set(di, base) + texel_column(x0);
        hn::Store(column + top.texel, di, stream_.index[0] + at);
        hn::Store(column + bottom.texel, di, stream_.index[2] + at);
        stream_.op[e] = static_cast<uint16_t>(stream_.op[e] | kNeighbours);
        return true;
      }
    }
    return place_apart(e, at, adjacent && all_equal(tile_column(x0), tile_column(x1)), {top, bottom}, {x0, x1});
  }

  /// Places a quad in several tiles. `beside`: its columns are side by side in one tile, for every lane.
  HWY_INLINE bool place_apart(size_t e, size_t at, bool beside, const TileRow (&rows)[2], const VI (&x)[2]) {
    const DI di;
    VI index[4];
    bool kept = true;
    for (size_t k = 0; k < 4 && kept; k += beside ? 2 : 1) {
      const TileRow& row = rows[k / 2];
      kept = find_kept(row.tile + tile_column(x[k % 2]), row.texel + texel_column(x[k % 2]), &index[k]);
    }
    for (size_t k = 0; k < 4; ++k) {
      const TileRow& row = rows[k / 2];
      if (!kept) {
        wait_for(k, at, row, x[k % 2]);
      } else if (!beside || k % 2 == 0) {
        hn::Store(index[k], di, stream_.index[k] + at);
        mark_read(row.tile + tile_column(x[k % 2]));
      }
    }
    if (!kept) return false;
    const uint32_t op = stream_.op[e] & ~kNeighbours;
    stream_.op[e] = static_cast<uint16_t>(beside ? op | kNeighbours : op);
    return true;
  }

  HWY_INLINE bool place_row(size_t e, size_t at) {
    const DI di;
    const VI y = load(lease_.y[0] + at);
    const TileRow row = row_at(at, y);
    const VI left = load(stream_.index[2] + at), right = load(stream_.index[3] + at);
    const VI first = row.tile + tile_column(left);
    if (stream_.op[e] & kNeighbours && all_equal(first, row.tile + tile_column(right))) {
      VI index;
      if (find_kept(first, row.texel + texel_column(left), &index)) {
        mark_read(first);
        hn::Store(index, di, stream_.index[2] + at);
        return true;
      }
    }
    for (size_t k = 0; k < 4; ++k) wait_for_bordered(k, at, row, load(stream_.index[k] + at), y);
    return false;
  }

  HWY_INLINE bool place_texel(size_t at) {
    const DI di;
    const VI x = load(stream_.index[0] + at), y = load(lease_.y[0] + at);
    const TileRow row = row_at(at, y);
    const VI tile = row.tile + tile_column(x);
    VI index;
    if (hn::AllFalse(di, hn::Lt(hn::Or(x, y), hn::Zero(di))) && find_kept(tile, row.texel + texel_column(x), &index)) {
      mark_read(tile);
      hn::Store(index, di, stream_.index[0] + at);
      return true;
    }
    wait_for_bordered(0, at, row, x, y);
    return false;
  }

  TileLease& lease_;
  Stream& stream_;
  const TileShape shape_;
  const int32_t last_x_, last_y_;  // of a tile [texels]
};

}  // namespace

void PlaceInTiles(TileLease* lease, size_t end, Stream* stream) {
  TilePlacer(lease, stream).place(end);
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
