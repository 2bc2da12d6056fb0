// SPDX-License-Identifier: MIT
// Hashes of 32-bit words: pseudo-random bits without state.

#if defined(SHD_SIMD_HASH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_SIMD_HASH_INL_H_
#undef SHD_SIMD_HASH_INL_H_
#else
#define SHD_SIMD_HASH_INL_H_
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace shd::simd::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Step of a Weyl sequence: 2^32 divided by the golden ratio.
constexpr uint32_t kWeylStep = 0x9e3779b9u;

/// Hashes 32-bit words by a bijection of xor-shifts and multiplications. Wellons found its constants by search
/// ("Prospecting for Hash Functions", 2018, lowbias32).
template <class DU, class VU>
HWY_INLINE VU MixBits(DU du, VU x) {
  x = x ^ hn::ShiftRight<16>(x);
  x = x * hn::Set(du, 0x7feb352du);
  x = x ^ hn::ShiftRight<15>(x);
  x = x * hn::Set(du, 0x846ca68bu);
  return x ^ hn::ShiftRight<16>(x);
}

}  // namespace shd::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_SIMD_HASH_INL_H_
