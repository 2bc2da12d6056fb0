// SPDX-License-Identifier: MIT
#include "light/projector.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "light/projector.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "simd/finite-inl.h"
#include "simd/vec3-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::light::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::Difference;
using simd::HWY_NAMESPACE::Dot;
using simd::HWY_NAMESPACE::IsFinite;
using simd::HWY_NAMESPACE::Load3;
using simd::HWY_NAMESPACE::Set3;

void Project(const Light& light, size_t count, const float* const* p, float* u, float* v) {
  const hn::ScalableTag<float> d;
  using Vf = hn::Vec<decltype(d)>;
  const Vf half = hn::Set(d, 0.5f), one = hn::Set(d, 1.0f), zero = hn::Zero(d), outside = hn::Set(d, -1.0f);
  const Vf scale_x = hn::Set(d, light.cookie_scale[0]), scale_y = hn::Set(d, light.cookie_scale[1]);
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto q = Difference(Load3(d, p[0], p[1], p[2], i), Set3(d, light.position));
    Vf x = Dot(q, Set3(d, light.right)) * scale_x, y = Dot(q, Set3(d, light.up)) * scale_y;
    auto usable = hn::Eq(zero, zero);
    if (light.kind == SHD_LIGHT_KIND_SPOT) {
      const Vf distance = hn::Neg(Dot(q, Set3(d, light.to_light)));
      usable = hn::Gt(distance, zero);
      const Vf safe = hn::IfThenElse(usable, distance, one);
      x = x / safe;
      y = y / safe;
    }
    usable = hn::And(usable, hn::And(IsFinite(d, x), IsFinite(d, y)));
    hn::Store(hn::IfThenElse(usable, half + half * x, outside), d, u + i);
    hn::Store(hn::IfThenElse(usable, half - half * y, outside), d, v + i);
  }
}

}  // namespace shd::light::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::light {

HWY_EXPORT(Project);

void project(const core::SimdTarget& simd, const Light& light, size_t count, const float* const p[3], float* u,
             float* v) {
  SHD_DISPATCH(Project, simd)(light, count, p, u, v);
}

}  // namespace shd::light
#endif  // HWY_ONCE
