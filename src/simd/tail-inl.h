// SPDX-License-Identifier: MIT
#if defined(SHD_SIMD_TAIL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_SIMD_TAIL_INL_H_
#undef SHD_SIMD_TAIL_INL_H_
#else
#define SHD_SIMD_TAIL_INL_H_
#endif

#include <cstring>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace shd::simd::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Writes up to `count` lanes.
template <class D>
HWY_INLINE void StoreFirst(D d, hn::Vec<D> value, size_t count, float* to) {
  if (HWY_LIKELY(count >= hn::Lanes(d))) return hn::StoreU(value, d, to);
  alignas(64) float lanes[hn::MaxLanes(D())];
  hn::Store(value, d, lanes);
  std::memcpy(to, lanes, count * sizeof(float));
}

}  // namespace shd::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_SIMD_TAIL_INL_H_
