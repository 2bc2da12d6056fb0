// SPDX-License-Identifier: MIT
#if defined(SHD_SIMD_TAIL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_SIMD_TAIL_INL_H_
#undef SHD_SIMD_TAIL_INL_H_
#else
#define SHD_SIMD_TAIL_INL_H_
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace shd::simd::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Whether loads and stores with a mask leave memory beyond the mask alone, so that it need not exist.
constexpr bool kMasksMemory = HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3;

/// Writes up to `count` lanes. For few lanes, a call of memcpy would take longer than these stores.
template <class D, class V>
HWY_INLINE void StoreFirst(D d, V value, size_t count, hn::TFromD<D>* to) {
  if (HWY_LIKELY(count >= hn::Lanes(d))) return hn::StoreU(value, d, to);
  if constexpr (kMasksMemory) return hn::BlendedStore(value, hn::FirstN(d, count), d, to);
  if (count == 0) return;
  to[0] = hn::GetLane(value);
  if (count == 1) return;
  alignas(64) hn::TFromD<D> lanes[hn::MaxLanes(D())];
  hn::Store(value, d, lanes);
  for (size_t i = 1; i < hn::MaxLanes(D()) && i < count; ++i) to[i] = lanes[i];
}

/// Reads `count` lanes, at least one. Later lanes are copies of the last one.
template <class D>
HWY_INLINE hn::Vec<D> LoadFirst(D d, const hn::TFromD<D>* from, size_t count) {
  const auto last = hn::Set(d, from[count - 1]);
  if (count == 1) return last;
  if constexpr (kMasksMemory) {
    const auto read = hn::FirstN(d, count);
    return hn::IfThenElse(read, hn::MaskedLoad(read, d, from), last);
  }
  alignas(64) hn::TFromD<D> lanes[hn::MaxLanes(D())];
  for (size_t i = 0; i < hn::MaxLanes(D()); ++i) lanes[i] = from[i < count ? i : count - 1];
  return hn::Load(d, lanes);
}

}  // namespace shd::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_SIMD_TAIL_INL_H_
