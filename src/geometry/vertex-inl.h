// SPDX-License-Identifier: MIT
// Code shared by all kernels that transform vertices, so that the same inputs give the same bits.

#if defined(SHD_GEOMETRY_VERTEX_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_GEOMETRY_VERTEX_INL_H_
#undef SHD_GEOMETRY_VERTEX_INL_H_
#else
#define SHD_GEOMETRY_VERTEX_INL_H_
#endif

#include <hwy/highway.h>

#include "geometry/vertex.h"
#include "simd/vec3-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::geometry::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::Normalize;
using simd::HWY_NAMESPACE::Vec3V;

/// Row `row` of a column-major 4x4 matrix times (p, 1).
template <class D, class V>
HWY_INLINE V TransformRow(D d, const float* m, int row, const Vec3V<V>& p) {
  const V xy = hn::Set(d, m[row]) * p.x + hn::Set(d, m[4 + row]) * p.y;
  return xy + hn::Set(d, m[8 + row]) * p.z + hn::Set(d, m[12 + row]);
}

/// Row `row` of a column-major 3x3 matrix times n.
template <class D, class V>
HWY_INLINE V TransformNormalRow(D d, const float* m, int row, const Vec3V<V>& n) {
  const V xy = hn::Set(d, m[row]) * n.x + hn::Set(d, m[3 + row]) * n.y;
  return xy + hn::Set(d, m[6 + row]) * n.z;
}

template <class DI, class M>
HWY_INLINE hn::Vec<DI> Bit(DI di, M mask, uint32_t bit) {
  const hn::RebindToFloat<DI> d;
  return hn::BitCast(di, hn::IfThenElseZero(mask, hn::BitCast(d, hn::Set(di, static_cast<int32_t>(bit)))));
}

/// (X, Y, Z, W) of vertices.
template <class V>
struct Homogeneous {
  V x, y, z, w;
};

/// Outcodes of vertices; lanes outside `finite` get kOutNonfinite.
template <class D, class V>
HWY_INLINE hn::Vec<hn::RebindToSigned<D>> Outcodes(D d, const Transform& transform, const Homogeneous<V>& h,
                                                   hn::Mask<D> finite) {
  const hn::RebindToSigned<D> di;
  const V zero = hn::Zero(d);
  const V guard = h.w * hn::Set(d, kGuardBand);
  auto code = Bit(di, hn::Lt(h.x, h.w * hn::Set(d, transform.left)), kOutLeft);
  code = code | Bit(di, hn::Gt(h.x, h.w * hn::Set(d, transform.right)), kOutRight);
  code = code | Bit(di, hn::Lt(h.y, h.w * hn::Set(d, transform.top)), kOutTop);
  code = code | Bit(di, hn::Gt(h.y, h.w * hn::Set(d, transform.bottom)), kOutBottom);
  code = code | Bit(di, hn::Lt(h.z, zero), kOutNear);
  code = code | Bit(di, hn::Gt(h.z, h.w), kOutFar);
  code = code | Bit(di, hn::Lt(h.w, hn::Set(d, kMinW)), kOutBehind);
  code = code | Bit(di, hn::Or(hn::Gt(hn::Abs(h.x), guard), hn::Gt(hn::Abs(h.y), guard)), kOutGuard);
  return code | Bit(di, hn::Not(finite), kOutNonfinite);
}

/// Raster coordinate X / W in fixed point, rounded to nearest; 0 in lanes outside `usable`.
template <class D, class V>
HWY_INLINE hn::Vec<hn::RebindToSigned<D>> Snap(D d, V numerator, V w, hn::Mask<D> usable) {
  const V pixels = hn::IfThenElseZero(usable, numerator / w);
  return hn::NearestInt(pixels * hn::Set(d, static_cast<float>(kSubpixels)));
}

template <class D, class V>
HWY_INLINE Vec3V<V> WorldPosition(D d, const Transform& transform, const Vec3V<V>& p) {
  return {TransformRow(d, transform.world, 0, p), TransformRow(d, transform.world, 1, p),
          TransformRow(d, transform.world, 2, p)};
}

/// World-space normals, unit or 0.
template <class D, class V>
HWY_INLINE Vec3V<V> WorldNormal(D d, const Transform& transform, const Vec3V<V>& n) {
  return Normalize(
      d, Vec3V<V>{TransformNormalRow(d, transform.normal, 0, n), TransformNormalRow(d, transform.normal, 1, n),
                  TransformNormalRow(d, transform.normal, 2, n)});
}

/// Stores world-space positions and u to the rows from i on.
template <class D, class V>
HWY_INLINE void StorePositions(D d, const Vec3V<V>& p, V u, size_t i, Vertices& out) {
  hn::StoreInterleaved4(p.x, p.y, p.z, u, d, &out.world[4 * i]);
}

/// Stores world-space unit normals and v to the rows from i on.
template <class D, class V>
HWY_INLINE void StoreNormals(D d, const Vec3V<V>& n, V v, size_t i, Vertices& out) {
  hn::StoreInterleaved4(n.x, n.y, n.z, v, d, &out.normal[4 * i]);
}

/// Stores (X, Y, Z, W) and the resulting ScreenVertex to the rows from i on. `finite` selects the lanes in which all
/// components are finite.
template <class D, class V>
HWY_INLINE void StoreRaster(D d, const Transform& transform, const Homogeneous<V>& h, hn::Mask<D> finite, size_t i,
                            Vertices& out) {
  const hn::RebindToSigned<D> di;
  const auto code = Outcodes(d, transform, h, finite);
  const auto usable =
      hn::RebindMask(d, hn::Eq(code & hn::Set(di, static_cast<int32_t>(kMustClip | kOutNonfinite)), hn::Zero(di)));
  hn::StoreInterleaved4(h.x, h.y, h.z, h.w, d, &out.raster[4 * i]);
  const V depth = hn::IfThenElseZero(usable, h.z / h.w);
  hn::StoreInterleaved4(Snap(d, h.x, h.w, usable), Snap(d, h.y, h.w, usable), hn::BitCast(di, depth), code, di,
                        &out.screen[i].x);
}

}  // namespace shd::geometry::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_GEOMETRY_VERTEX_INL_H_
