// SPDX-License-Identifier: MIT
// Specular lobe of Phong, "Illumination for Computer Generated Pictures" (1975).

#if defined(SHD_MATERIAL_PHONG_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_MATERIAL_PHONG_INL_H_
#undef SHD_MATERIAL_PHONG_INL_H_
#else
#define SHD_MATERIAL_PHONG_INL_H_
#endif

#include "simd/math-inl.h"
#include "simd/vec3-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::material::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// max(0, wo.r)^p with r = 2 (n.l) n - l, the mirrored direction of the light. Unit vectors or 0.
template <class D, class V>
HWY_INLINE V Phong(D d, const simd::HWY_NAMESPACE::Vec3V<V>& n, const simd::HWY_NAMESPACE::Vec3V<V>& wo,
                   const simd::HWY_NAMESPACE::Vec3V<V>& l, V n_dot_l, V exponent) {
  const V twice = hn::Add(n_dot_l, n_dot_l);
  const V o_dot_r = hn::Sub(hn::Mul(twice, simd::HWY_NAMESPACE::Dot(n, wo)), simd::HWY_NAMESPACE::Dot(wo, l));
  const V cosine = hn::Min(hn::Max(o_dot_r, hn::Zero(d)), hn::Set(d, 1.0f));
  return simd::HWY_NAMESPACE::UnitPow(d, cosine, exponent);
}

}  // namespace shd::material::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_MATERIAL_PHONG_INL_H_
