// SPDX-License-Identifier: MIT
#include "texture/rows.h"
#include "texture/store/tiles/lease.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/store/tiles/place_rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/lanes-inl.h"
#include "texture/store/place-inl.h"
#include "texture/store/tiles/kept-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

class TileRowPlacer : KeptTiles {
 public:
  explicit TileRowPlacer(TileCall* call) : KeptTiles(call) {}

  bool place(const RowLevel (&levels)[2], RowStream* rows) {
    lease_.begin_stream();
    for (size_t k = 0; k < (rows->blended ? 2 : 1); ++k) {
      if (!place_level(levels[k], rows->count, &rows->quads[k])) return false;
    }
    const size_t lanes = hn::Lanes(DI());
    call_.lookup += (rows->count + lanes - 1) / lanes * lanes;
    return true;
  }

 private:
  /// A tile that holds most quads of a row: its first texel on the level, and the index of this texel.
  struct Tile {
    int32_t x, y, first;
  };

  HWY_INLINE bool place_level(const RowLevel& level, size_t count, RowQuads* quads) {
    const size_t lanes = hn::Lanes(DI());
    quads->down = 1 << shape_.shift_x;
    Tile tile;
    if (!find_tile(level, *quads, 0, &tile)) return false;
    size_t apart = 0;
    for (size_t i = 0, vector = 0; i < count; i += lanes, ++vector) {
      if (HWY_LIKELY(!quads->split[vector])) {
        if (HWY_LIKELY(place_in(tile, i, quads))) continue;
        if (!find_tile(level, *quads, i, &tile)) return false;
        if (place_in(tile, i, quads)) continue;
      }
      // Streams prefetch the texels of quads that are far apart.
      if (++apart > kMostApart + vector / kMostApart || !place_apart(level, i, quads)) return false;
      quads->split[vector] = true;
    }
    return true;
  }

  /// Finds the tile of the quad at i. Returns false if it is not at hand.
  HWY_INLINE bool find_tile(const RowLevel& level, const RowQuads& quads, size_t i, Tile* tile) {
    const int32_t x = quads.upper[i], y = quads.other[0][i];
    *tile = {x & ~last_x_, y & ~last_y_, first_texel_of(tile_of(level.first, level.width, x, y))};
    return tile->first >= 0;
  }

  /// Places quads of neighbours in a tile. Returns false and changes nothing if some of them are elsewhere.
  HWY_INLINE bool place_in(const Tile& tile, size_t i, RowQuads* quads) const {
    const DI di;
    const VI x = load(quads->upper + i) - hn::Set(di, tile.x), y = load(quads->other[0] + i) - hn::Set(di, tile.y);
    const VI left = hn::Set(di, last_x_ - 1) - x, above = hn::Set(di, last_y_ - 1) - y;
    const VI outside = hn::Or(hn::Or(x, y), hn::Or(left, above));  // negative where one of these is
    if (HWY_UNLIKELY(!hn::AllFalse(di, hn::Lt(outside, hn::Zero(di))))) return false;
    const VI row = hn::ShiftLeftSame(y, static_cast<int>(shape_.shift_x));
    hn::Store(hn::Set(di, tile.first) + x + row, di, quads->upper + i);
    return true;
  }

  /// Places quads in several tiles, texel by texel. Returns false if some tile is not at hand.
  HWY_NOINLINE bool place_apart(const RowLevel& level, size_t i, RowQuads* quads) {
    const DI di;
    const VI left = load(quads->upper + i), top = load(quads->other[0] + i);
    const VI right = load(quads->other[1] + i), bottom = load(quads->other[2] + i);
    keep_tiles(level, left, right, top, bottom);
    const VI across = hn::Set(di, (level.width + last_x_) >> shape_.shift_x), first = hn::Set(di, level.first);
    Kept kept[4];
    for (size_t k = 0; k < 4; ++k) {
      const VI x = k % 2 ? right : left, y = k < 2 ? top : bottom;
      const VI tile = first + hn::ShiftRightSame(y, static_cast<int>(shape_.shift_y)) * across + tile_column(x);
      if (!find_kept(tile, texel_row(y) + texel_column(x), &kept[k])) return false;
    }
    for (size_t k = 0; k < 4; ++k) {
      hn::Store(kept[k].index, di, (k == 0 ? quads->upper : quads->other[k - 1]) + i);
      mark_read(kept[k]);
    }
    return true;
  }

  /// Lets the lease keep the tiles of the corners of a vector of quads, which most often are all of its tiles.
  HWY_INLINE void keep_tiles(const RowLevel& level, VI left, VI right, VI top, VI bottom) {
    const DI di;
    const size_t last = hn::Lanes(di) - 1;
    alignas(64) int32_t x[2][kMaxLanes], y[2][kMaxLanes];
    hn::Store(left, di, x[0]);
    hn::Store(right, di, x[1]);
    hn::Store(top, di, y[0]);
    hn::Store(bottom, di, y[1]);
    for (size_t k = 0; k < 4; ++k) {
      first_texel_of(tile_of(level.first, level.width, x[k % 2][0], y[k / 2][0]));
      first_texel_of(tile_of(level.first, level.width, x[k % 2][last], y[k / 2][last]));
    }
  }

  static constexpr size_t kMostApart = 4;  // at the beginning, and one vector in kMostApart
};

}  // namespace

bool PlaceRowsInTiles(void* call, const RowLevel (&levels)[2], RowStream* rows) {
  return TileRowPlacer(static_cast<TileCall*>(call)).place(levels, rows);
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
