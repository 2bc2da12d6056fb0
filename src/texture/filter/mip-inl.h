// SPDX-License-Identifier: MIT
// Filters on the nearest mip level.

#if defined(SHD_TEXTURE_MIP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_MIP_INL_H_
#undef SHD_TEXTURE_MIP_INL_H_
#else
#define SHD_TEXTURE_MIP_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/filter/bases-inl.h"
#include "texture/filter/nearest-inl.h"
#include "texture/filter/rows-inl.h"
#include "texture/stream.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Returns the nearest level of the vector of lookups at i.
template <class D>
HWY_INLINE Level<D> NearestLevelAt(D d, const Texture& texture, const LodBlock& block, size_t i) {
  return LevelAt(d, texture, FirstTexel(d, texture, block, i), NearestLevel(d, hn::Load(d, block.lod + i)));
}

struct NearestMip : OnMipLevels {
  using OnMipLevels::OnMipLevels;

  /// Never prefetches: for one texel per lookup, prefetches cost more than they save.
  static bool is_scattered(const Texture&, const PointBlock&) { return false; }

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const LodBlock& block, size_t i, Sink& sink) const {
    emit_nearest(d, sampler, NearestLevelAt(d, texture, block, i), block, i, sink);
    sink.finish();
  }
};

struct BilinearMip : OnMipLevels {
  using OnMipLevels::OnMipLevels;

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const LodBlock& block, size_t i, Sink& sink) const {
    const auto u = hn::Load(d, block.u + i), v = hn::Load(d, block.v + i);
    sink.quad(d, kStart, NearestLevelAt(d, texture, block, i), u, v);
    sink.finish();
  }

  /// Finds the levels that lookups share, for rows. Returns false if they share none.
  static bool share_levels(const Texture&, const RowBlock& block, RowLevels* out) {
    const BatchTag d;
    const LodBounds lod = BoundsOf(block);
    const float least = hn::GetLane(NearestLevel(d, hn::Set(d, lod.least)));
    *out = {static_cast<uint32_t>(least), static_cast<uint32_t>(least), false};
    return hn::GetLane(NearestLevel(d, hn::Set(d, lod.most))) == least;
  }
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_MIP_INL_H_
