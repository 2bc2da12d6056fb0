// SPDX-License-Identifier: MIT
// SHD_PROJECTION_LAT_LONG: longitude across, latitude down.

#if defined(SHD_PROJECTION_LAT_LONG_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_PROJECTION_LAT_LONG_INL_H_
#undef SHD_PROJECTION_LAT_LONG_INL_H_
#else
#define SHD_PROJECTION_LAT_LONG_INL_H_
#endif

#include <cstdint>

#include <hwy/highway.h>

#include "projection/direction-inl.h"
#include "simd/angle-inl.h"
#include "simd/math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::projection::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class D>
struct LatLong {
  using V = hn::Vec<D>;
  using VI = hn::Vec<hn::RebindToSigned<D>>;
  static constexpr uint32_t kFaces = 1;
  static constexpr bool kRepeats = true, kStretches = true;

  V u, v;
  VI face;
  Polar<D> horizontal;  // (z, x): the projection onto the ground
  V y, per_square;      // 1 / |n|^2

  HWY_INLINE LatLong(D d, const Vec3V<V>& n) : horizontal(d, n.z, n.x), y(n.y) {
    const V half = hn::Set(d, 0.5f);
    u = half + hn::Set(d, kInvPi<D> / 2) * simd::HWY_NAMESPACE::Atan2(d, hn::Neg(n.x), n.z);
    v = half - hn::Set(d, kInvPi<D>) * simd::HWY_NAMESPACE::Atan2(d, y, horizontal.length);
    face = hn::Zero(hn::RebindToSigned<D>());
    per_square = hn::Set(d, 1.0f) / (y * y + horizontal.length * horizontal.length);
  }

  /// Change of (u, v) with a change of n.
  HWY_INLINE StepV<V> step(D d, const Vec3V<V>& dn) const {
    return {hn::Set(d, kInvPi<D> / 2) * (around(dn) * horizontal.inverse), down(d, dn)};
  }

  /// The change with the length that it would have on the equator: u by the angle, not by the longitude.
  HWY_INLINE StepV<V> even_step(D d, const Vec3V<V>& dn) const {
    return {hn::Set(d, kInvPi<D> / 2) * (around(dn) * hn::Sqrt(per_square)), down(d, dn)};
  }

  /// The change of u by step(), relative to even_step(): 1 / cos(latitude), at most 65536.
  HWY_INLINE V stretch(D d) const {
    const V stretch = hn::Max(horizontal.inverse / hn::Sqrt(per_square), hn::Set(d, 1.0f));
    return hn::Min(stretch, hn::Set(d, 65536.0f));
  }

  /// Unit direction of a point with u and v in [0, 1], and the solid angle per area of (u, v).
  static HWY_INLINE Vec3V<V> direction(D d, V u, V v, VI, V* solid_angle) {
    const auto latitude = simd::HWY_NAMESPACE::SineCosinePi(d, v);
    const auto longitude = simd::HWY_NAMESPACE::SineCosinePi(d, hn::Set(d, 1.0f) - (u + u));  // turn towards +x
    *solid_angle = hn::Set(d, 19.7392088f) * latitude.sine;                                   // 2 pi^2
    return {longitude.sine * latitude.sine, latitude.cosine, longitude.cosine * latitude.sine};
  }

 private:
  /// Change of n along the parallel, eastwards.
  HWY_INLINE V around(const Vec3V<V>& dn) const { return horizontal.y * dn.z - horizontal.x * dn.x; }
  HWY_INLINE V down(D d, const Vec3V<V>& dn) const {
    const V along = horizontal.x * dn.z + horizontal.y * dn.x;  // away from the axis
    return hn::Set(d, kInvPi<D>) * ((y * along - horizontal.length * dn.y) * per_square);
  }
};

}  // namespace shd::projection::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_PROJECTION_LAT_LONG_INL_H_
