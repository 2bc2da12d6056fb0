// SPDX-License-Identifier: MIT
// Base of the textbook models: a diffuse lobe and a specular lobe with an exponent.

#if defined(SHD_MATERIAL_SPECULAR_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_MATERIAL_SPECULAR_INL_H_
#undef SHD_MATERIAL_SPECULAR_INL_H_
#else
#define SHD_MATERIAL_SPECULAR_INL_H_
#endif

#include "material/exponent-inl.h"
#include "material/model-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::material::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// max(0, n.h)^p is nearly a Gaussian of slopes with variance 1 / p (LEAN mapping, section 3).
struct HalfVectorWidth {
  static constexpr int kNodes = 1;
  template <class D, class V>
  static HWY_INLINE V Precision(D, const V* shape, V, V) {
    return shape[ExponentShape::kExponent];
  }
};

/// Lighting with a specular lobe, which is scaled by the gain of ExponentShape.
struct SpecularLighting : LightingBase {
  static constexpr uint32_t kLobes = 2;
  static constexpr bool kNeedsEye = true;
  static constexpr bool kMayBeUngated = true;
  using Shape = ExponentShape;
  using Width = HalfVectorWidth;

  static constexpr bool kReflectsEnvironment = true;
  static constexpr uint32_t kEnvironmentTables = SHD_ENVIRONMENT_TABLE_PHONG;

  template <class D, class V>
  static HWY_INLINE void Normalize(D, const V* shape, V (&sum)[2][3]) {
    for (V& channel : sum[1]) channel = channel * shape[Shape::kGain];
  }
};

/// k_a I_a + sum of E (k_d lobe 0 + k_s lobe 1), with the gain of ExponentShape on the specular lobe.
struct SpecularBase : ModelBase {
  static constexpr uint32_t kSlots = kLitSlots | 1u << SHD_SLOT_SPECULAR | 1u << SHD_SLOT_EXPONENT;

  struct Combination {
    template <class D, class Slots, class V = hn::Vec<D>>
    static HWY_INLINE V Combine(D, const ChannelAt<D, Slots>& c) {
      return c.ambient + c.Diffuse() * c.Lobe(0) + c.Specular() * c.Lobe(1);
    }
  };
};

}  // namespace shd::material::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_MATERIAL_SPECULAR_INL_H_
