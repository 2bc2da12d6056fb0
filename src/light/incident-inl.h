// SPDX-License-Identifier: MIT
// Incident light at a point.

#if defined(SHD_LIGHT_INCIDENT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_LIGHT_INCIDENT_INL_H_
#undef SHD_LIGHT_INCIDENT_INL_H_
#else
#define SHD_LIGHT_INCIDENT_INL_H_
#endif

#include "light/light.h"
#include "simd/choices-inl.h"
#include "simd/vec3-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::light::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Unit direction to a light and the factor on its intensity.
template <class V>
struct Incident {
  simd::HWY_NAMESPACE::Vec3V<V> l;
  V falloff;
};

/// Cone falloff of a spot, t^2 (3 - 2 t), for the cosine of the angle to its axis.
template <class D, class V>
HWY_INLINE V Cone(D d, const Light& light, V cosine) {
  const V t = hn::Set(d, light.cone_scale) * (cosine - hn::Set(d, light.cone_start));
  const V clamped = hn::Min(hn::Max(t, hn::Zero(d)), hn::Set(d, 1.0f));
  return clamped * clamped * (hn::Set(d, 3.0f) - (clamped + clamped));
}

/// Incident light at p, for all kinds except ambient, without cookie and shadow. falloff is E / I, 0 where r = 0 or r^2
/// overflows.
template <class D, class V, class Choices>
HWY_INLINE Incident<V> IncidentAt(D d, const Light& light, const simd::HWY_NAMESPACE::Vec3V<V>& p, Choices& choices) {
  const V one = hn::Set(d, 1.0f), zero = hn::Zero(d);
  if (light.kind == SHD_LIGHT_KIND_DIRECTIONAL) return {simd::HWY_NAMESPACE::Set3(d, light.to_light), one};
  const auto to_light = simd::HWY_NAMESPACE::Difference(simd::HWY_NAMESPACE::Set3(d, light.position), p);
  const V squared = simd::HWY_NAMESPACE::Dot(to_light, to_light);
  const auto usable = hn::And(hn::Gt(squared, zero), hn::Lt(squared, hn::Inf(d)));
  const V safe = choices.Select(usable, squared, one);
  const V inverse = one / hn::Sqrt(safe);
  V falloff = choices.OrZero(usable, one / choices.AtLeast(safe, hn::Set(d, 1e-8f)));
  const simd::HWY_NAMESPACE::Vec3V<V> l = {choices.OrZero(usable, to_light.x * inverse),
                                           choices.OrZero(usable, to_light.y * inverse),
                                           choices.OrZero(usable, to_light.z * inverse)};
  if (light.range > 0.0f) {
    const V ratio = safe * hn::Set(d, light.inverse_range_squared);
    falloff = falloff * hn::Max(one - ratio * ratio, zero);
  }
  if (light.kind == SHD_LIGHT_KIND_SPOT) {
    const auto axis = simd::HWY_NAMESPACE::Set3(d, light.to_light);
    falloff = falloff * Cone(d, light, simd::HWY_NAMESPACE::Dot(axis, l));
  }
  return {l, falloff};
}

}  // namespace shd::light::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_LIGHT_INCIDENT_INL_H_
