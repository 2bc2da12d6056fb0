// SPDX-License-Identifier: MIT
// Barycentric coordinates of raster positions, and their derivatives.

#if defined(SHD_RASTER_BARYCENTRIC_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_RASTER_BARYCENTRIC_INL_H_
#undef SHD_RASTER_BARYCENTRIC_INL_H_
#else
#define SHD_RASTER_BARYCENTRIC_INL_H_
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace shd::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class V>
struct Barycentric {
  V b1, b2;                      // weights of vertices 1 and 2
  V b1_dx, b1_dy, b2_dx, b2_dy;  // derivatives per pixel
  V b0;
};

/// Homogeneous raster positions of the corners of triangles.
template <class V>
struct Corners {
  V x[3], y[3], w[3];
};

/// Terms of the barycentric coordinates that all pixels of a row share. With the vertices translated so that the pixel
/// is the origin, the weights e[k] of the vertices are their cross products.
template <class V>
struct PixelRow {
  V y[3];             // translated vertices
  V e_dx[3], sum_dx;  // derivatives of the weights, and of their sum
};

/// Weight k of a pixel, from the translated corners.
template <class V>
HWY_INLINE V WeightAt(const V (&y)[3], const V (&x)[3], int k) {
  const int i = (k + 1) % 3, j = (k + 2) % 3;
  return x[i] * y[j] - x[j] * y[i];
}
/// Its derivative down.
template <class V>
HWY_INLINE V WeightSlope(const V (&w)[3], const V (&x)[3], int k) {
  const int i = (k + 1) % 3, j = (k + 2) % 3;
  return x[j] * w[i] - x[i] * w[j];
}

template <class V>
HWY_INLINE PixelRow<V> PixelRowAt(const Corners<V>& corners, V py) {
  PixelRow<V> row;
  const V(&w)[3] = corners.w;
  for (int k = 0; k < 3; ++k) row.y[k] = corners.y[k] - py * w[k];
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    row.e_dx[k] = w[j] * row.y[i] - w[i] * row.y[j];
  }
  row.sum_dx = row.e_dx[0] + row.e_dx[1] + row.e_dx[2];
  return row;
}

/// Sets the weights, clamped to the triangle.
template <class D, class V>
HWY_INLINE void ClampToTriangle(D d, V b1, V b2, Barycentric<V>& result) {
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  result.b1 = hn::Min(hn::Max(b1, zero), one);
  result.b2 = hn::Min(hn::Max(b2, zero), one - result.b1);
  result.b0 = one - result.b1 - result.b2;
}

/// Barycentric coordinates of raster position px in a row of pixels, and their derivatives.
template <class D, class V>
HWY_INLINE Barycentric<V> PerspectiveWeights(D d, const Corners<V>& corners, const PixelRow<V>& row, V px) {
  V x[3], e[3], e_dy[3];
  const V(&w)[3] = corners.w, (&y)[3] = row.y, (&e_dx)[3] = row.e_dx;
  for (int k = 0; k < 3; ++k) x[k] = corners.x[k] - px * w[k];
  for (int k = 0; k < 3; ++k) {
    e[k] = WeightAt(y, x, k);
    e_dy[k] = WeightSlope(w, x, k);
  }
  const V one = hn::Set(d, 1.0f), sum_dx = row.sum_dx;
  const V sum = e[0] + e[1] + e[2];
  const V sum_dy = e_dy[0] + e_dy[1] + e_dy[2];
  // A smaller sum has no finite inverse. NaN fails both comparisons.
  const V size = hn::Abs(sum);
  const auto usable = hn::And(hn::Lt(size, hn::Set(d, __builtin_inff())), hn::Ge(size, hn::Set(d, 0x1p-126f)));
  const V inverse = one / hn::IfThenElse(usable, sum, one);

  const V third = hn::Set(d, 1.0f / 3.0f);
  const V raw1 = hn::IfThenElse(usable, e[1] * inverse, third);
  const V raw2 = hn::IfThenElse(usable, e[2] * inverse, third);
  Barycentric<V> result;
  result.b1_dx = hn::IfThenElseZero(usable, (e_dx[1] - raw1 * sum_dx) * inverse);
  result.b1_dy = hn::IfThenElseZero(usable, (e_dy[1] - raw1 * sum_dy) * inverse);
  result.b2_dx = hn::IfThenElseZero(usable, (e_dx[2] - raw2 * sum_dx) * inverse);
  result.b2_dy = hn::IfThenElseZero(usable, (e_dy[2] - raw2 * sum_dy) * inverse);
  ClampToTriangle(d, raw1, raw2, result);
  return result;
}

/// Barycentric coordinates of triangles whose corners have the same w. They are affine functions of the raster position
/// relative to corner 0, so their derivatives are the same at every pixel.
template <class D>
struct AffineTriangles {
  using V = hn::Vec<D>;
  V x, y, w;                     // corner 0
  V b1_x, b1_y, b2_x, b2_y;      // derivatives per unit of the homogeneous position
  V b1_dx, b1_dy, b2_dx, b2_dy;  // derivatives per pixel
  hn::Mask<D> usable;            // false where the corners differ in w, and where a result might overflow
};

/// Whether a triangle of the vector has one w.
template <class D, class V>
HWY_INLINE bool AnyAffine(D d, const Corners<V>& corners) {
  return !hn::AllFalse(d, hn::And(hn::Eq(corners.w[0], corners.w[1]), hn::Eq(corners.w[0], corners.w[2])));
}

template <class D, class V>
HWY_INLINE AffineTriangles<D> AffineTrianglesOf(D d, const Corners<V>& corners) {
  const V(&x)[3] = corners.x, (&y)[3] = corners.y, (&w)[3] = corners.w;
  AffineTriangles<D> result;
  result.x = x[0];
  result.y = y[0];
  result.w = w[0];
  const V x1 = x[1] - x[0], y1 = y[1] - y[0], x2 = x[2] - x[0], y2 = y[2] - y[0];
  const V area = x1 * y2 - x2 * y1;
  const V inverse = hn::Set(d, 1.0f) / area;
  result.b1_x = y2 * inverse;
  result.b1_y = hn::Neg(x2) * inverse;
  result.b2_x = hn::Neg(y1) * inverse;
  result.b2_y = x1 * inverse;
  result.b1_dx = result.b1_x * w[0];
  result.b1_dy = result.b1_y * w[0];
  result.b2_dx = result.b2_x * w[0];
  result.b2_dy = result.b2_y * w[0];
  // Within these bounds all products at pixels of a picture are below 2^100. NaN fails the comparisons.
  const V high = hn::Set(d, 0x1p30f);
  const auto small = [&](V a, V b, V c) { return hn::Le(hn::Max(hn::Max(hn::Abs(a), hn::Abs(b)), hn::Abs(c)), high); };
  const auto one_w = hn::And(hn::Eq(w[0], w[1]), hn::Eq(w[0], w[2]));
  const auto bounded =
      hn::And(hn::And(small(x[0], x[1], x[2]), small(y[0], y[1], y[2])), hn::Le(hn::Abs(w[0]), hn::Set(d, 0x1p14f)));
  result.usable = hn::And(hn::And(one_w, bounded), hn::Ge(hn::Abs(area), hn::Set(d, 0x1p-30f)));
  return result;
}

/// Terms of the coordinates that all pixels of a row share.
template <class V>
struct AffineRow {
  V b1, b2;
};

template <class D, class V>
HWY_INLINE AffineRow<V> AffineRowAt(const AffineTriangles<D>& triangles, V py) {
  const V y = py * triangles.w - triangles.y;
  return {y * triangles.b1_y, y * triangles.b2_y};
}

/// Barycentric coordinates of raster position px in a row of pixels, and their derivatives.
template <class D, class V>
HWY_INLINE Barycentric<V> AffineWeights(D d, const AffineTriangles<D>& triangles, const AffineRow<V>& row, V px) {
  const V x = px * triangles.w - triangles.x;
  Barycentric<V> result;
  result.b1_dx = triangles.b1_dx;
  result.b1_dy = triangles.b1_dy;
  result.b2_dx = triangles.b2_dx;
  result.b2_dy = triangles.b2_dy;
  ClampToTriangle(d, x * triangles.b1_x + row.b1, x * triangles.b2_x + row.b2, result);
  return result;
}

/// Barycentric coordinates of any triangles at raster positions.
template <class D, class V>
HWY_INLINE Barycentric<V> WeightsAt(D d, const Corners<V>& corners, V px, V py) {
  if (HWY_LIKELY(!AnyAffine(d, corners))) return PerspectiveWeights(d, corners, PixelRowAt(corners, py), px);
  const auto triangles = AffineTrianglesOf(d, corners);
  const auto affine = AffineWeights(d, triangles, AffineRowAt(triangles, py), px);
  if (HWY_LIKELY(hn::AllTrue(d, triangles.usable))) return affine;
  const auto other = PerspectiveWeights(d, corners, PixelRowAt(corners, py), px);
  const auto choose = [&](V a, V b) { return hn::IfThenElse(triangles.usable, a, b); };
  return {choose(affine.b1, other.b1),       choose(affine.b2, other.b2),       choose(affine.b1_dx, other.b1_dx),
          choose(affine.b1_dy, other.b1_dy), choose(affine.b2_dx, other.b2_dx), choose(affine.b2_dy, other.b2_dy),
          choose(affine.b0, other.b0)};
}

}  // namespace shd::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_RASTER_BARYCENTRIC_INL_H_
