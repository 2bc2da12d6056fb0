// SPDX-License-Identifier: MIT
// The metallic-roughness lobes of glTF 2.0, appendix B.

#if defined(SHD_MATERIAL_METALLIC_ROUGHNESS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_MATERIAL_METALLIC_ROUGHNESS_INL_H_
#undef SHD_MATERIAL_METALLIC_ROUGHNESS_INL_H_
#else
#define SHD_MATERIAL_METALLIC_ROUGHNESS_INL_H_
#endif

#include "simd/vec3-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::material::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// What one light gives, over E.
template <class V>
struct MetallicRoughness {
  V diffuse;  // n.l (1 - f), f = (1 - v.h)^5
  V mirror;   // n.l D V (1 - f): times F0
  V edge;     // n.l D V f
};

/// D of Trowbridge and Reitz (Walter et al., "Microfacet Models for Refraction through Rough Surfaces", 2007) and the
/// masking and shadowing V of Heitz, "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs" (2014).
/// n.v counts as 1e-4 where it is less; 0 where wo + l = 0. n_dot_l > 0 where the result is used.
template <class D, class V>
HWY_INLINE MetallicRoughness<V> MetallicRoughnessLobes(D d, const simd::HWY_NAMESPACE::Vec3V<V>& n,
                                                       const simd::HWY_NAMESPACE::Vec3V<V>& wo,
                                                       const simd::HWY_NAMESPACE::Vec3V<V>& l, V n_dot_l,
                                                       V alpha_squared) {
  using simd::HWY_NAMESPACE::Cross;
  using simd::HWY_NAMESPACE::Dot;
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  const auto sum = simd::HWY_NAMESPACE::Sum(wo, l);
  const V squared = Dot(sum, sum);
  const auto usable = hn::Gt(squared, zero);
  const V inverse = hn::Div(one, hn::IfThenElse(usable, squared, one));
  const V cosine = hn::Max(n_dot_l, zero);
  const V n_dot_v = hn::Max(Dot(n, wo), hn::Set(d, 1e-4f));

  // (n.h)^2 (a^2 - 1) + 1 = (n.h)^2 a^2 + |n x h|^2, without the cancellation near the highlight's middle.
  const V n_dot_sum = hn::Max(Dot(n, sum), zero);
  const auto across = Cross(n, sum);
  const V spread =
      hn::Mul(hn::Add(hn::Mul(hn::Mul(n_dot_sum, n_dot_sum), alpha_squared), Dot(across, across)), inverse);
  const V floor = hn::Max(spread, hn::Set(d, 1e-12f));
  const V distribution = hn::Div(hn::Mul(alpha_squared, hn::Set(d, 0.318309886f)), hn::Mul(floor, floor));

  const V rest = hn::Sub(one, alpha_squared);
  const auto shadowed = [&](V c) { return hn::Sqrt(hn::Add(hn::Mul(hn::Mul(c, c), rest), alpha_squared)); };
  const V visibility =
      hn::Div(hn::Set(d, 0.5f), hn::Add(hn::Mul(cosine, shadowed(n_dot_v)), hn::Mul(n_dot_v, shadowed(cosine))));

  // v.h = |v + l| / 2 of unit vectors.
  const V v_dot_h = hn::Min(hn::Mul(hn::Set(d, 0.5f), hn::Sqrt(squared)), one);
  const V m = hn::Sub(one, v_dot_h), m2 = hn::Mul(m, m);
  const V f = hn::Mul(hn::Mul(m2, m2), m);
  const V lobe = hn::IfThenElseZero(usable, hn::Mul(hn::Mul(cosine, distribution), visibility));
  return {hn::Mul(cosine, hn::Sub(one, f)), hn::Mul(lobe, hn::Sub(one, f)), hn::Mul(lobe, f)};
}

}  // namespace shd::material::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_MATERIAL_METALLIC_ROUGHNESS_INL_H_
