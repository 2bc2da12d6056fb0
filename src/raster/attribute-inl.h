// SPDX-License-Identifier: MIT
// Barycentric interpolation of a value between the vertices of a triangle.

#if defined(SHD_RASTER_ATTRIBUTE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_RASTER_ATTRIBUTE_INL_H_
#undef SHD_RASTER_ATTRIBUTE_INL_H_
#else
#define SHD_RASTER_ATTRIBUTE_INL_H_
#endif

#include <hwy/highway.h>

#include "geometry/vertex.h"
#include "raster/barycentric-inl.h"
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

/// Reads component c of rows of four; all lanes read the same row.
struct OneRow {
  size_t row;
  template <class D>
  HWY_INLINE hn::Vec<D> Get(D d, const float* rows, int c) const {
    return hn::Set(d, rows[4 * row + static_cast<size_t>(c)]);
  }
};

/// Reads component c of rows of four; each lane reads its own row.
template <class D>
struct RowPerLane {
  hn::Vec<hn::RebindToSigned<D>> first;  // index of component 0
  HWY_INLINE hn::Vec<D> Get(D d, const float* rows, int c) const {
    const hn::RebindToSigned<D> di;
    return hn::GatherIndex(d, rows, first + hn::Set(di, c));
  }
};

template <class D, class Rows, class V = hn::Vec<D>>
HWY_INLINE Corners<V> CornersOf(D d, const geometry::Vertices& vertices, const Rows (&rows)[3]) {
  Corners<V> corners;
  for (int k = 0; k < 3; ++k) {
    const float* raster = vertices.raster.data();
    corners.x[k] = rows[k].Get(d, raster, 0);
    corners.y[k] = rows[k].Get(d, raster, 1);
    corners.w[k] = rows[k].Get(d, raster, 3);
  }
  return corners;
}

/// A texture coordinate at the corners of triangles.
template <class V>
struct CornerValues {
  V a[3];
};

template <class D, class Rows, class V = hn::Vec<D>>
HWY_INLINE CornerValues<V> ValuesOf(D d, const geometry::RowComponent& from, const Rows (&rows)[3]) {
  const auto c = static_cast<int>(from.component);
  return {{rows[0].Get(d, from.rows, c), rows[1].Get(d, from.rows, c), rows[2].Get(d, from.rows, c)}};
}

/// Derivatives of a texture coordinate per pixel.
template <class V>
struct Steps {
  V dx, dy;
};
/// StepsOf() where no product overflows.
template <class V>
HWY_INLINE Steps<V> PlainSteps(const CornerValues<V>& corner, const Barycentric<V>& b) {
  const V a1 = corner.a[1] - corner.a[0], a2 = corner.a[2] - corner.a[0];
  return {b.b1_dx * a1 + b.b2_dx * a2, b.b1_dy * a1 + b.b2_dy * a2};
}
template <class D, class V>
HWY_INLINE Steps<V> StepsOf(D d, const CornerValues<V>& corner, const Barycentric<V>& b) {
  const Steps<V> plain = PlainSteps(corner, b);
  return {simd::HWY_NAMESPACE::FiniteOrZero(d, plain.dx), simd::HWY_NAMESPACE::FiniteOrZero(d, plain.dy)};
}

}  // namespace shd::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_RASTER_ATTRIBUTE_INL_H_
