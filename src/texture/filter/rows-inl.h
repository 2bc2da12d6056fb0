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

/// Lookups of a block: their coordinates, and their levels of detail, or null on the base level.
struct RowBlock {
  const float *u, *v, *lod;
  size_t count;

  /// The lookups from `begin` on, up to a number.
  RowBlock part(size_t begin, size_t most) const {
    const size_t left = count - begin;
    return {u + begin, v + begin, lod ? lod + begin : nullptr, left < most ? left : most};
  }
};

/// The levels of detail of lookups.
struct LodBounds {
  float least, most;
};
HWY_INLINE LodBounds BoundsOf(const RowBlock& block) {
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

/// Writes the quads of the vector of lookups at i: their texels in memory, or kPlaced: columns and rows, for a store
/// that places them.
template <bool kPlaced, class D>
HWY_INLINE void WriteQuads(D d, const Level<D>& level, const LinearTaps<D>& x, const LinearTaps<D>& y, bool split,
                           size_t i, RowQuads* out) {
  const hn::RebindToSigned<D> di;
  hn::Store(x.s, d, out->s + i);
  hn::Store(y.s, d, out->t + i);
  out->split[i / hn::Lanes(d)] = split;
  if constexpr (kPlaced) {
    hn::Store(x.i0, di, out->upper + i);
    hn::Store(y.i0, di, out->other[0] + i);
    hn::Store(x.i1, di, out->other[1] + i);
    hn::Store(y.i1, di, out->other[2] + i);
    return;
  }
  const auto top = RowIndex(d, level, y.i0);
  hn::Store(top + x.i0, di, out->upper + i);
  if (HWY_LIKELY(!split)) return;
  const auto bottom = RowIndex(d, level, y.i1);
  hn::Store(top + x.i1, di, out->other[0] + i);
  hn::Store(bottom + x.i0, di, out->other[1] + i);
  hn::Store(bottom + x.i1, di, out->other[2] + i);
}

/// Finds the quads of a block on a level, as WriteQuads() writes them. A wrap is a constant or a value.
template <bool kPlaced, class WrapU, class WrapV>
HWY_INLINE void AddressWrapped(const Texture& texture, const Sampler& sampler, const RowBlock& block, uint32_t number,
                               WrapU wrap_u, WrapV wrap_v, RowQuads* out) {
  const BatchTag d;
  const hn::RebindToSigned<BatchTag> di;
  const auto level = SameLevel(d, texture, hn::Zero(di), number);
  const auto one = hn::Set(di, 1);
  const Weights weights = sampler.weights;
  const size_t lanes = hn::Lanes(d), count = block.count;
  out->down = static_cast<int32_t>(level_size(texture.width, number));
  for (size_t i = 0; i < count; i += lanes) {
    auto x = WrapLinear(d, wrap_u, hn::Load(d, block.u + i), level.across);
    auto y = WrapLinear(d, wrap_v, hn::Load(d, block.v + i), level.down);
    if (HWY_UNLIKELY(weights != Weights::kLinear)) ChangeWeights(d, weights, &x, &y);
    const bool split = !hn::AllTrue(di, hn::And(hn::Eq(x.i1, x.i0 + one), hn::Eq(y.i1, y.i0 + one)));
    WriteQuads<kPlaced>(d, level, x, y, split, i, out);
  }
}

/// Finds the quads of a block on a level, for the store of the texture.
inline HWY_NOINLINE void AddressQuads(const Texture& texture, const Sampler& sampler, const RowBlock& block,
                                      uint32_t level, RowQuads* out) {
  const shd_wrap u = sampler.wrap_u, v = sampler.wrap_v;
  if (HWY_UNLIKELY(!is_in_memory(texture))) {
    AddressWrapped<true>(texture, sampler, block, level, u, v, out);
  } else if (u == v && u == SHD_WRAP_REPEAT && sampler.weights == Weights::kLinear) {
    const std::integral_constant<shd_wrap, SHD_WRAP_REPEAT> repeat;
    AddressWrapped<false>(texture, sampler, block, level, repeat, repeat, out);
  } else {
    AddressWrapped<false>(texture, sampler, block, level, u, v, out);
  }
}

/// Finds the quads of a block on the levels that its lookups share.
inline void AddressRows(const Texture& texture, const Sampler& sampler, const RowBlock& block, const RowLevels& levels,
                        RowStream* out) {
  out->count = block.count;
  out->blended = levels.blended;
  AddressQuads(texture, sampler, block, levels.fine, &out->quads[0]);
  if (!levels.blended) return;
  AddressQuads(texture, sampler, block, levels.coarse, &out->quads[1]);
  const BatchTag d;
  const auto fine = hn::Set(d, static_cast<float>(levels.fine));
  for (size_t i = 0; i < block.count; i += hn::Lanes(d)) {
    hn::Store(hn::Load(d, block.lod + i) - fine, d, out->fraction + i);
  }
}

/// Returns a level as stores place it.
inline RowLevel RowLevelOf(const Texture& texture, uint32_t level) {
  return {static_cast<int32_t>(texture.layout.offset[level]), static_cast<int32_t>(level_size(texture.width, level))};
}

/// Takes the quads of a block that shares no levels, vector by vector.
class RowSink {
 public:
  using D = BatchTag;

  RowSink(const Sampler& sampler, size_t count, RowStream* rows) : sampler_(sampler), rows_(*rows) {
    rows_.count = count;
    rows_.blended = false;
  }

  void quad(D d, uint32_t, const Level<D>& level, hn::Vec<D> u, hn::Vec<D> v) {
    write(d, level, u, v, 0);
    blended_ = false;
  }
  void quad(D d, uint32_t, const Level<D>& level, hn::Vec<D> u, hn::Vec<D> v, hn::Vec<D> share) {
    write(d, level, u, v, 1);
    hn::Store(share, d, rows_.fraction + at_);
    blended_ = rows_.blended = true;
  }
  void finish() {
    if (!blended_) repeat_first();
    at_ += hn::Lanes(D());
  }

 private:
  HWY_NOINLINE void write(D d, const Level<D>& level, hn::Vec<D> u, hn::Vec<D> v, size_t quad) {
    LinearTaps<D> x = WrapLinear(d, sampler_.wrap_u, u, level.across);
    LinearTaps<D> y = WrapLinear(d, sampler_.wrap_v, v, level.down);
    if (HWY_UNLIKELY(sampler_.weights != Weights::kLinear)) ChangeWeights(d, sampler_.weights, &x, &y);
    WriteQuads<false>(d, level, x, y, true, at_, &rows_.quads[quad]);
  }
  /// Makes the second quads of a vector without them, with the share 0, for blocks in which other vectors have them.
  void repeat_first() {
    const D d;
    const hn::RebindToSigned<D> di;
    const RowQuads& from = rows_.quads[0];
    RowQuads& to = rows_.quads[1];
    const auto copy = [&](const int32_t* source, int32_t* target) { hn::Store(hn::Load(di, source), di, target); };
    hn::Store(hn::Load(d, from.s + at_), d, to.s + at_);
    hn::Store(hn::Load(d, from.t + at_), d, to.t + at_);
    copy(from.upper + at_, to.upper + at_);
    for (size_t k = 0; k < 3; ++k) copy(from.other[k] + at_, to.other[k] + at_);
    to.split[at_ / hn::Lanes(d)] = true;
    hn::Store(hn::Zero(d), d, rows_.fraction + at_);
  }

  const Sampler& sampler_;
  RowStream& rows_;
  size_t at_ = 0;
  bool blended_ = false;
};

/// Finds the quads of a block that shares no levels.
template <class Filter>
HWY_NOINLINE void AddressEach(const Filter& filter, const typename Filter::Block& block, RowStream* out) {
  const BatchTag d;
  RowSink sink(filter.sampler, block.count, out);
  for (size_t i = 0; i < block.count; i += hn::Lanes(d)) filter.emit(d, block, i, sink);
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_ROWS_INL_H_
