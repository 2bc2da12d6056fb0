// SPDX-License-Identifier: MIT
// Random choice of one tap of a filter; the weight of a tap is its probability. A number x, uniform in [0, 1), is below
// a weight w with probability w, and never below a weight of 0.

#if defined(SHD_TEXTURE_PICK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_PICK_INL_H_
#undef SHD_TEXTURE_PICK_INL_H_
#else
#define SHD_TEXTURE_PICK_INL_H_
#endif

#include <hwy/highway.h>

#include "simd/round-inl.h"
#include "texture/filter/cubic-inl.h"
#include "texture/store/level-inl.h"
#include "texture/stream.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::RoundDown;

/// The chosen tap along one axis.
template <class D>
struct Pick {
  Ints<D> index;
  MaskOf<D> in;  // false = border colour
};

/// Picks one of the two taps of linear filtering at a reduced coordinate.
template <class D>
HWY_INLINE Pick<D> PickLinear(D d, shd_wrap wrap, hn::Vec<D> reduced, const AxisSize<D>& size, hn::Vec<D> x) {
  const hn::RebindToSigned<D> di;
  const LinearTaps<D> taps = WrapLinear(d, wrap, reduced, size);
  const auto second = hn::Lt(x, taps.s);
  return {hn::IfThenElse(hn::RebindMask(di, second), taps.i1, taps.i0),
          hn::Or(hn::And(second, taps.in1), hn::AndNot(second, taps.in0))};
}

/// Picks one of the four taps of the cubic B-spline by the running sums of their weights. The weights times six are
/// (1 - s)^3, 3 s^3 - 6 s^2 + 4, 3 (1 - s)^3 - 6 (1 - s)^2 + 4 and s^3. At s = 0 the sum of the first three is exactly
/// 6, which 6 x never reaches, so the fourth tap with its weight of 0 is never picked.
template <class D>
HWY_INLINE Pick<D> PickCubic(D d, shd_wrap wrap, hn::Vec<D> reduced, const AxisSize<D>& size, hn::Vec<D> x) {
  using V = hn::Vec<D>;
  const V one = hn::Set(d, 1.0f), three = hn::Set(d, 3.0f), four = hn::Set(d, 4.0f), six = hn::Set(d, 6.0f);
  const CubicPoint<D> at = LocateCubic(d, wrap, reduced, size);
  const V r = one - at.s;
  const auto inner = [&](V t) { return (three * t - six) * (t * t) + four; };
  const V first = r * (r * r);
  const V second = first + inner(at.s);
  const V third = second + inner(r);
  const V scaled = x * six;
  V tap = at.second - one;
  for (const V sum : {first, second, third}) tap = tap + hn::IfThenElseZero(hn::Ge(scaled, sum), one);
  Pick<D> pick;
  pick.index = WrapCubicTap(d, wrap, tap, size, &pick.in);
  return pick;
}

/// Picks level floor(lod) or the next one, with the fraction of lod as the probability of the next.
template <class D>
HWY_INLINE hn::Vec<D> PickLevel(D d, const Texture& texture, hn::Vec<D> lod, hn::Vec<D> x) {
  const auto floor = RoundDown(lod);
  const auto next = hn::IfThenElseZero(hn::Lt(x, lod - floor), hn::Set(d, 1.0f));
  return hn::Min(floor + next, hn::Set(d, static_cast<float>(texture.level_count - 1)));
}

/// Emits the chosen texel of a lookup.
template <class D, class Sink>
HWY_INLINE void emit_pick(D d, const Level<D>& level, const Pick<D>& x, const Pick<D>& y, Sink& sink) {
  sink.texel(d, kStart | kNewLine, level, x.index, y.index, hn::And(x.in, y.in));
  sink.finish();
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_PICK_INL_H_
