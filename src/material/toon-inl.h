// SPDX-License-Identifier: MIT
// Lobes in steps.

#if defined(SHD_MATERIAL_TOON_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_MATERIAL_TOON_INL_H_
#undef SHD_MATERIAL_TOON_INL_H_
#else
#define SHD_MATERIAL_TOON_INL_H_
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace shd::material::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A cosine in 0..1 rounded up to a multiple of 1 / steps.
template <class D, class V>
HWY_INLINE V ToonDiffuse(D d, V cosine, float steps) {
  return hn::Min(hn::Div(hn::Ceil(hn::Mul(cosine, hn::Set(d, steps))), hn::Set(d, steps)), hn::Set(d, 1.0f));
}

/// 1 from a half on, else 0.
template <class D, class V>
HWY_INLINE V ToonSpecular(D d, V lobe) {
  return hn::IfThenElseZero(hn::Ge(lobe, hn::Set(d, 0.5f)), hn::Set(d, 1.0f));
}

}  // namespace shd::material::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_MATERIAL_TOON_INL_H_
