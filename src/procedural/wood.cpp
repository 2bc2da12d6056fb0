// SPDX-License-Identifier: MIT
#include "procedural/solid.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/wood.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "procedural/octaves-inl.h"
#include "procedural/perlin-inl.h"
#include "simd/round-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::procedural::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::RoundDown;

/// The cubic step from 0 at `begin` to 1 at `end`, and its derivative.
template <class D, class V>
HWY_INLINE Fade<V> SmoothStep(D d, float begin, float end, V t) {
  const V one = hn::Set(d, 1.0f), scale = hn::Set(d, 1.0f / (end - begin));
  const V part = hn::Max(hn::Min((t - hn::Set(d, begin)) * scale, one), hn::Zero(d));
  const Fade<V> step = FadeAt(d, SHD_SOLID_FADE_CUBIC, part);
  return {step.weight, step.slope * scale};
}

/// Rings around the y axis, distorted by Perlin noise: slow growth, then a sharp edge.
struct WoodPattern {
  const Solid& solid;

  template <bool kGradient, class D, class V>
  HWY_INLINE Sample<V> At(D d, const Place<V>& place) const {
    const V one = hn::Set(d, 1.0f), distortion = hn::Set(d, solid.distortion), mean = hn::Set(d, 0.515f);
    const Place<V> p = InCells(d, solid, place);
    const Sample<V> noise = SumOctaves<kGradient>(d, HashedPerlin{solid.fade}, solid, false, p);
    const V x = ClampCoordinate(d, p.x), z = ClampCoordinate(d, p.z);
    const V radius = hn::Sqrt(x * x + z * z);
    const V t = radius + distortion * noise.value;
    const V f = t - RoundDown(t), kept = BandLimit(d, p.width);
    const Fade<V> growth = SmoothStep(d, 0.0f, 0.8f, f), edge = SmoothStep(d, 0.83f, 1.0f, f);
    Sample<V> out = {mean + kept * ((growth.weight - edge.weight) - mean), noise.dx, noise.dy, noise.dz};
    if constexpr (kGradient) {
      const V slope = kept * (growth.slope - edge.slope);
      const V length = hn::IfThenElse(hn::Gt(radius, hn::Zero(d)), radius, one);
      out.dx = slope * (x / length + distortion * noise.dx);
      out.dy = slope * (distortion * noise.dy);
      out.dz = slope * (z / length + distortion * noise.dz);
    }
    out.value = hn::Max(hn::Min(out.value, one), hn::Zero(d));
    return PerUnit<kGradient>(d, solid, out);
  }
};

size_t Wood(const Solid& solid, const Places& places, const Values& out) {
  return Evaluate(WoodPattern{solid}, places, out);
}

}  // namespace shd::procedural::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::procedural {

HWY_EXPORT(Wood);

size_t evaluate_wood(const Solid& solid, const core::SimdTarget& simd, const Places& places, const Values& out) {
  return SHD_DISPATCH(Wood, simd)(solid, places, out);
}

}  // namespace shd::procedural
#endif  // HWY_ONCE
