// SPDX-License-Identifier: MIT
// Interpolation of the columns that most lit materials read, for long spans of rows.

#if defined(SHD_RASTER_LIT_ROWS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_RASTER_LIT_ROWS_INL_H_
#undef SHD_RASTER_LIT_ROWS_INL_H_
#else
#define SHD_RASTER_LIT_ROWS_INL_H_
#endif

#include <cmath>

#include <hwy/highway.h>

#include "raster/fragments.h"
#include "raster/planes-inl.h"
#include "simd/vec3-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The columns of InterpolateLit().
constexpr uint32_t kLitColumns = kPosition | kNormal | kToEye | kTexture;

/// Vectors of a span from which on the time to spread the values of its triangle pays.
constexpr size_t kLongSpan = 3;

/// Whether blends of the corners, with weights in 0..1, do not overflow.
inline bool are_bounded(const Sides (&sides)[3]) {
  float sum = 0.0f;
  for (const Sides& side : sides) sum += std::fabs(side.origin) + std::fabs(side.side1) + std::fabs(side.side2);
  return sum < 0x1p120f;
}

/// A triangle and the eye, spread over vectors.
struct WideTriangle {
  WideTriangle(const TrianglePlanes& of_planes, const Sides (&of_position)[3], const Sides (&of_normal)[3],
               const float* of_eye) {
    static_assert(sizeof(TrianglePlanes) == 35 * sizeof(float) && sizeof of_position == 9 * sizeof(float));
    Set(&of_planes.middle_x, 23, &planes.middle_x);  // without u1 and v1
    Set(&of_position[0].origin, 9, &position[0].origin);
    Set(&of_normal[0].origin, 9, &normal[0].origin);
    Set(of_eye, 3, eye);
  }

  TrianglePlanesOf<Wide> planes;
  SidesOf<Wide> position[3], normal[3];
  Wide eye[3];

 private:
  static void Set(const float* values, size_t count, Wide* to) {
    const hn::ScalableTag<float> d;
    for (size_t k = 0; k < count; ++k) hn::Store(hn::Set(d, values[k]), d, to[k].lane);
  }
};

/// Stores vectors into columns that follow each other in memory.
template <class D, class... V>
HWY_INLINE void StoreColumns(D d, float* to, const V&... values) {
  size_t k = 0;
  ((hn::StoreU(values, d, to + k * kColumn), ++k), ...);
}

/// Interpolates rows begin..end - 1, which belong to one triangle, with the bits of InterpolateTriangle() for bounded
/// positions. The last vector may write past them.
/// @param x  column x of the table
inline HWY_NOINLINE void InterpolateLit(const WideTriangle& triangle, size_t begin, size_t end, float* x) {
  using simd::HWY_NAMESPACE::Normalize;
  const hn::ScalableTag<float> d;
  using V = hn::Vec<decltype(d)>;
  using V3 = simd::HWY_NAMESPACE::Vec3V<V>;
  const TrianglePlanesOf<Wide>& planes = triangle.planes;
  const SidesOf<Wide>(&position)[3] = triangle.position;
  const SidesOf<Wide>(&normal)[3] = triangle.normal;
  for (float *row = x + begin, *const last = x + end; row < last; row += hn::Lanes(d)) {
    const PixelsAt<V> pixels = {hn::LoadU(d, row) - Spread(d, planes.middle_x),
                                hn::LoadU(d, row + kYPlace * kColumn) - Spread(d, planes.middle_y)};
    const V factor = FactorOf(d, planes.inverse_w, pixels);
    const Attribute<V> u = CoordinateAt(d, planes.u, planes.inverse_w, factor, pixels);
    const Attribute<V> v = CoordinateAt(d, planes.v, planes.inverse_w, factor, pixels);
    StoreColumns(d, row + kTexturePlace * kColumn, u.value, v.value, u.dx, v.dx, u.dy, v.dy);
    const Barycentric<V> b = WeightsAt(d, planes, factor, pixels);
    const V3 n = Normalize(d, V3{normal[0].At(d, b), normal[1].At(d, b), normal[2].At(d, b)});
    StoreColumns(d, row + kNormalPlace * kColumn, n.x, n.y, n.z);
    const V3 p = {position[0].At(d, b), position[1].At(d, b), position[2].At(d, b)};
    StoreColumns(d, row + kPositionPlace * kColumn, p.x, p.y, p.z);
    const V3 o = Normalize(
        d, V3{Spread(d, triangle.eye[0]) - p.x, Spread(d, triangle.eye[1]) - p.y, Spread(d, triangle.eye[2]) - p.z});
    StoreColumns(d, row + kToEyePlace * kColumn, o.x, o.y, o.z);
  }
}

}  // namespace shd::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_RASTER_LIT_ROWS_INL_H_
