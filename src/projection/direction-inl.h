// SPDX-License-Identifier: MIT
// Directions of any length as directions of a length near 1.

#if defined(SHD_PROJECTION_DIRECTION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_PROJECTION_DIRECTION_INL_H_
#undef SHD_PROJECTION_DIRECTION_INL_H_
#else
#define SHD_PROJECTION_DIRECTION_INL_H_
#endif

#include <hwy/highway.h>

#include "simd/finite-inl.h"
#include "simd/vec3-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::projection::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::Vec3V;

/// Change of a point (u, v).
template <class V>
struct StepV {
  V du, dv;
};

/// Direction divided by the magnitude of its largest component.
template <class D>
struct BoundedDirection {
  using V = hn::Vec<D>;
  Vec3V<V> n;         // the largest magnitude is 1 or 1 - 2^-24; +Z in lanes without a direction
  hn::Mask<D> valid;  // lanes whose direction is finite and not 0
  V prescale, scale;  // n = (direction * prescale) * scale

  HWY_INLINE BoundedDirection(D d, const Vec3V<V>& direction) {
    const V one = hn::Set(d, 1.0f);
    V largest = hn::Max(hn::Max(hn::Abs(direction.x), hn::Abs(direction.y)), hn::Abs(direction.z));
    // Targets differ in the Max() of a NaN; the sum of the magnitudes is NaN everywhere, and its lane is not valid.
    const V sum = (hn::Abs(direction.x) + hn::Abs(direction.y)) + hn::Abs(direction.z);
    const auto usual = hn::And(hn::Gt(largest, hn::Set(d, 0x1p-64f)), hn::Lt(sum, hn::Set(d, 0x1p64f)));
    n = direction;
    valid = usual;
    prescale = one;
    if (HWY_UNLIKELY(!hn::AllTrue(d, usual))) {
      valid = hn::And(simd::HWY_NAMESPACE::IsFinite(d, direction), hn::Gt(largest, hn::Zero(d)));
      prescale = hn::IfThenElse(hn::Lt(largest, one), hn::Set(d, 0x1p64f), hn::Set(d, 0x1p-64f));
      prescale = hn::IfThenElse(hn::AndNot(usual, valid), prescale, one);
      n = Select(valid, Scaled(direction, prescale), Vec3V<V>{hn::Zero(d), hn::Zero(d), one});
      largest = hn::IfThenElse(valid, largest * prescale, one);
    }
    scale = one / largest;
    n = Scaled(n, scale);
  }

  /// A change of the direction, in the units of n and within +-2^60; NaN: 0.
  HWY_INLINE Vec3V<V> step(D d, const Vec3V<V>& change) const {
    const auto bounded = [&](V x) {
      const V y = (x * prescale) * scale, limit = hn::Set(d, 0x1p60f);
      return hn::Min(hn::Max(simd::HWY_NAMESPACE::ZeroIfNaN(y), hn::Neg(limit)), limit);
    };
    return {bounded(change.x), bounded(change.y), bounded(change.z)};
  }
};

/// (x, y) in polar form: its length, and its unit vector, which is (1, 0) where the length is below 2^-50.
template <class D>
struct Polar {
  using V = hn::Vec<D>;
  V length;          // accurate from 2^-50 on
  V inverse;         // 1 / max(length, 2^-50)
  V x, y;            // unit vector
  hn::Mask<D> tiny;  // lanes with a length below 2^-50

  HWY_INLINE Polar(D d, V a, V b) {
    const V squared = a * a + b * b, one = hn::Set(d, 1.0f);
    tiny = hn::Lt(squared, hn::Set(d, 0x1p-100f));
    length = hn::Sqrt(squared);
    inverse = one / hn::IfThenElse(tiny, hn::Set(d, 0x1p-50f), length);
    x = hn::IfThenElse(tiny, one, a * inverse);
    y = hn::IfThenZeroElse(tiny, b * inverse);
  }
};

}  // namespace shd::projection::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_PROJECTION_DIRECTION_INL_H_
