// SPDX-License-Identifier: MIT
// The square wave of stripes and checkers, and its average over pixels.

#if defined(SHD_PROCEDURAL_WAVE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_PROCEDURAL_WAVE_INL_H_
#undef SHD_PROCEDURAL_WAVE_INL_H_
#else
#define SHD_PROCEDURAL_WAVE_INL_H_
#endif

#include <hwy/highway.h>

#include "procedural/batch-inl.h"
#include "simd/round-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::procedural::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::RoundDown;

/// Narrower pixels see one point of a wave.
constexpr float kNarrowest = 0x1p-12f;

/// A derivative, limited to finite values.
template <class D, class V>
HWY_INLINE V LimitSlope(D d, V slope) {
  const V limit = hn::Set(d, 1e30f);
  return hn::Max(hn::Min(slope, limit), hn::Neg(limit));
}

template <class V>
struct Wave {
  V value, slope;
  hn::Mask<hn::DFromV<V>> is_sharp;  // whether the value is that of a point
};

/// x modulo 2, in [0, 2]; exact, except that tiny negative x give 2. 0 for infinite x.
template <class D, class V>
HWY_INLINE V ModuloTwo(D d, V x) {
  const V half = x * hn::Set(d, 0.5f);
  const V fraction = half - RoundDown(half);
  return hn::IfThenElseZero(hn::Eq(fraction, fraction), fraction + fraction);
}

/// 1 for x modulo 2 in [0, 1), otherwise -1; tiny negative x are before the end of a period.
template <class D, class V>
HWY_INLINE V WaveSign(D d, V x) {
  const V one = hn::Set(d, 1.0f);
  return hn::IfThenElse(hn::Lt(ModuloTwo(d, x), one), one, hn::Neg(one));
}

/// Integral of WaveSign from 0 to x: a triangle wave.
template <class D, class V>
HWY_INLINE V WaveIntegral(D d, V x) {
  const V one = hn::Set(d, 1.0f);
  return one - hn::Abs(ModuloTwo(d, x) - one);
}

/// WaveSign averaged over [x - width / 2, x + width / 2].
template <bool kGradient, class D, class V>
HWY_INLINE Wave<V> SquareWave(D d, V x, V width) {
  const V zero = hn::Zero(d), half = hn::Set(d, 0.5f);
  Wave<V> out = {WaveSign(d, x), zero, hn::Lt(width, hn::Set(d, kNarrowest))};
  if (HWY_LIKELY(hn::AllTrue(d, out.is_sharp))) return out;
  // From the place in the period, the ends have the least rounding error.
  const V at = ModuloTwo(d, x), wide = hn::Min(hn::Max(width, hn::Set(d, kNarrowest)), hn::Set(d, 0x1p20f));
  const V begin = at - half * wide, end = at + half * wide;
  const V mean = (WaveIntegral(d, end) - WaveIntegral(d, begin)) / wide;
  out.value = hn::IfThenElse(out.is_sharp, out.value, hn::Max(hn::Min(mean, hn::Set(d, 1.0f)), hn::Set(d, -1.0f)));
  if constexpr (kGradient) {
    out.slope = hn::IfThenElse(out.is_sharp, zero, (WaveSign(d, end) - WaveSign(d, begin)) / wide);
  }
  return out;
}

}  // namespace shd::procedural::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_PROCEDURAL_WAVE_INL_H_
