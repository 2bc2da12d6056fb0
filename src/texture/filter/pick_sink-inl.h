// SPDX-License-Identifier: MIT
// A sink that picks one texel, or one quad, of each lookup. A value that enters a running average with the share s
// replaces the pick with the probability s. The probability of a texel then is its weight in the filter (Chao, "A
// General Purpose Unequal Probability Sampling Plan", 1982). Filters need positive weights.
//
// A lane whose choice is certain takes no random number, so that picks do not depend on the other lanes of a vector.

#if defined(SHD_TEXTURE_PICK_SINK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_PICK_SINK_INL_H_
#undef SHD_TEXTURE_PICK_SINK_INL_H_
#else
#define SHD_TEXTURE_PICK_SINK_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/filter/random-inl.h"
#include "texture/filter/runner-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Passes the pick of each lookup to a StreamSink.
class PickSink {
 public:
  static constexpr bool kPicks = true;
  using D = BatchTag;
  using V = hn::Vec<D>;
  using VI = Ints<D>;

  explicit PickSink(const FilterCall& call)
      : stream_(call), seed_(call.sampler.seed), picks_quads_(call.sampler.stochastic == SHD_STOCHASTIC_QUAD) {}

  HWY_INLINE const Sampler& sampler() const { return stream_.sampler(); }
  static constexpr bool has_rates() { return false; }
  void begin(size_t first, bool scattered) { stream_.begin(first, scattered); }
  void flush() { stream_.flush(); }

  /// Begins a vector of lookups. Each average has numbers of its own: elements of the second one depend on other lanes.
  HWY_INLINE void start(D d, Bits<D> random) {
    rng_[0] = Rng<D>(d, random, seed_);
    rng_[1] = Rng<D>(d, random, ~seed_);
  }

  template <class... AnyShare>
  HWY_INLINE void texel(D d, uint32_t op, const Level<D>& level, const TexelPlace<D>& texel, MaskOf<D>,
                        const AnyShare&... share) {
    const TexelPlace<D> four[4] = {texel, texel, texel, texel};
    take(d, op, level, four, {hn::Zero(d), hn::Zero(d), hn::Zero(d)}, false, ValueOf(d, share...));
  }
  template <class... AnyShare>
  HWY_INLINE void quad(D d, uint32_t op, const Level<D>& level, const LinearTaps<D>& x, const LinearTaps<D>& y,
                       const AnyShare&... share) {
    const TexelPlace<D> four[4] = {
        {x.i0, y.i0, level.offset}, {x.i1, y.i0, level.offset}, {x.i0, y.i1, level.offset}, {x.i1, y.i1, level.offset}};
    quad_of(d, op, level, four, x.s, y.s, share...);
  }
  template <class... AnyShare>
  HWY_NOINLINE void quad_of(D d, uint32_t op, const Level<D>& level, const TexelPlace<D> (&texel)[4], V s, V t,
                            const AnyShare&... share) {
    take(d, op, level, texel, {s, t, hn::Zero(d)}, false, ValueOf(d, share...));
  }
  template <class AnyShare>
  HWY_INLINE void row(D d, uint32_t op, const Level<D>& level, const Row<D>& row, const AnyShare& share) {
    TexelPlace<D> four[4];
    for (size_t k = 0; k < 4; ++k) four[k] = {row.column[k], row.y, level.offset};
    row_of(d, op, level, four, row, share);
  }
  template <class AnyShare>
  HWY_NOINLINE void row_of(D d, uint32_t op, const Level<D>& level, const TexelPlace<D> (&texel)[4],
                           const RowShares<D>& shares, const AnyShare& share) {
    take(d, op, level, texel, {shares.share[0], shares.share[1], shares.share[2]}, true, ValueOf(d, share));
  }
  HWY_INLINE void merge(D d, V share) { replace(d, draws(d, 0, share), pick_[1], &pick_[0]); }

  HWY_INLINE void finish() {
    const D d;
    const Pick& pick = pick_[0];
    const V zero = hn::Zero(d);
    Level<D> level = {};
    level.across.whole = pick.width;
    if (picks_quads_) {
      const auto is_row = hn::Gt(pick.is_row, zero);
      stream_.quad_of(d, kStart, level, pick.texel, pick.inner.s, pick.inner.t);
      if (HWY_UNLIKELY(!hn::AllFalse(d, is_row))) {
        const RowShares<D> shares = {{pick.inner.s, pick.inner.t, pick.inner.r}, {zero, zero, zero}};
        stream_.row_of(d, kReplace, level, pick.texel, shares, hn::IfThenElseZero(is_row, hn::Set(d, kWhole)));
      }
    } else {
      stream_.texel(d, kStart | kNewLine, level, pick.texel[0], hn::Eq(zero, zero));
    }
    stream_.finish();
  }

 private:
  /// Fractions of a quad, or shares of a row.
  struct Inner {
    V s, t, r;
  };
  struct Pick {
    TexelPlace<D> texel[4];  // one, or those of a quad or row
    VI width;                // width of the level
    Inner inner;
    V is_row;  // 1 or 0
  };

  static HWY_INLINE V ValueOf(D d) { return hn::Set(d, 1.0f); }
  static HWY_INLINE V ValueOf(D, V share) { return share; }
  static HWY_INLINE V ValueOf(D, const Share<D>& share) { return share.value; }

  /// Lanes where an event of a probability happens.
  HWY_INLINE MaskOf<D> draws(D d, size_t average, V probability) {
    const auto open = hn::And(hn::Gt(probability, hn::Zero(d)), hn::Lt(probability, hn::Set(d, 1.0f)));
    return hn::Lt(rng_[average].next_if(d, open), probability);
  }

  static HWY_INLINE void select(MaskOf<D> lanes, const TexelPlace<D>& from, TexelPlace<D>* to) {
    const auto chosen = hn::RebindMask(hn::RebindToSigned<D>(), lanes);
    to->x = hn::IfThenElse(chosen, from.x, to->x);
    to->y = hn::IfThenElse(chosen, from.y, to->y);
    to->first = hn::IfThenElse(chosen, from.first, to->first);
  }
  HWY_INLINE void replace(D, MaskOf<D> lanes, const Pick& from, Pick* to) const {
    for (size_t k = 0; k < (picks_quads_ ? 4 : 1); ++k) select(lanes, from.texel[k], &to->texel[k]);
    to->width = hn::IfThenElse(hn::RebindMask(hn::RebindToSigned<D>(), lanes), from.width, to->width);
    if (picks_quads_) {
      to->inner.s = hn::IfThenElse(lanes, from.inner.s, to->inner.s);
      to->inner.t = hn::IfThenElse(lanes, from.inner.t, to->inner.t);
      to->inner.r = hn::IfThenElse(lanes, from.inner.r, to->inner.r);
      to->is_row = hn::IfThenElse(lanes, from.is_row, to->is_row);
    }
  }

  /// Picks an element of an average with its share.
  HWY_INLINE void take(D d, uint32_t op, const Level<D>& level, const TexelPlace<D> (&texel)[4], const Inner& inner,
                       bool is_row, V share) {
    const size_t average = op & kSecond ? 1 : 0;
    if ((op & kHow) == kStart) share = hn::Set(d, 1.0f);
    const auto lanes = draws(d, average, share);
    Pick element = {
        {texel[0], texel[1], texel[2], texel[3]}, level.across.whole, inner, hn::Set(d, is_row ? 1.0f : 0.0f)};
    if (!picks_quads_) element.texel[0] = pick_texel(d, average, texel, inner, is_row, lanes);
    replace(d, lanes, element, &pick_[average]);
  }

  /// Picks a texel of an element in lanes that take the element.
  HWY_INLINE TexelPlace<D> pick_texel(D d, size_t average, const TexelPlace<D> (&texel)[4], const Inner& inner,
                                      bool is_row, MaskOf<D> lanes) {
    const auto chance = [&](V share) SHD_INLINE_LAMBDA { return draws(d, average, hn::IfThenElseZero(lanes, share)); };
    TexelPlace<D> picked = texel[0];
    if (is_row) {
      select(chance(inner.s), texel[1], &picked);
      select(chance(inner.t), texel[2], &picked);
      select(chance(inner.r), texel[3], &picked);
      return picked;
    }
    const auto right = chance(inner.s), below = chance(inner.t);
    select(right, texel[1], &picked);
    select(below, texel[2], &picked);
    select(hn::And(right, below), texel[3], &picked);
    return picked;
  }

  StreamSink stream_;
  const uint32_t seed_;
  const bool picks_quads_;
  Rng<D> rng_[2];
  Pick pick_[2];
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_PICK_SINK_INL_H_
