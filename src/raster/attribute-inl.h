// SPDX-License-Identifier: MIT
// Barycentric interpolation of a value between the vertices of a triangle.

#if defined(SHD_RASTER_ATTRIBUTE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_RASTER_ATTRIBUTE_INL_H_
#undef SHD_RASTER_ATTRIBUTE_INL_H_
#else
#define SHD_RASTER_ATTRIBUTE_INL_H_
#endif

#include <hwy/highway.h>

#include "simd/finite-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A value at the corners of a triangle.
template <class V>
struct CornerValues {
  V a[3];
};

/// Blend() where no difference overflows, from the value at corner 0 and the differences of the others to it.
template <class V>
HWY_INLINE V PlainBlend(V origin, V side1, V side2, V b1, V b2) {
  return origin + b1 * side1 + b2 * side2;
}

/// a0 + b1 (a1 - a0) + b2 (a2 - a0). Three equal values give that value, bit by bit. Where a difference overflows, the
/// sum is computed on halved values.
template <class D, class V>
HWY_INLINE V Blend(D d, const CornerValues<V>& corner, V b1, V b2) {
  const V blend = PlainBlend(corner.a[0], corner.a[1] - corner.a[0], corner.a[2] - corner.a[0], b1, b2);
  const auto finite = simd::HWY_NAMESPACE::IsFinite(d, blend);
  if (HWY_LIKELY(hn::AllTrue(d, finite))) return blend;
  const V half = hn::Set(d, 0.5f), limit = hn::Set(d, 0x1.fffffep126f);
  const V h0 = corner.a[0] * half, h1 = corner.a[1] * half - h0, h2 = corner.a[2] * half - h0;
  const V halved = PlainBlend(h0, h1, h2, b1, b2);
  const V bounded = hn::Min(hn::Max(halved, hn::Neg(limit)), limit);
  return hn::IfThenElse(finite, blend, bounded + bounded);
}

}  // namespace shd::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_RASTER_ATTRIBUTE_INL_H_
