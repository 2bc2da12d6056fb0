// SPDX-License-Identifier: MIT
// Exponent of a specular lobe.

#if defined(SHD_MATERIAL_EXPONENT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_MATERIAL_EXPONENT_INL_H_
#undef SHD_MATERIAL_EXPONENT_INL_H_
#else
#define SHD_MATERIAL_EXPONENT_INL_H_
#endif

#include "material/model-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::material::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Clamps an exponent to 0..1e6; NaN gives 0.
template <class D, class V>
HWY_INLINE V ClampExponent(D d, V p) {
  const V max = hn::Set(d, 1e6f);
  return hn::IfThenElse(hn::Lt(p, max), hn::IfThenElseZero(hn::Gt(p, hn::Zero(d)), p),
                        hn::IfThenElseZero(hn::Ge(p, max), max));
}

/// p' with 1 / p' = 1 / p + variance, and the gain (1 + p') / (1 + p), which preserves the reflected light of a lobe
/// that is not normalised (Toksvig, "Mipmapping Normal Maps", 2005).
struct ExponentShape {
  enum Column : uint32_t { kExponent, kGain, kColumns };
  static constexpr uint32_t kSlots = 1u << SHD_SLOT_EXPONENT;

  template <class D, class V>
  static HWY_INLINE void Derive(D d, const Material& m, const SlotsAt<D>& slots, V variance, V* shape) {
    const V one = hn::Set(d, 1.0f);
    const V p = ClampExponent(d, slots.Get(m.exponent, SHD_SLOT_EXPONENT, 0));
    shape[kExponent] = p / (one + p * variance);
    shape[kGain] = (one + shape[kExponent]) / (one + p);
  }

  template <class D, class V>
  static HWY_INLINE void Widen(D d, V variance, V* shape) {
    const V one = hn::Set(d, 1.0f), p = shape[kExponent];
    shape[kExponent] = p / (one + p * variance);
    shape[kGain] = shape[kGain] * ((one + shape[kExponent]) / (one + p));
  }
};

}  // namespace shd::material::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_MATERIAL_EXPONENT_INL_H_
