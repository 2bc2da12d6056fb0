// SPDX-License-Identifier: MIT
// Texels in the tiles that a lease keeps.

#if defined(SHD_TEXTURE_KEPT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_KEPT_INL_H_
#undef SHD_TEXTURE_KEPT_INL_H_
#else
#define SHD_TEXTURE_KEPT_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/lanes-inl.h"
#include "texture/store/tiles/lease.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Base of the placers of a call: vectors of texels in the tiles of its lease.
class KeptTiles {
 protected:
  using DI = hn::RebindToSigned<BatchTag>;
  using VI = hn::Vec<DI>;

  explicit KeptTiles(TileCall* call)
      : call_(*call),
        lease_(*call->lease),
        shape_(call->texture.layout.unit),
        last_x_((1 << shape_.shift_x) - 1),
        last_y_((1 << shape_.shift_y) - 1) {}

  static HWY_INLINE VI load(const int32_t* values) { return hn::Load(DI(), values); }
  static HWY_INLINE bool all_equal(VI a, VI b) { return hn::AllTrue(DI(), hn::Eq(a, b)); }

  HWY_INLINE VI tile_column(VI x) const { return hn::ShiftRightSame(x, static_cast<int>(shape_.shift_x)); }
  HWY_INLINE VI texel_column(VI x) const { return hn::And(x, hn::Set(DI(), last_x_)); }
  HWY_INLINE VI texel_row(VI y) const {
    return hn::ShiftLeftSame(hn::And(y, hn::Set(DI(), last_y_)), static_cast<int>(shape_.shift_x));
  }

  /// Returns the tile of a texel of a level, from the level's first tile and its width [texels].
  HWY_INLINE uint32_t tile_of(int32_t first, int32_t width, int32_t x, int32_t y) const {
    const int32_t across = (width + last_x_) >> shape_.shift_x;
    return static_cast<uint32_t>(first + (y >> shape_.shift_y) * across + (x >> shape_.shift_x));
  }

  /// Returns the index of the first texel of a tile, or -1 if the lease does not keep it and cannot.
  HWY_INLINE int32_t first_texel_of(uint32_t tile) {
    const uint32_t entry = TileLease::entry_of(tile);
    if (HWY_UNLIKELY(lease_.tile[entry] != tile)) {
      if (!lease_.keep(tile)) return -1;
    }
    lease_.turn[entry] = lease_.now;
    return lease_.first[entry];
  }

  /// Texels whose tiles the lease keeps: their entries in the lease, and their indices.
  struct Kept {
    VI entry, index;
  };

  /// Finds texels in the tiles that the lease keeps. Returns false and changes nothing if it does not keep them all.
  HWY_INLINE bool find_kept(VI tile, VI texel, Kept* kept) const {
    const DI di;
    const hn::RebindToUnsigned<DI> du;
    const auto hash = hn::BitCast(du, tile) * hn::Set(du, 0x9e3779b1u);
    kept->entry = hn::BitCast(di, hn::ShiftRight<22>(hash));
    const VI tiles = hn::GatherIndex(di, reinterpret_cast<const int32_t*>(lease_.tile), kept->entry);
    if (!all_equal(tiles, tile)) return false;
    kept->index = hn::GatherIndex(di, lease_.first, kept->entry) + texel;
    return true;
  }
  HWY_INLINE void mark_read(const Kept& kept) {
    alignas(64) int32_t entry[kMaxLanes];
    hn::Store(kept.entry, DI(), entry);
    for (size_t lane = 0; lane < hn::Lanes(DI()); ++lane) lease_.turn[entry[lane]] = lease_.now;
  }

  TileCall& call_;
  TileLease& lease_;  // until resolve()
  const UnitShape shape_;
  const int32_t last_x_, last_y_;  // last column and row of a tile [texels]
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_KEPT_INL_H_
