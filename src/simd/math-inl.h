// SPDX-License-Identifier: MIT
// Elementary functions built from exactly rounded operations, with the same bits on every target.

#if defined(SHD_SIMD_MATH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_SIMD_MATH_INL_H_
#undef SHD_SIMD_MATH_INL_H_
#else
#define SHD_SIMD_MATH_INL_H_
#endif

#include <hwy/highway.h>
#include <limits>

#include "simd/integer-inl.h"
#include "simd/round-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::simd::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr float kInvPi = 0.318309886f;

/// log2((1 + s) / (1 - s)) / s by its series, with z = s^2 up to z^4.
template <class D, class V>
HWY_INLINE V AtanhSeries(D d, V z) {
  V p = hn::Set(d, 0.320598898f);          // 2 / (9 ln 2)
  p = p * z + hn::Set(d, 0.412198583f);    // 2 / (7 ln 2)
  p = p * z + hn::Set(d, 0.577078016f);    // 2 / (5 ln 2)
  p = p * z + hn::Set(d, 0.961796694f);    // 2 / (3 ln 2)
  return p * z + hn::Set(d, 2.88539008f);  // 2 / ln 2
}

/// 2^f by its series up to f^7.
template <class D, class V>
HWY_INLINE V ExpSeries(D d, V f) {
  V p = hn::Set(d, 1.52527338e-5f);  // ln(2)^7 / 7!
  p = p * f + hn::Set(d, 1.54035304e-4f);
  p = p * f + hn::Set(d, 1.33335581e-3f);
  p = p * f + hn::Set(d, 9.61812911e-3f);
  p = p * f + hn::Set(d, 5.55041087e-2f);
  p = p * f + hn::Set(d, 0.240226507f);
  p = p * f + hn::Set(d, 0.693147181f);
  return p * f + hn::Set(d, 1.0f);
}

/// x = 2^exponent m, with m in [sqrt(1/2), sqrt(2)), and log2(m), for normal x > 0. The series of 2 atanh((m-1)/(m+1))
/// goes up to s^9 (Abramowitz and Stegun 1964, 4.1.27); the next term is below 3e-10.
template <class D>
struct ReducedLog2 {
  hn::Vec<D> exponent, s, of_m_by_s;  // log2(m) = s of_m_by_s

  HWY_INLINE ReducedLog2(D d, hn::Vec<D> x) {
    const hn::RebindToSigned<D> di;
    const auto bits = hn::BitCast(di, x);
    const auto whole = hn::ShiftRight<23>(bits - hn::Set(di, 0x3f3504f3));
    const auto m = hn::BitCast(d, bits - hn::ShiftLeft<23>(whole)), one = hn::Set(d, 1.0f);
    exponent = hn::ConvertTo(d, whole);
    s = (m - one) / (m + one);
    of_m_by_s = AtanhSeries(d, s * s);
  }
};

/// log2(x) for normal x > 0: the bits of Log2() in half of its operations.
template <class D, class V>
HWY_INLINE V NormalLog2(D d, V x) {
  const ReducedLog2<D> r(d, x);
  return r.exponent + r.s * r.of_m_by_s;
}

/// log2(x). Relative error <= 4e-7 (measured over every positive float: 2.31e-7).
/// 0 and denormals below 2^-149: -inf; negative or NaN: NaN; +inf: +inf.
template <class D, class V>
HWY_INLINE V Log2(D d, V x) {
  const auto tiny = hn::Lt(x, hn::Set(d, 1.17549435e-38f));
  const ReducedLog2<D> r(d, hn::IfThenElse(tiny, x * hn::Set(d, 8388608.0f), x));
  V y = (r.exponent - hn::IfThenElseZero(tiny, hn::Set(d, 23.0f))) + r.s * r.of_m_by_s;

  const V infinity = hn::Inf(d);
  y = hn::IfThenElse(hn::Eq(x, infinity), infinity, y);
  y = hn::IfThenElse(hn::Eq(x, hn::Zero(d)), hn::Neg(infinity), y);
  // Negative numbers and NaN fail the comparison >= 0.
  return hn::IfThenElse(hn::Ge(x, hn::Zero(d)), y, hn::Set(d, std::numeric_limits<float>::quiet_NaN()));
}

/// 2^x. Relative error <= 2e-7 (measured over every float with a normal result: 9.7e-8); gradual underflow below
/// 2^-126, 0 below 2^-150; +inf from 128 on. NaN: NaN. Sum of the nearest integer and f, |f| <= 1/2; 2^f is its Taylor
/// series up to f^7.
template <class D, class V>
HWY_INLINE V Exp2(D d, V x) {
  const hn::RebindToSigned<D> di;
  const auto is_nan = hn::IsNaN(x);
  V t = hn::IfThenElse(is_nan, hn::Zero(d), x);
  t = hn::Min(hn::Max(t, hn::Set(d, -160.0f)), hn::Set(d, 129.0f));
  const V whole = RoundNearest(t);
  const V f = t - whole;
  const V p = ExpSeries(d, f);
  // 2^n as a product of two normal floats; only the last product rounds.
  const auto n = ToInt(whole);
  const auto half = hn::ShiftRight<1>(n);
  const auto bias = hn::Set(di, 127);
  const V a = hn::BitCast(d, hn::ShiftLeft<23>(half + bias));
  const V b = hn::BitCast(d, hn::ShiftLeft<23>(n - half + bias));
  const V y = p * a * b;
  return hn::IfThenElse(is_nan, x, y);
}

/// x^y for x >= 0 and finite y >= 0, with 0^0 = 1. Relative error <= |y log2 x| * 4e-7 + 3e-7 (measured over 3e7 pairs:
/// 0.43 of that); 0 where the result is below 2^-150. Negative or NaN x: NaN unless y = 0.
template <class D, class V>
HWY_INLINE V Pow(D d, V x, V y) {
  const V power = Exp2(d, y * Log2(d, x));
  return hn::IfThenElse(hn::Eq(y, hn::Zero(d)), hn::Set(d, 1.0f), power);
}

/// Pow() for x in 0..1, in fewer steps and without small results: bit-equal, except 0 where x^y is below 2^-96 or x is
/// below 2^-126. Negative or NaN x: 0, also for y = 0. So the product with a factor above 2^-30, as falloffs and
/// intensities are, is not denormal: processors take over 100 cycles for such a product.
template <class D, class V>
HWY_INLINE V UnitPow(D d, V x, V y) {
  const hn::RebindToSigned<D> di;
  const auto bits = hn::BitCast(di, x);
  const auto exponent = hn::ShiftRight<23>(bits - hn::Set(di, 0x3f3504f3));
  const V m = hn::BitCast(d, bits - hn::ShiftLeft<23>(exponent));
  const V one = hn::Set(d, 1.0f);
  const V s = (m - one) / (m + one);
  const V power = y * (hn::ConvertTo(d, exponent) + s * AtanhSeries(d, s * s));

  const V t = hn::Max(power, hn::Set(d, -96.0f));
  const V whole = RoundNearest(t);
  const V f = t - whole;
  const auto scale = hn::ShiftLeft<23>(ToInt(whole) + hn::Set(di, 127));
  const V result = ExpSeries(d, f) * hn::BitCast(d, scale);
  // The power 0 of any x gives exactly 1.
  const V least = hn::IfThenZeroElse(hn::Eq(y, hn::Zero(d)), hn::Set(d, 0x1p-126f));
  return hn::IfThenElseZero(hn::And(hn::Ge(power, hn::Set(d, -96.0f)), hn::Ge(x, least)), result);
}

/// sin(pi x) by its series up to the eleventh power. Error <= 3e-7 (measured over 2e7 points: 1.8e-7). The period
/// is removed exactly; integers give 0. x is finite.
template <class D, class V>
HWY_INLINE V SinPi(D d, V x) {
  const V two = hn::Set(d, 2.0f), half = hn::Set(d, 0.5f);
  const V r = x - two * RoundNearest(x * half);  // in [-1, 1]
  const V mirrored = hn::CopySign(hn::Set(d, 1.0f), r) - r;
  const V t = hn::IfThenElse(hn::Gt(hn::Abs(r), half), mirrored, r), z = t * t;
  V p = hn::Set(d, -7.37043094e-3f);  // -pi^11 / 11!
  p = p * z + hn::Set(d, 8.21458866e-2f);
  p = p * z + hn::Set(d, -0.599264529f);
  p = p * z + hn::Set(d, 2.55016404f);
  p = p * z + hn::Set(d, -5.16771278f);
  return t * (p * z + hn::Set(d, 3.14159265f));
}

/// cos(pi x), with the error of SinPi(). x is finite.
template <class D, class V>
HWY_INLINE V CosPi(D d, V x) {
  const V r = x - hn::Set(d, 2.0f) * RoundNearest(x * hn::Set(d, 0.5f));
  return SinPi(d, hn::Set(d, 0.5f) - hn::Abs(r));
}

}  // namespace shd::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_SIMD_MATH_INL_H_
