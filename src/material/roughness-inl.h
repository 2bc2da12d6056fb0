// SPDX-License-Identifier: MIT
// Roughness of a microfacet lobe.

#if defined(SHD_MATERIAL_ROUGHNESS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_MATERIAL_ROUGHNESS_INL_H_
#undef SHD_MATERIAL_ROUGHNESS_INL_H_
#else
#define SHD_MATERIAL_ROUGHNESS_INL_H_
#endif

#include "material/model-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::material::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// alpha^2 with alpha = max(roughness^2, 0.001), roughness clamped to 0..1; 1 for NaN.
template <class D, class V>
HWY_INLINE V AlphaSquared(D d, V roughness) {
  const V one = hn::Set(d, 1.0f), min_alpha = hn::Set(d, 1e-3f);
  const V clamped = hn::IfThenElse(hn::Lt(roughness, one), roughness, one);
  const V square = clamped * clamped;
  const V alpha = hn::IfThenElse(hn::And(hn::Gt(clamped, hn::Zero(d)), hn::Gt(square, min_alpha)), square, min_alpha);
  return alpha * alpha;
}

/// alpha^2 = min(1, roughness^4 + 2 variance). The slopes of a GGX surface have no finite
/// variance; the slopes of a Beckmann surface of equal width have the variance alpha^2 / 2.
struct RoughnessShape {
  enum Column : uint32_t { kAlphaSquared, kColumns };
  static constexpr uint32_t kSlots = 1u << SHD_SLOT_ROUGHNESS;

  template <class D, class V>
  static HWY_INLINE void Derive(D d, const Material& m, const SlotsAt<D>& slots, V variance, V* shape) {
    const V one = hn::Set(d, 1.0f);
    const V own = AlphaSquared(d, slots.Get(m.roughness, SHD_SLOT_ROUGHNESS, 0));
    const V sum = own + (variance + variance);
    shape[kAlphaSquared] = hn::IfThenElse(hn::Lt(sum, one), sum, one);
  }

  template <class D, class V>
  static HWY_INLINE void Widen(D d, V variance, V* shape) {
    shape[kAlphaSquared] = hn::Min(shape[kAlphaSquared] + (variance + variance), hn::Set(d, 1.0f));
  }
};

}  // namespace shd::material::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_MATERIAL_ROUGHNESS_INL_H_
