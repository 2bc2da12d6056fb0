// SPDX-License-Identifier: MIT
// Texel coordinates and wrapping of one axis (Vulkan 1.3 specification, "Texel Coordinate Systems" and "Wrapping
// Operation"). Coordinates are reduced as floats, so that no finite coordinate leaves the range of an int.

#if defined(SHD_TEXTURE_WRAP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_WRAP_INL_H_
#undef SHD_TEXTURE_WRAP_INL_H_
#else
#define SHD_TEXTURE_WRAP_INL_H_
#endif

#include <hwy/highway.h>

#include <shd/wrap.h>

#include "simd/integer-inl.h"
#include "simd/kernel_part.h"
#include "simd/round-inl.h"
#include "texture/store/level-inl.h"
#include "texture/texture.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::RoundDown;
using simd::HWY_NAMESPACE::ToInt;

/// Reduces a finite coordinate: the part of wrapping that does not depend on the level. For repeat and mirror, the
/// result is the fraction of the period (1 or 2) in [0, 1]. A tiny negative coordinate gives 1, which callers must
/// accept. For other wraps, the result is the coordinate.
template <class D, class V>
HWY_INLINE V ReduceCoordinate(D d, shd_wrap wrap, V u) {
  if (wrap == SHD_WRAP_REPEAT) return u - RoundDown(u);
  if (wrap == SHD_WRAP_MIRROR) {
    const V half = u * hn::Set(d, 0.5f);
    return half - RoundDown(half);
  }
  return u;
}

/// The two taps of linear filtering along one axis. Their weights are 1 - s and s.
template <class D>
struct LinearTaps {
  hn::Vec<D> s;        // [0, 1)
  hn::Vec<D> rate;     // ds/du: the size, or 0 where the coordinate is clamped
  Ints<D> i0, i1;      // 0..size - 1
  MaskOf<D> in0, in1;  // false = border colour, for SHD_WRAP_BORDER only
};

/// Folds an index of the mirrored period, -1..2 size, into 0..size - 1.
template <class DI, class VI>
HWY_INLINE VI Fold(DI di, VI i, VI size) {
  const VI last = size + size - hn::Set(di, 1);
  return hn::Max(hn::Zero(di), hn::Min(i, last - i));
}

/// Mirrors an index at 0 and clamps it to 0..size - 1.
template <class DI, class VI>
HWY_INLINE VI FoldOnce(DI di, VI i, VI size) {
  return hn::Min(i ^ hn::BroadcastSignBit(i), size - hn::Set(di, 1));
}

/// Clamps an index to 0..size - 1. Lanes of `in` are set where the index was in this range.
template <class D, class VI>
HWY_INLINE VI ClampBorder(D d, VI i, VI size, MaskOf<D>* in) {
  const hn::RebindToSigned<D> di;
  const VI clamped = hn::Min(hn::Max(i, hn::Zero(di)), size - hn::Set(di, 1));
  *in = hn::RebindMask(d, hn::Eq(i, clamped));
  return clamped;
}

/// Returns the linear taps of a reduced coordinate, around u * size - 1/2.
template <class D>
SHD_KERNEL_PART LinearTaps<D> WrapLinear(D d, shd_wrap wrap, hn::Vec<D> reduced, const AxisSize<D>& size) {
  using V = hn::Vec<D>;
  const hn::RebindToSigned<D> di;
  const auto one = hn::Set(di, 1);
  const V half = hn::Set(d, 0.5f);
  const V below_one = hn::Set(d, 0x1.fffffep-1f);
  LinearTaps<D> taps;
  taps.in0 = taps.in1 = hn::Eq(half, half);
  taps.rate = size.real;
  V x = reduced * size.real;
  switch (wrap) {
    case SHD_WRAP_REPEAT: {
      x = x - half;
      const V floor = RoundDown(x);
      taps.s = hn::Min(x - floor, below_one);
      const auto i = ToInt(floor);  // -1..size - 1
      taps.i0 = i + (size.whole & hn::BroadcastSignBit(i));
      const auto next = i + one;
      taps.i1 = hn::IfThenZeroElse(hn::Eq(next, size.whole), next);
      return taps;
    }
    case SHD_WRAP_MIRROR: {
      x = x + x - half;
      const V floor = RoundDown(x);
      taps.s = hn::Min(x - floor, below_one);
      const auto i = ToInt(floor);  // -1..2 size - 1
      taps.i0 = Fold(di, i, size.whole);
      taps.i1 = Fold(di, i + one, size.whole);
      return taps;
    }
    case SHD_WRAP_BORDER: {
      const V free = x - half;
      x = hn::Min(hn::Max(free, hn::Set(d, -1.0f)), size.real);
      taps.rate = hn::IfThenElseZero(hn::Eq(x, free), size.real);
      const V floor = RoundDown(x);
      taps.s = hn::Min(x - floor, below_one);
      const auto i = ToInt(floor);  // -1..size
      taps.i0 = ClampBorder(d, i, size.whole, &taps.in0);
      taps.i1 = ClampBorder(d, i + one, size.whole, &taps.in1);
      return taps;
    }
    case SHD_WRAP_MIRROR_ONCE: {
      const V free = x - half;
      x = hn::Min(hn::Max(free, hn::Neg(size.real)), size.real);
      taps.rate = hn::IfThenElseZero(hn::Eq(x, free), size.real);
      const V floor = RoundDown(x);
      taps.s = hn::Min(x - floor, below_one);
      const auto i = ToInt(floor);  // -size..size
      taps.i0 = FoldOnce(di, i, size.whole);
      taps.i1 = FoldOnce(di, i + one, size.whole);
      return taps;
    }
    default: {
      // Outside, both taps are the edge texel. Clamp x, which gives this texel the weight 1.
      const V free = x - half, last = size.real - hn::Set(d, 1.0f);
      x = hn::Min(hn::Max(free, hn::Zero(d)), last);
      taps.rate = hn::IfThenElseZero(hn::Eq(x, free), size.real);
      const V floor = RoundDown(x);
      taps.s = x - floor;
      taps.i0 = ToInt(floor);
      taps.i1 = hn::Min(taps.i0 + one, size.whole - one);
      return taps;
    }
  }
}

/// The four taps of cubic filtering along one axis. The point lies between the second and the third tap.
template <class D>
struct CubicTaps {
  hn::Vec<D> s;     // fraction of the way from the second to the third tap, [0, 1)
  hn::Vec<D> rate;  // ds/du
  Ints<D> index[4];
  MaskOf<D> in[4];  // false = border colour
};

/// Wraps an integer-valued float, |i| <= 2 size + 4, to an index.
template <class D>
HWY_INLINE Ints<D> WrapWhole(D d, shd_wrap wrap, hn::Vec<D> i, const AxisSize<D>& size, MaskOf<D>* in) {
  using V = hn::Vec<D>;
  const hn::RebindToSigned<D> di;
  *in = hn::Eq(i, i);
  switch (wrap) {
    case SHD_WRAP_REPEAT: {
      const V periods = RoundDown(i / size.real);
      return ToInt(i - periods * size.real);
    }
    case SHD_WRAP_MIRROR: {
      const V period = size.real + size.real;
      const V periods = RoundDown(i / period);
      return Fold(di, ToInt(i - periods * period), size.whole);
    }
    case SHD_WRAP_MIRROR_ONCE: return FoldOnce(di, ToInt(i), size.whole);
    default: return ClampBorder(d, ToInt(i), size.whole, in);
  }
}

/// Position of cubic filtering along one axis. `second` is the index of the second tap before wrapping, an
/// integer-valued float.
template <class D>
struct CubicPoint {
  hn::Vec<D> second, s, rate;  // s, rate: as in CubicTaps
};

/// Returns the cubic position of a reduced coordinate, at u * size - 1/2.
template <class D>
SHD_KERNEL_PART CubicPoint<D> LocateCubic(D d, shd_wrap wrap, hn::Vec<D> reduced, const AxisSize<D>& size) {
  using V = hn::Vec<D>;
  const V half = hn::Set(d, 0.5f), two = hn::Set(d, 2.0f);
  const V scaled = reduced * size.real;
  V x = (wrap == SHD_WRAP_MIRROR ? scaled + scaled : scaled) - half;
  CubicPoint<D> point;
  point.rate = size.real;
  if (wrap == SHD_WRAP_CLAMP || wrap == SHD_WRAP_BORDER || wrap == SHD_WRAP_MIRROR_ONCE) {
    // Beyond this limit all taps are the same texel.
    const V free = x, outside = wrap == SHD_WRAP_MIRROR_ONCE ? size.real + two : two;
    x = hn::Min(hn::Max(free, hn::Neg(outside)), size.real + two);
    point.rate = hn::IfThenElseZero(hn::Eq(x, free), size.real);
  }
  point.second = RoundDown(x);
  point.s = hn::Min(x - point.second, hn::Set(d, 0x1.fffffep-1f));
  return point;
}

/// Wraps the index of a cubic tap, an integer-valued float. Lanes of `in` are clear for SHD_WRAP_BORDER only.
template <class D>
HWY_INLINE Ints<D> WrapCubicTap(D d, shd_wrap wrap, hn::Vec<D> i, const AxisSize<D>& size, MaskOf<D>* in) {
  const Ints<D> index = WrapWhole(d, wrap, i, size, in);
  if (wrap != SHD_WRAP_BORDER) *in = hn::Eq(i, i);
  return index;
}

/// Returns the cubic taps of a reduced coordinate, around u * size - 1/2.
template <class D>
SHD_KERNEL_PART CubicTaps<D> WrapCubic(D d, shd_wrap wrap, hn::Vec<D> reduced, const AxisSize<D>& size) {
  const CubicPoint<D> point = LocateCubic(d, wrap, reduced, size);
  CubicTaps<D> taps;
  taps.s = point.s;
  taps.rate = point.rate;
  for (int k = 0; k < 4; ++k) {
    const auto i = point.second + hn::Set(d, static_cast<float>(k - 1));
    taps.index[k] = WrapCubicTap(d, wrap, i, size, &taps.in[k]);
  }
  return taps;
}

/// Returns the texel that contains a reduced coordinate.
template <class D>
SHD_KERNEL_PART Ints<D> WrapNearest(D d, shd_wrap wrap, hn::Vec<D> reduced, const AxisSize<D>& size, MaskOf<D>* in) {
  using V = hn::Vec<D>;
  const hn::RebindToSigned<D> di;
  const V x = reduced * size.real;
  const V last = size.real - hn::Set(d, 1.0f);
  *in = hn::Eq(last, last);
  switch (wrap) {
    case SHD_WRAP_REPEAT: return ToInt(hn::Min(x, last));
    case SHD_WRAP_MIRROR: return Fold(di, ToInt(x + x), size.whole);
    case SHD_WRAP_BORDER: {
      const V clamped = hn::Min(hn::Max(RoundDown(x), hn::Set(d, -1.0f)), size.real);
      return ClampBorder(d, ToInt(clamped), size.whole, in);
    }
    case SHD_WRAP_MIRROR_ONCE: {
      const V clamped = hn::Min(hn::Max(RoundDown(x), hn::Neg(size.real)), last);
      return FoldOnce(di, ToInt(clamped), size.whole);
    }
    default: return ToInt(hn::Min(hn::Max(x, hn::Zero(d)), last));
  }
}

/// Rounds weights to 8 bits, as texture units do. A weight of 1 becomes weight 0 with the other tap as the first.
template <class D>
HWY_INLINE void RoundWeights(D d, LinearTaps<D>* taps) {
  const hn::RebindToSigned<D> di;
  const auto steps = hn::Set(d, 256.0f);
  const auto s = RoundDown(taps->s * steps + hn::Set(d, 0.5f)) / steps;
  const auto next = hn::Eq(s, hn::Set(d, 1.0f));
  taps->s = hn::IfThenZeroElse(next, s);
  taps->i0 = hn::IfThenElse(hn::RebindMask(di, next), taps->i1, taps->i0);
  taps->in0 = hn::Or(hn::And(next, taps->in1), hn::AndNot(next, taps->in0));
}

/// Makes weights smooth: s becomes 3 s^2 - 2 s^3.
template <class D>
HWY_INLINE void SmoothWeights(D d, LinearTaps<D>* taps) {
  const auto s = taps->s, one = hn::Set(d, 1.0f);
  taps->rate = taps->rate * (hn::Set(d, 6.0f) * s * (one - s));
  taps->s = hn::Min(s * s * (hn::Set(d, 3.0f) - (s + s)), hn::Set(d, 0x1.fffffep-1f));
}

/// Changes the linear weights of both axes to others.
template <class D>
HWY_INLINE void ChangeWeights(D d, Weights weights, LinearTaps<D>* x, LinearTaps<D>* y) {
  if (weights == Weights::kHermite) {
    SmoothWeights(d, x);
    SmoothWeights(d, y);
  } else {
    RoundWeights(d, x);
    RoundWeights(d, y);
  }
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_WRAP_INL_H_
