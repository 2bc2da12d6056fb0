// SPDX-License-Identifier: MIT
#include "procedural/solid.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/checker.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "procedural/wave-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::procedural::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// (1 - wave(x) wave(y) wave(z)) / 2 with square waves. The average of the product over a box is the product of the
/// averages.
struct CheckerPattern {
  const Solid& solid;

  template <bool kGradient, class D, class V>
  HWY_INLINE Sample<V> At(D d, const Place<V>& place) const {
    const V size = hn::Set(d, solid.size), half = hn::Set(d, 0.5f), width = place.width / size, zero = hn::Zero(d);
    const Wave<V> x = SquareWave<kGradient>(d, place.x / size, width);
    const Wave<V> y = SquareWave<kGradient>(d, place.y / size, width);
    const Wave<V> z = SquareWave<kGradient>(d, place.z / size, width);
    Sample<V> out = {half - half * (x.value * y.value * z.value), zero, zero, zero};
    if constexpr (kGradient) {
      out.dx = LimitSlope(d, hn::Neg(half) * (x.slope * y.value * z.value) / size);
      out.dy = LimitSlope(d, hn::Neg(half) * (x.value * y.slope * z.value) / size);
      out.dz = LimitSlope(d, hn::Neg(half) * (x.value * y.value * z.slope) / size);
    }
    return out;
  }
};

size_t Checker(const Solid& solid, const Places& places, const Values& out) {
  return Evaluate(CheckerPattern{solid}, places, out);
}

}  // namespace shd::procedural::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::procedural {

HWY_EXPORT(Checker);

size_t evaluate_checker(const Solid& solid, const core::SimdTarget& simd, const Places& places, const Values& out) {
  return SHD_DISPATCH(Checker, simd)(solid, places, out);
}

}  // namespace shd::procedural
#endif  // HWY_ONCE
