// SPDX-License-Identifier: MIT
// Light that arrives at a point.

#if defined(SHD_LIGHT_INCIDENT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_LIGHT_INCIDENT_INL_H_
#undef SHD_LIGHT_INCIDENT_INL_H_
#else
#define SHD_LIGHT_INCIDENT_INL_H_
#endif

#include "light/light.h"
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

/// A point or directional light seen from p. Point: 1 / max(r^2, 1e-8); nothing where r = 0 or r^2 overflows.
template <class D, class V>
HWY_INLINE Incident<V> IncidentAt(D d, const Light& light, const simd::HWY_NAMESPACE::Vec3V<V>& p) {
  const V one = hn::Set(d, 1.0f);
  if (light.kind == SHD_LIGHT_DIRECTIONAL) {
    return {{hn::Set(d, light.to_light[0]), hn::Set(d, light.to_light[1]), hn::Set(d, light.to_light[2])}, one};
  }
  const simd::HWY_NAMESPACE::Vec3V<V> to_light = {hn::Sub(hn::Set(d, light.position[0]), p.x),
                                                  hn::Sub(hn::Set(d, light.position[1]), p.y),
                                                  hn::Sub(hn::Set(d, light.position[2]), p.z)};
  const V squared = simd::HWY_NAMESPACE::Dot(to_light, to_light);
  const auto usable = hn::And(hn::Gt(squared, hn::Zero(d)), hn::Lt(squared, hn::Set(d, __builtin_inff())));
  const V safe = hn::IfThenElse(usable, squared, one);
  const V inverse = hn::Div(one, hn::Sqrt(safe));
  const V falloff = hn::IfThenElseZero(usable, hn::Div(one, hn::Max(safe, hn::Set(d, 1e-8f))));
  return {{hn::IfThenElseZero(usable, hn::Mul(to_light.x, inverse)),
           hn::IfThenElseZero(usable, hn::Mul(to_light.y, inverse)),
           hn::IfThenElseZero(usable, hn::Mul(to_light.z, inverse))},
          falloff};
}

}  // namespace shd::light::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_LIGHT_INCIDENT_INL_H_
