// SPDX-License-Identifier: MIT
// Specular lobe of Blinn, "Models of Light Reflection for Computer Synthesized Pictures" (1977).

#if defined(SHD_MATERIAL_BLINN_PHONG_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_MATERIAL_BLINN_PHONG_INL_H_
#undef SHD_MATERIAL_BLINN_PHONG_INL_H_
#else
#define SHD_MATERIAL_BLINN_PHONG_INL_H_
#endif

#include "simd/math-inl.h"
#include "simd/vec3-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::material::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// max(0, n.h)^p with h the unit half vector of wo and l; 0 where wo + l = 0. Unit vectors or 0.
template <class D, class V>
HWY_INLINE V BlinnPhong(D d, const simd::HWY_NAMESPACE::Vec3V<V>& n, const simd::HWY_NAMESPACE::Vec3V<V>& wo,
                        const simd::HWY_NAMESPACE::Vec3V<V>& l, V exponent) {
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  const auto sum = simd::HWY_NAMESPACE::Sum(wo, l);
  const V squared = simd::HWY_NAMESPACE::Dot(sum, sum);
  const auto usable = hn::Gt(squared, zero);
  const V length = hn::Sqrt(hn::IfThenElse(usable, squared, one));
  const V n_dot_h = hn::Div(simd::HWY_NAMESPACE::Dot(n, sum), length);
  const V cosine = hn::Min(hn::Max(n_dot_h, zero), one);
  return hn::IfThenElseZero(usable, simd::HWY_NAMESPACE::UnitPow(d, cosine, exponent));
}

/// N = (p + 2)(p + 4) / (8 pi (2^(-p/2) + p)): the inverse of the integral of (n.h)^p n.l over the directions l for wo
/// = n (Giesen, "Phong and Blinn-Phong Normalization Factors", 2009).
template <class D, class V>
HWY_INLINE V BlinnPhongNorm(D d, V p) {
  const V falling = simd::HWY_NAMESPACE::Exp2(d, hn::Mul(p, hn::Set(d, -0.5f)));
  const V above = hn::Mul(hn::Add(p, hn::Set(d, 2.0f)), hn::Add(p, hn::Set(d, 4.0f)));
  return hn::Div(above, hn::Mul(hn::Set(d, 25.1327412f), hn::Add(falling, p)));
}

}  // namespace shd::material::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_MATERIAL_BLINN_PHONG_INL_H_
