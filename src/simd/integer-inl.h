// SPDX-License-Identifier: MIT
#if defined(SHD_SIMD_INTEGER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_SIMD_INTEGER_INL_H_
#undef SHD_SIMD_INTEGER_INL_H_
#else
#define SHD_SIMD_INTEGER_INL_H_
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace shd::simd::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Returns a.low b.low + a.high b.high of the signed 16-bit halves of each 32-bit lane, modulo 2^32.
template <class V>
HWY_INLINE V PairDot(V a, V b) {
#if HWY_TARGET == HWY_AVX3
  return V{_mm512_madd_epi16(a.raw, b.raw)};
#elif HWY_TARGET == HWY_AVX2
  return V{_mm256_madd_epi16(a.raw, b.raw)};
#elif HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_SSSE3
  return V{_mm_madd_epi16(a.raw, b.raw)};
#else
  const auto low = [](V pair) { return hn::ShiftRight<16>(hn::ShiftLeft<16>(pair)); };
  return low(a) * low(b) + hn::ShiftRight<16>(a) * hn::ShiftRight<16>(b);
#endif
}

/// Returns the products of integers in 0..32767. x86 multiplies 16-bit integers faster than 32-bit ones.
template <class V>
HWY_INLINE V ShortProduct(V a, V b) {
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_SSSE3
  return PairDot(a, b);
#else
  return a * b;
#endif
}

}  // namespace shd::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_SIMD_INTEGER_INL_H_
