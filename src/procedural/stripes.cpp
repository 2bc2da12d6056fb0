// SPDX-License-Identifier: MIT
#include "procedural/solid.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/stripes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "procedural/wave-inl.h"
#include "simd/round-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::procedural::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::RoundDown;

/// 0 where sin(pi x) > 0, otherwise 1: (1 - wave) / 2 with the square wave of x.
struct StripesPattern {
  const Solid& solid;

  template <bool kGradient, class D, class V>
  HWY_INLINE Sample<V> At(D d, const Place<V>& place) const {
    const V size = hn::Set(d, solid.size), half = hn::Set(d, 0.5f), zero = hn::Zero(d);
    const V x = place.x / size;
    const Wave<V> wave = SquareWave<kGradient>(d, x, place.width / size);
    // At the integers the sine is 0, and the wave 1 or -1.
    const auto zero_of_sine = hn::And(hn::Eq(x, RoundDown(x)), wave.is_sharp);
    Sample<V> out = {hn::IfThenElse(zero_of_sine, hn::Set(d, 1.0f), half - half * wave.value), zero, zero, zero};
    if constexpr (kGradient) out.dx = LimitSlope(d, hn::Neg(half) * wave.slope / size);
    return out;
  }
};

size_t Stripes(const Solid& solid, const Places& places, const Values& out) {
  return Evaluate(StripesPattern{solid}, places, out);
}

}  // namespace shd::procedural::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::procedural {

HWY_EXPORT(Stripes);

size_t evaluate_stripes(const Solid& solid, const core::SimdTarget& simd, const Places& places, const Values& out) {
  return SHD_DISPATCH(Stripes, simd)(solid, places, out);
}

}  // namespace shd::procedural
#endif  // HWY_ONCE
