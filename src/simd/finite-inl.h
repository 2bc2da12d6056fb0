// SPDX-License-Identifier: MIT
// Tests for infinite values and NaN.

#if defined(SHD_SIMD_FINITE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_SIMD_FINITE_INL_H_
#undef SHD_SIMD_FINITE_INL_H_
#else
#define SHD_SIMD_FINITE_INL_H_
#endif

#include <hwy/highway.h>

#include "simd/vec3-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::simd::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Lanes that are finite. The test takes two operations on every target; Highway's test may take three.
template <class D, class V>
HWY_INLINE hn::Mask<D> IsFinite(D d, V x) {
  return hn::Lt(hn::Abs(x), hn::Inf(d));
}

/// Lanes whose three components are finite.
template <class D, class V>
HWY_INLINE hn::Mask<D> IsFinite(D d, const Vec3V<V>& v) {
  return hn::And(hn::And(IsFinite(d, v.x), IsFinite(d, v.y)), IsFinite(d, v.z));
}

/// x if it is finite, otherwise 0.
template <class D, class V>
HWY_INLINE V FiniteOrZero(D d, V x) {
  return hn::IfThenElseZero(IsFinite(d, x), x);
}

/// x if it is not NaN, otherwise 0.
template <class V>
HWY_INLINE V ZeroIfNaN(V x) {
  return hn::IfThenElseZero(hn::Eq(x, x), x);
}

}  // namespace shd::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_SIMD_FINITE_INL_H_
