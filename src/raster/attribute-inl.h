// SPDX-License-Identifier: MIT
// Barycentric interpolation of a value between the vertices of a triangle.

#if defined(SHD_RASTER_ATTRIBUTE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_RASTER_ATTRIBUTE_INL_H_
#undef SHD_RASTER_ATTRIBUTE_INL_H_
#else
#define SHD_RASTER_ATTRIBUTE_INL_H_
#endif

#include <hwy/highway.h>

#include "raster/fragments.h"
#include "simd/finite-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Blend() where no difference overflows.
template <class V>
HWY_INLINE V PlainBlend(V a0, V a1, V a2, V b1, V b2) {
  return a0 + b1 * (a1 - a0) + b2 * (a2 - a0);
}

/// a0 + b1 (a1 - a0) + b2 (a2 - a0). Three equal values give that value, bit by bit. Where a difference overflows, the
/// sum is computed on halved values.
template <class D, class V>
HWY_INLINE V Blend(D d, V a0, V a1, V a2, V b1, V b2) {
  const V blend = PlainBlend(a0, a1, a2, b1, b2);
  const auto finite = simd::HWY_NAMESPACE::IsFinite(d, blend);
  if (HWY_LIKELY(hn::AllTrue(d, finite))) return blend;
  const V half = hn::Set(d, 0.5f), limit = hn::Set(d, 0x1.fffffep126f);
  const V h0 = a0 * half, h1 = a1 * half - h0, h2 = a2 * half - h0;
  const V halved = h0 + b1 * h1 + b2 * h2;
  const V bounded = hn::Min(hn::Max(halved, hn::Neg(limit)), limit);
  return hn::IfThenElse(finite, blend, bounded + bounded);
}

/// Whether all fragments of the vector from row `at` on belong to one triangle. Comparing the first and the last row is
/// not enough: another triangle may lie between two pieces of one triangle.
template <class D>
HWY_INLINE bool ShareTriangle(D, const Fragments& f, size_t at) {
  const hn::RebindToUnsigned<D> du;
  return hn::AllTrue(du, hn::Eq(hn::Load(du, f.triangle + at), hn::Set(du, f.triangle[at])));
}

}  // namespace shd::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_RASTER_ATTRIBUTE_INL_H_
