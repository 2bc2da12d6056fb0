// SPDX-License-Identifier: MIT
#include "texture/rows.h"
#include "texture/store/bc/cache.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/store/bc/place_rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/lanes-inl.h"
#include "texture/store/bc/windows-inl.h"
#include "texture/store/place-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

/// Places blocks of lookups whose quads lie on the same two rows of texels, as those of a level floor do.
class BcRowPlacer : BcWindows {
 public:
  BcRowPlacer(const Texture& texture, BcCache* cache) : BcWindows(texture, cache) {}

  bool place(const RowLevel (&levels)[2], RowStream* rows) {
    begin();
    for (size_t k = 0; k < (rows->blended ? 2 : 1); ++k) {
      if (!place_level(levels[k], rows->count, &rows->quads[k])) return false;
    }
    return true;
  }

 private:
  /// Columns of texels.
  struct Columns {
    int32_t low, high;
  };

  HWY_INLINE bool place_level(const RowLevel& level, size_t count, RowQuads* quads) {
    const DI di;
    Columns columns;
    if (!find_columns(*quads, count, &columns)) return false;
    const Image image = image_at(static_cast<uint32_t>(level.first), static_cast<uint32_t>(level.width));
    int32_t upper, lower;
    if (!find_row(image, quads->other[0][0], columns, &upper)) return false;
    if (!find_row(image, quads->other[2][0], columns, &lower)) return false;
    quads->down = lower - upper;
    for (size_t i = 0; i < count; i += hn::Lanes(di)) {
      hn::Store(load(quads->upper + i) + hn::Set(di, upper), di, quads->upper + i);
    }
    return true;
  }

  /// Finds the columns of quads of neighbours on the same rows. Returns false for others, and for columns far apart.
  HWY_INLINE bool find_columns(const RowQuads& quads, size_t count, Columns* columns) const {
    const DI di;
    const VI top = hn::Set(di, quads.other[0][0]);
    VI low = load(quads.upper), high = low, other = hn::Zero(di);
    bool split = false;
    for (size_t i = 0, vector = 0; i < count; i += hn::Lanes(di), ++vector) {
      const VI left = load(quads.upper + i);
      low = hn::Min(low, left);
      high = hn::Max(high, left);
      other = hn::Or(other, load(quads.other[0] + i) ^ top);
      split = split || quads.split[vector];
    }
    *columns = {hn::GetLane(hn::MinOfLanes(di, low)), hn::GetLane(hn::MaxOfLanes(di, high)) + 1};
    return !split && hn::AllTrue(di, hn::Eq(other, hn::Zero(di))) && columns->high - columns->low < kLongest;
  }

  /// Loads the blocks of columns of row y. Column x is then texel x + *offset of the cache.
  HWY_INLINE bool find_row(const Image& image, int32_t y, const Columns& columns, int32_t* offset) {
    Window window;
    if (!open_window(image, static_cast<uint32_t>(y) / 4, columns.low, columns.high, &window)) return false;
    *offset = (y & 3) * static_cast<int32_t>(cache_.pitch) + window.offset;
    return true;
  }

  static constexpr int32_t kLongest = 4 * RowQuads::kColumn;  // [texels]
};

}  // namespace

bool PlaceRowsInBc(void* lease, const RowLevel (&levels)[2], RowStream* rows) {
  const auto& of_call = *static_cast<CacheLease*>(lease);
  return BcRowPlacer(of_call.texture(), of_call.cache()).place(levels, rows);
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
