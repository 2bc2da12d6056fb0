// SPDX-License-Identifier: MIT
// Rounding to whole numbers with the signs of IEEE 754: a zero keeps the sign of its argument.
#if defined(SHD_SIMD_ROUND_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_SIMD_ROUND_INL_H_
#undef SHD_SIMD_ROUND_INL_H_
#else
#define SHD_SIMD_ROUND_INL_H_
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace shd::simd::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Targets that have no instruction to round: Highway (1.0.3 and 1.2) gives +0 for -0 there. The bit is HWY_SSE2, which
// is new after Highway 1.0.3.
constexpr bool kLosesSign =
    HWY_TARGET == HWY_SCALAR || HWY_TARGET == HWY_EMU128 || HWY_TARGET == HWY_SSSE3 || HWY_TARGET == (1LL << 14);

template <class V>
HWY_INLINE V KeepSign(V rounded, V v) {
  if constexpr (kLosesSign) return hn::CopySign(rounded, v);
  return rounded;
}

/// The largest whole number that is not above v.
template <class V>
HWY_INLINE V RoundDown(V v) {
  return KeepSign(hn::Floor(v), v);
}

/// The smallest whole number that is not below v.
template <class V>
HWY_INLINE V RoundUp(V v) {
  return KeepSign(hn::Ceil(v), v);
}

/// The nearest whole number, the even one of two.
template <class V>
HWY_INLINE V RoundNearest(V v) {
  return KeepSign(hn::Round(v), v);
}

}  // namespace shd::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_SIMD_ROUND_INL_H_
