// SPDX-License-Identifier: MIT
#include "procedural/solid.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/marble.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "procedural/octaves-inl.h"
#include "procedural/perlin-inl.h"
#include "simd/math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::procedural::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Waves across x, distorted by the turbulence of Perlin noise. Perlin, "An Image Synthesizer" (1985).
struct MarblePattern {
  const Solid& solid;

  template <bool kGradient, class D, class V>
  HWY_INLINE Sample<V> At(D d, const Place<V>& place) const {
    using simd::HWY_NAMESPACE::CosPi;
    using simd::HWY_NAMESPACE::SinPi;
    const V half = hn::Set(d, 0.5f), one = hn::Set(d, 1.0f), distortion = hn::Set(d, solid.distortion);
    const Place<V> p = InCells(d, solid, place);
    const Sample<V> noise = SumOctaves<kGradient>(d, HashedPerlin{solid.fade}, solid, true, p);
    const V t = ClampCoordinate(d, p.x) + distortion * noise.value;
    const V height = half * BandLimit(d, half * p.width);
    Sample<V> out = {half + height * SinPi(d, t), noise.dx, noise.dy, noise.dz};
    if constexpr (kGradient) {
      const V slope = hn::Set(d, 3.14159265f) * (height * CosPi(d, t));
      out.dx = slope * (one + distortion * noise.dx);
      out.dy = slope * (distortion * noise.dy);
      out.dz = slope * (distortion * noise.dz);
    }
    out.value = hn::Max(hn::Min(out.value, one), hn::Zero(d));
    return PerUnit<kGradient>(d, solid, out);
  }
};

size_t Marble(const Solid& solid, const Places& places, const Values& out) {
  return Evaluate(MarblePattern{solid}, places, out);
}

}  // namespace shd::procedural::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::procedural {

HWY_EXPORT(Marble);

size_t evaluate_marble(const Solid& solid, const core::SimdTarget& simd, const Places& places, const Values& out) {
  return SHD_DISPATCH(Marble, simd)(solid, places, out);
}

}  // namespace shd::procedural
#endif  // HWY_ONCE
