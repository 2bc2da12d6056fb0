// SPDX-License-Identifier: MIT
// Shirley and Marschner, "Fundamentals of Computer Graphics" (2009), section 10.2.

#if defined(SHD_MATERIAL_COMBINED_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_MATERIAL_COMBINED_INL_H_
#undef SHD_MATERIAL_COMBINED_INL_H_
#else
#define SHD_MATERIAL_COMBINED_INL_H_
#endif

#include "material/blinn_phong-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::material::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// k_d (I_a + sum of E max(0, n.l)) + sum of E k_s max(0, n.h)^p.
struct Combined : BlinnPhong {
  static constexpr uint32_t kSlots = BlinnPhong::kSlots & ~(1u << SHD_SLOT_AMBIENT);
  static constexpr bool kColorsAmbient = true;

  struct Combination {
    template <class D, class Slots, class V = hn::Vec<D>>
    static HWY_INLINE V Combine(D, const ChannelAt<D, Slots>& c) {
      return c.Diffuse() * (c.ambient + c.Lobe(0)) + c.Specular() * c.Lobe(1);
    }
  };
};

}  // namespace shd::material::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_MATERIAL_COMBINED_INL_H_
