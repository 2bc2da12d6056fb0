// SPDX-License-Identifier: MIT
// Rows of quads for linear filters (rows.h).

#if defined(SHD_TEXTURE_ROWS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_ROWS_INL_H_
#undef SHD_TEXTURE_ROWS_INL_H_
#else
#define SHD_TEXTURE_ROWS_INL_H_
#endif

#include <type_traits>

#include <hwy/highway.h>

#include "texture/domain/block.h"
#include "texture/domain/wrap-inl.h"
#include "texture/rows.h"
#include "texture/store/level-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::RoundDown;

/// The levels of detail of a block.
struct LodBounds {
  float least, most;
};
HWY_INLINE LodBounds BoundsOf(const LodBlock& block) {
  const BatchTag d;
  auto least = hn::Load(d, block.lod), most = least;
  for (size_t i = hn::Lanes(d); i < block.count; i += hn::Lanes(d)) {
    const auto lod = hn::Load(d, block.lod + i);
    least = hn::Min(least, lod);
    most = hn::Max(most, lod);
  }
  return {hn::GetLane(hn::MinOfLanes(d, least)), hn::GetLane(hn::MaxOfLanes(d, most))};
}

/// The levels that all lookups of a block share.
struct RowLevels {
  uint32_t fine, coarse;
  bool blended;  // some lookup reads the coarse level
};

/// Finds the quads of a block on a level. A wrap is a constant or a value.
template <class WrapU, class WrapV>
HWY_INLINE void AddressWrapped(const Texture& texture, const Sampler& sampler, const PointBlock& block, uint32_t number,
                               WrapU wrap_u, WrapV wrap_v, RowQuads* out) {
  const BatchTag d;
  const hn::RebindToSigned<BatchTag> di;
  const auto level = SameLevel(d, texture, hn::Zero(di), number);
  const auto one = hn::Set(di, 1);
  const bool rounded = sampler.rounded_weights;
  const size_t lanes = hn::Lanes(d), count = block.count;
  out->down = static_cast<int32_t>(level_size(texture.width, number));
  for (size_t i = 0, vector = 0; i < count; i += lanes, ++vector) {
    auto x = WrapLinear(d, wrap_u, hn::Load(d, block.u + i), level.across);
    auto y = WrapLinear(d, wrap_v, hn::Load(d, block.v + i), level.down);
    if (HWY_UNLIKELY(rounded)) {
      RoundWeights(d, &x);
      RoundWeights(d, &y);
    }
    const auto top = RowIndex(d, level, y.i0);
    hn::Store(x.s, d, out->s + i);
    hn::Store(y.s, d, out->t + i);
    hn::Store(top + x.i0, di, out->upper + i);
    const bool split = !hn::AllTrue(di, hn::And(hn::Eq(x.i1, x.i0 + one), hn::Eq(y.i1, y.i0 + one)));
    out->split[vector] = split;
    if (HWY_LIKELY(!split)) continue;
    const auto bottom = RowIndex(d, level, y.i1);
    hn::Store(top + x.i1, di, out->other[0] + i);
    hn::Store(bottom + x.i0, di, out->other[1] + i);
    hn::Store(bottom + x.i1, di, out->other[2] + i);
  }
}

/// Finds the quads of a block on a level.
inline HWY_NOINLINE void AddressQuads(const Texture& texture, const Sampler& sampler, const PointBlock& block,
                                      uint32_t level, RowQuads* out) {
  const shd_wrap u = sampler.wrap_u, v = sampler.wrap_v;
  if (u == v && u == SHD_WRAP_REPEAT && !sampler.rounded_weights) {
    const std::integral_constant<shd_wrap, SHD_WRAP_REPEAT> repeat;
    AddressWrapped(texture, sampler, block, level, repeat, repeat, out);
  } else {
    AddressWrapped(texture, sampler, block, level, u, v, out);
  }
}

/// Finds the quads of a block on the levels that its lookups share.
inline void AddressRows(const Texture& texture, const Sampler& sampler, const PointBlock& block, const float* lod,
                        const RowLevels& levels, RowStream* out) {
  out->count = block.count;
  out->blended = levels.blended;
  AddressQuads(texture, sampler, block, levels.fine, &out->quads[0]);
  if (!levels.blended) return;
  AddressQuads(texture, sampler, block, levels.coarse, &out->quads[1]);
  const BatchTag d;
  const auto fine = hn::Set(d, static_cast<float>(levels.fine));
  for (size_t i = 0; i < block.count; i += hn::Lanes(d)) {
    hn::Store(hn::Load(d, lod + i) - fine, d, out->fraction + i);
  }
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_ROWS_INL_H_
