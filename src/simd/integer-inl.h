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

/// Returns (a b + 2^14) >> 15 of each pair of 16-bit halves in 0..32767.
template <class V>
HWY_INLINE V RoundedProducts(V a, V b) {
#if HWY_TARGET == HWY_AVX3
  return V{_mm512_mulhrs_epi16(a.raw, b.raw)};
#elif HWY_TARGET == HWY_AVX2
  return V{_mm256_mulhrs_epi16(a.raw, b.raw)};
#elif HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_SSSE3
  return V{_mm_mulhrs_epi16(a.raw, b.raw)};
#else
  const hn::DFromV<V> d;
  const auto half = hn::Set(d, 1 << 14), mask = hn::Set(d, 0xffff);
  const auto low = hn::ShiftRight<15>((a & mask) * (b & mask) + half);
  return low | hn::ShiftLeft<16>(hn::ShiftRight<15>(hn::ShiftRight<16>(a) * hn::ShiftRight<16>(b) + half));
#endif
}

/// Returns a + ((b - a) s + 2^14 >> 15) of each pair of 16-bit halves in 0..32767.
template <class V>
HWY_INLINE V MixHalves(V a, V b, V s) {
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_SSSE3
  const hn::DFromV<V> d;
  const hn::Repartition<int16_t, hn::DFromV<V>> half;  // differences have a sign
  const auto by_half = [&](V x) { return hn::BitCast(half, x); };
  const auto product = RoundedProducts(hn::BitCast(d, hn::Sub(by_half(b), by_half(a))), s);
  return hn::BitCast(d, hn::Add(by_half(a), by_half(product)));
#else
  const hn::DFromV<V> d;
  const auto one_half = hn::Set(d, 1 << 14), mask = hn::Set(d, 0xffff);
  const auto mix = [&](V from, V to, V by) { return from + hn::ShiftRight<15>((to - from) * by + one_half); };
  const auto low = mix(a & mask, b & mask, s & mask);
  return low | hn::ShiftLeft<16>(mix(hn::ShiftRight<16>(a), hn::ShiftRight<16>(b), hn::ShiftRight<16>(s)));
#endif
}

/// Copies the low half of each 32-bit lane into the high half.
template <class V>
HWY_INLINE V TwiceLow(V x) {
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_SSSE3
  const hn::Repartition<uint8_t, hn::DFromV<V>> bytes;
  alignas(16) static constexpr uint8_t kPlaces[16] = {0, 1, 0, 1, 4, 5, 4, 5, 8, 9, 8, 9, 12, 13, 12, 13};
  return hn::BitCast(hn::DFromV<V>(), hn::TableLookupBytes(hn::BitCast(bytes, x), hn::LoadDup128(bytes, kPlaces)));
#else
  return hn::ShiftLeft<16>(x) | (x & hn::Set(hn::DFromV<V>(), 0xffff));
#endif
}

/// Returns floats below 2^31 truncated to integers. hn::ConvertTo() takes four more operations on x86 to saturate.
template <class V, class DI = hn::RebindToSigned<hn::DFromV<V>>>
HWY_INLINE hn::Vec<DI> ToInt(V x) {
#if HWY_TARGET == HWY_AVX3
  if constexpr (hn::MaxLanes(DI()) == 16) return hn::Vec<DI>{_mm512_cvttps_epi32(x.raw)};
#endif
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX2
  if constexpr (hn::MaxLanes(DI()) == 8) return hn::Vec<DI>{_mm256_cvttps_epi32(x.raw)};
#endif
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_SSSE3
  if constexpr (hn::MaxLanes(DI()) <= 4) return hn::Vec<DI>{_mm_cvttps_epi32(x.raw)};
#endif
  return hn::ConvertTo(DI(), x);
}

/// Returns floats in -2^31..2^31 - 129 rounded to the nearest integers, ties to even.
template <class V, class DI = hn::RebindToSigned<hn::DFromV<V>>>
HWY_INLINE hn::Vec<DI> ToNearestInt(V x) {
#if HWY_TARGET == HWY_AVX3
  if constexpr (hn::MaxLanes(DI()) == 16) return hn::Vec<DI>{_mm512_cvtps_epi32(x.raw)};
#endif
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX2
  if constexpr (hn::MaxLanes(DI()) == 8) return hn::Vec<DI>{_mm256_cvtps_epi32(x.raw)};
#endif
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_SSSE3
  if constexpr (hn::MaxLanes(DI()) <= 4) return hn::Vec<DI>{_mm_cvtps_epi32(x.raw)};
#endif
  return hn::NearestInt(x);
}

}  // namespace shd::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_SIMD_INTEGER_INL_H_
