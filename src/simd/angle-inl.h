// SPDX-License-Identifier: MIT
// Angles of vectors, sines and cosines from exactly rounded operations, with the same bits on every target.

#if defined(SHD_SIMD_ANGLE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_SIMD_ANGLE_INL_H_
#undef SHD_SIMD_ANGLE_INL_H_
#else
#define SHD_SIMD_ANGLE_INL_H_
#endif

#include <cmath>

#include <hwy/highway.h>

#include "data/trig.h"
#include "simd/integer-inl.h"
#include "simd/round-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::simd::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Angle of the vector (x, y) in [-pi, pi] [rad]; 0 for the zero vector. Both zeros count as positive, so that
/// (-1, -0) has the angle pi. Relative error <= 3e-7 for components below 1e38 (measured: 2.3e-7). The
/// angle modulo 45 degrees is in +-pi / 8, where the arctangent is an odd polynomial of degree 9 with the least largest
/// error (Remez): 2e-8. One lane of doubles has the error of data::angle_of().
template <class D, class V>
HWY_INLINE V Atan2(D d, V y, V x) {
  if constexpr (sizeof(hn::TFromD<D>) == sizeof(double)) {
    const double side = hn::GetLane(y), angle = data::angle_of(std::fabs(side), hn::GetLane(x));
    return hn::Set(d, side < 0.0 ? -angle : angle);
  }
  const V zero = hn::Zero(d), a = hn::Abs(y), b = hn::Abs(x);
  const V low = hn::Min(a, b), high = hn::Max(a, b);
  const auto diagonal = hn::Gt(low, high * hn::Set(d, 0.414213562f));
  const V above = hn::IfThenElse(diagonal, low - high, low), below = high + hn::IfThenElseZero(diagonal, low);
  const V q = hn::IfThenZeroElse(hn::Eq(high, zero), above / below), z = q * q;
  V p = hn::Set(d, 8.06030884e-2f);
  p = p * z + hn::Set(d, -0.138798499f);
  p = p * z + hn::Set(d, 0.199779261f);
  p = p * z + hn::Set(d, -0.333329553f);
  V angle = q + q * z * p;
  angle = angle + hn::IfThenElseZero(diagonal, hn::Set(d, 0.785398163f));
  angle = hn::IfThenElse(hn::Gt(a, b), hn::Set(d, 1.57079633f) - angle, angle);
  angle = hn::IfThenElse(hn::Lt(x, zero), hn::Set(d, 3.14159265f) - angle, angle);
  return hn::IfThenElse(hn::Lt(y, zero), hn::Neg(angle), angle);
}

template <class V>
struct SineCosine {
  V sine, cosine;
};

/// sin(pi x) and cos(pi x) for |x| < 2^22. |error| <= 1.5e-7 (measured: 8e-8); multiples of 1/2 are exact. x minus the
/// nearest multiple of 1/2 is exact and in +-1/4, where both are polynomials with the least largest error (Remez).
template <class D, class V>
HWY_INLINE SineCosine<V> SineCosinePi(D d, V x) {
  const V halves = RoundNearest(x + x), f = x - halves * hn::Set(d, 0.5f), z = f * f;
  V sine = hn::Set(d, -0.589479660f);
  sine = sine * z + hn::Set(d, 2.54981053f);
  sine = sine * z + hn::Set(d, -5.16770915f);
  sine = (sine * z + hn::Set(d, 3.14159265f)) * f;
  V cosine = hn::Set(d, 0.231429548f);
  cosine = cosine * z + hn::Set(d, -1.33505846f);
  cosine = cosine * z + hn::Set(d, 4.05870790f);
  cosine = cosine * z + hn::Set(d, -4.93480217f);
  cosine = cosine * z + hn::Set(d, 1.0f);
  const auto quarter = ToInt(halves);
  const hn::RebindToSigned<D> di;
  const auto one = hn::Set(di, 1), two = hn::Set(di, 2);
  const auto odd = hn::RebindMask(d, hn::Eq(quarter & one, one));
  const auto sine_sign = hn::BitCast(d, hn::ShiftLeft<30>(quarter & two));
  const auto cosine_sign = hn::BitCast(d, hn::ShiftLeft<30>((quarter + one) & two));
  return {hn::Xor(hn::IfThenElse(odd, cosine, sine), sine_sign),
          hn::Xor(hn::IfThenElse(odd, sine, cosine), cosine_sign)};
}

}  // namespace shd::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_SIMD_ANGLE_INL_H_
