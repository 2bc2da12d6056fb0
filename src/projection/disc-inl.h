// SPDX-License-Identifier: MIT
// SHD_PROJECTION_MIRROR_BALL and SHD_PROJECTION_ANGULAR: discs around +Z, whose rim is -Z. The distance from the centre
// is f(a) of the angle a from +Z: sin(a / 2) or a / pi.

#if defined(SHD_PROJECTION_DISC_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_PROJECTION_DISC_INL_H_
#undef SHD_PROJECTION_DISC_INL_H_
#else
#define SHD_PROJECTION_DISC_INL_H_
#endif

#include <cstdint>

#include <hwy/highway.h>

#include "projection/direction-inl.h"
#include "simd/angle-inl.h"
#include "simd/math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::projection::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// f(a), its derivative, and f(a) / rho, where rho is the distance of n from the Z axis.
template <class V>
struct RadiusV {
  V f, slope, per_rho;
};

struct AngularRadius {
  template <class D, class V>
  static HWY_INLINE RadiusV<V> Of(D d, const Polar<D>& polar, V z, V) {
    const V f = hn::Set(d, kInvPi<D>) * simd::HWY_NAMESPACE::Atan2(d, polar.length, z);
    const auto centre = hn::And(polar.tiny, hn::Gt(z, hn::Zero(d)));
    return {f, hn::Set(d, kInvPi<D>), hn::IfThenElse(centre, hn::Set(d, kInvPi<D>) / z, f * polar.inverse)};
  }

  /// Returns (cos a, sin a / f) and the solid angle per area of the disc, for f in [0, 1] and its square.
  template <class D, class V>
  static HWY_INLINE V Direction(D d, V f, V, V* sine_per_f, V* solid_angle) {
    const auto a = simd::HWY_NAMESPACE::SineCosinePi(d, f);
    const V pi = hn::Set(d, 3.14159265f);
    *sine_per_f = hn::IfThenElse(hn::Eq(f, hn::Zero(d)), pi, a.sine / f);
    *solid_angle = pi * *sine_per_f;
    return a.cosine;
  }
};

struct MirrorBallRadius {
  template <class D, class V>
  static HWY_INLINE RadiusV<V> Of(D d, const Polar<D>& polar, V z, V squared) {
    // sin and cos of a / 2: neither subtracts nearly equal numbers.
    const V length = hn::Sqrt(squared), half = hn::Set(d, 0.5f);
    const V far = hn::Sqrt(half * (length + hn::Abs(z)) / length);  // the larger one
    const V per_rho = half / (length * far);
    const V near = polar.length * per_rho;
    const auto behind = hn::Lt(z, hn::Zero(d));
    return {hn::IfThenElse(behind, far, near), half * hn::IfThenElse(behind, near, far),
            hn::IfThenElse(behind, far * polar.inverse, per_rho)};
  }

  template <class D, class V>
  static HWY_INLINE V Direction(D d, V, V squared, V* sine_per_f, V* solid_angle) {
    const V one = hn::Set(d, 1.0f), two = hn::Set(d, 2.0f);
    *sine_per_f = two * hn::Sqrt(one - squared);
    *solid_angle = hn::Set(d, 4.0f);
    return one - two * squared;
  }
};

template <class D, class Radius>
struct Disc {
  using V = hn::Vec<D>;
  using VI = hn::Vec<hn::RebindToSigned<D>>;
  static constexpr uint32_t kFaces = 1;
  static constexpr bool kRepeats = false, kStretches = false;

  V u, v;
  VI face;
  Polar<D> polar;  // (x, y)
  V z, squared;    // |n|^2
  RadiusV<V> radius;

  HWY_INLINE Disc(D d, const Vec3V<V>& n)
      : polar(d, n.x, n.y), z(n.z), squared(n.z * n.z + polar.length * polar.length) {
    radius = Radius::Of(d, polar, z, squared);
    const V half = hn::Set(d, 0.5f), f = half * radius.f;
    u = half + f * polar.x;
    v = half - f * polar.y;
    face = hn::Zero(hn::RebindToSigned<D>());
  }

  /// Change of (u, v) with a change of n.
  HWY_INLINE StepV<V> step(D d, const Vec3V<V>& dn) const {
    const V half = hn::Set(d, 0.5f);
    const V outwards = polar.x * dn.x + polar.y * dn.y, around = polar.x * dn.y - polar.y * dn.x;
    const V angle = (z * outwards - polar.length * dn.z) / squared;
    const V along = half * (radius.slope * angle), across = half * (radius.per_rho * around);
    return {along * polar.x - across * polar.y, hn::Neg(along * polar.y + across * polar.x)};
  }

  HWY_INLINE StepV<V> even_step(D d, const Vec3V<V>& dn) const { return step(d, dn); }
  HWY_INLINE V stretch(D d) const { return hn::Set(d, 1.0f); }

  /// Unit direction of a point with u and v in [0, 1], and the solid angle per area of (u, v). Outside the disc -Z and
  /// 0.
  static HWY_INLINE Vec3V<V> direction(D d, V u, V v, VI, V* solid_angle) {
    const V one = hn::Set(d, 1.0f), p = (u + u) - one, q = one - (v + v);
    const V squared = p * p + q * q;
    const auto outside = hn::Gt(squared, one);
    const V bounded = hn::Min(squared, one);
    V sine_per_f;
    const V cosine = Radius::Direction(d, hn::Sqrt(bounded), bounded, &sine_per_f, solid_angle);
    *solid_angle = hn::IfThenZeroElse(outside, hn::Set(d, 4.0f) * *solid_angle);
    sine_per_f = hn::IfThenZeroElse(outside, sine_per_f);
    return {p * sine_per_f, q * sine_per_f, cosine};
  }
};

}  // namespace shd::projection::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_PROJECTION_DISC_INL_H_
