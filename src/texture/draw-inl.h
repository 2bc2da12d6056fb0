// SPDX-License-Identifier: MIT
// One tap of a filter, drawn with its weights. A number x, uniform in [0, 1), is below a weight w with probability w,
// and never below 0.

#if defined(SHD_TEXTURE_DRAW_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_DRAW_INL_H_
#undef SHD_TEXTURE_DRAW_INL_H_
#else
#define SHD_TEXTURE_DRAW_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/cubic-inl.h"
#include "texture/filter-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// One tap along one axis.
template <class D>
struct Drawn {
  Ints<D> index;
  MaskOf<D> in;  // false = border colour
};

/// One of the two taps of linear filtering at a reduced coordinate.
template <class D>
HWY_INLINE Drawn<D> DrawLinear(D d, shd_wrap wrap, hn::Vec<D> reduced, const AxisSize<D>& size, hn::Vec<D> x) {
  const hn::RebindToSigned<D> di;
  const LinearTaps<D> taps = WrapLinear(d, wrap, reduced, size);
  const auto second = hn::Lt(x, taps.s);
  return {hn::IfThenElse(hn::RebindMask(di, second), taps.i1, taps.i0),
          hn::Or(hn::And(second, taps.in1), hn::AndNot(second, taps.in0))};
}

/// One of the four taps of the cubic B-spline, by the running sums of the weights: six times those are (1 - s)^3,
/// 3 s^3 - 6 s^2 + 4, 3 (1 - s)^3 - 6 (1 - s)^2 + 4 and s^3. At s = 0 the first three sum to 6 exactly, which 6 x never
/// reaches.
template <class D>
HWY_INLINE Drawn<D> DrawCubic(D d, shd_wrap wrap, hn::Vec<D> u, const AxisSize<D>& size, hn::Vec<D> x) {
  using V = hn::Vec<D>;
  const V one = hn::Set(d, 1.0f), three = hn::Set(d, 3.0f), four = hn::Set(d, 4.0f), six = hn::Set(d, 6.0f);
  const CubicPoint<D> at = LocateCubic(d, wrap, ReduceCoordinate(d, wrap, u), size);
  const V r = hn::Sub(one, at.s);
  const auto inner = [&](V t) { return hn::Add(hn::Mul(hn::Sub(hn::Mul(three, t), six), hn::Mul(t, t)), four); };
  const V first = hn::Mul(r, hn::Mul(r, r));
  const V second = hn::Add(first, inner(at.s));
  const V third = hn::Add(second, inner(r));
  const V scaled = hn::Mul(x, six);
  V tap = hn::Sub(at.second, one);
  for (const V sum : {first, second, third}) tap = hn::Add(tap, hn::IfThenElseZero(hn::Ge(scaled, sum), one));
  Drawn<D> drawn;
  drawn.index = WrapCubicTap(d, wrap, tap, size, &drawn.in);
  return drawn;
}

/// Of the levels floor(lod) and the next, one by the fraction.
template <class D>
HWY_INLINE Level<D> DrawLevel(D d, const Texture& texture, Ints<D> first_texel, hn::Vec<D> lod, hn::Vec<D> x) {
  const auto floor = hn::Floor(lod);
  const auto next = hn::IfThenElseZero(hn::Lt(x, hn::Sub(lod, floor)), hn::Set(d, 1.0f));
  const auto last = hn::Set(d, static_cast<float>(texture.level_count - 1));
  return LevelAt(d, texture, first_texel, hn::Min(hn::Add(floor, next), last));
}

template <class F, bool kBorder, class D>
HWY_INLINE void StoreDrawn(D d, const Texture& texture, const Sampler& sampler, const Level<D>& level,
                           const Drawn<D>& x, const Drawn<D>& y, const Texels& out, size_t i) {
  const auto texel = F::fetch(d, texture, hn::Add(RowIndex(d, level, y.index), x.index));
  StoreChannels<F, kBorder>(d, TapValue<F, kBorder, D>{texel, hn::And(x.in, y.in), sampler}, out, i);
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_DRAW_INL_H_
