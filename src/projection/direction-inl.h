// SPDX-License-Identifier: MIT
// Directions of any length as directions of a length near 1.

#if defined(SHD_PROJECTION_DIRECTION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_PROJECTION_DIRECTION_INL_H_
#undef SHD_PROJECTION_DIRECTION_INL_H_
#else
#define SHD_PROJECTION_DIRECTION_INL_H_
#endif

#include <hwy/highway.h>

#include "data/trig.h"
#include "simd/finite-inl.h"
#include "simd/vec3-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::projection::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::Vec3V;

/// 1 / pi, rounded once.
template <class D>
constexpr hn::TFromD<D> kInvPi = static_cast<hn::TFromD<D>>(1.0 / data::kPi);

/// Change of a point (u, v).
template <class V>
struct StepV {
  V du, dv;
};

/// Changes of n that are longer are shortened before they are projected, so that no product leaves the range of floats.
constexpr float kLongStep = 0x1p60f;

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

  /// Derivatives of a point with a change of the direction. `step` has those with a change of n; it is linear. NaN
  /// counts as 0. Beside an infinite component, finite ones count as 0, and the result may be finite.
  template <class Step>
  HWY_INLINE StepV<V> derivatives(D d, const Vec3V<V>& change, const Step& step) const {
    Vec3V<V> dn = Scaled(Scaled(change, prescale), scale);
    V growth = hn::Set(d, 1.0f);
    const V sum = (hn::Abs(dn.x) + hn::Abs(dn.y)) + hn::Abs(dn.z);  // NaN if a component is NaN
    if (HWY_UNLIKELY(!hn::AllTrue(d, hn::Lt(sum, hn::Set(d, kLongStep))))) shorten(d, change, &dn, &growth);
    const StepV<V> point = step(dn);
    return {point.du * growth, point.dv * growth};
  }

 private:
  /// Shortens changes of n until their largest component is kLongStep, and finds the factor of what is left, at most
  /// 2^127.
  HWY_NOINLINE void shorten(D d, const Vec3V<V>& given, Vec3V<V>* dn, V* growth) const {
    using simd::HWY_NAMESPACE::ZeroIfNaN;
    const V one = hn::Set(d, 1.0f), infinity = hn::Inf(d), limit = hn::Set(d, kLongStep);
    const auto largest_of = [](const Vec3V<V>& v) {
      return hn::Max(hn::Max(hn::Abs(v.x), hn::Abs(v.y)), hn::Abs(v.z));
    };
    const Vec3V<V> change = {ZeroIfNaN(given.x), ZeroIfNaN(given.y), ZeroIfNaN(given.z)};
    const Vec3V<V> usual = Scaled(Scaled(change, prescale), scale);
    const V largest = largest_of(change);
    const auto is_long = hn::Gt(largest_of(usual), limit), infinite = hn::Eq(largest, infinity);
    const auto part = [&](V x) {
      const V sign = hn::IfThenElseZero(hn::Eq(hn::Abs(x), infinity), hn::CopySign(one, x));
      return limit * hn::IfThenElse(infinite, sign, x / largest);
    };
    *dn = Select(is_long, Vec3V<V>{part(change.x), part(change.y), part(change.z)}, usual);
    // kLongStep is 2^60. Half of the division before the product keeps it within the range of floats.
    const V half = hn::Set(d, 0x1p-30f), rest = ((largest * half) * scale) * (half * prescale);
    *growth = hn::IfThenElse(hn::AndNot(infinite, is_long), hn::Min(rest, hn::Set(d, 0x1p127f)), one);
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
