// SPDX-License-Identifier: MIT
// Parameters of lobes held in their range, and widened by the variance of slopes that lies below the pixel.

#if defined(SHD_MATERIAL_ROUGHNESS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_MATERIAL_ROUGHNESS_INL_H_
#undef SHD_MATERIAL_ROUGHNESS_INL_H_
#else
#define SHD_MATERIAL_ROUGHNESS_INL_H_
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace shd::material::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// An exponent in 0..1e6; 0 for NaN.
template <class D, class V>
HWY_INLINE V HeldExponent(D d, V p) {
  const V most = hn::Set(d, 1e6f);
  return hn::IfThenElse(hn::Lt(p, most), hn::IfThenElseZero(hn::Gt(p, hn::Zero(d)), p),
                        hn::IfThenElseZero(hn::Ge(p, most), most));
}

/// p' with 1 / p' = 1 / p + variance (Toksvig, "Mipmapping Normal Maps", 2005).
template <class D, class V>
HWY_INLINE V WidenExponent(D d, V p, V variance) {
  return hn::Div(p, hn::Add(hn::Set(d, 1.0f), hn::Mul(p, variance)));
}

/// alpha^2 with alpha = max(roughness^2, 0.001), roughness held in 0..1; 1 for NaN.
template <class D, class V>
HWY_INLINE V AlphaSquared(D d, V roughness) {
  const V one = hn::Set(d, 1.0f), least = hn::Set(d, 1e-3f);
  const V held = hn::IfThenElse(hn::Lt(roughness, one), roughness, one);
  const V square = hn::Mul(held, held);
  const V alpha = hn::IfThenElse(hn::And(hn::Gt(held, hn::Zero(d)), hn::Gt(square, least)), square, least);
  return hn::Mul(alpha, alpha);
}

/// min(1, alpha^2 + 2 variance): slopes of a GGX surface have no variance, of the Beckmann one of its width alpha^2
/// / 2.
template <class D, class V>
HWY_INLINE V WidenAlpha(D d, V alpha_squared, V variance) {
  const V sum = hn::Add(alpha_squared, hn::Add(variance, variance));
  const V one = hn::Set(d, 1.0f);
  return hn::IfThenElse(hn::Lt(sum, one), sum, one);
}

}  // namespace shd::material::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_MATERIAL_ROUGHNESS_INL_H_
