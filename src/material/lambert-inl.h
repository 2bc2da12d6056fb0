// SPDX-License-Identifier: MIT
// Lambert's cosine law.

#if defined(SHD_MATERIAL_LAMBERT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_MATERIAL_LAMBERT_INL_H_
#undef SHD_MATERIAL_LAMBERT_INL_H_
#else
#define SHD_MATERIAL_LAMBERT_INL_H_
#endif

#include "material/model-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::material::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// k_a I_a + sum of k_d E max(0, n.l).
struct Lambert : ModelBase {
  static constexpr uint32_t kSlots = kLitSlots;

  struct Lighting : LightingBase {
    static constexpr uint32_t kLobes = 1;

    template <class D, class V>
    static HWY_INLINE void Lobes(D, const Material&, const V*, const Cosines<V>& in, const V*, V* lobe) {
      lobe[0] = in.cosine;
    }

    static constexpr bool kReflectsEnvironment = true;
    template <class D, class V>
    static HWY_INLINE void AddEnvironment(D, const Material&, const Surroundings<D>& from, const V*, V (&lobe)[1][3]) {
      from.Irradiance(lobe[0]);
    }
  };

  struct Combination {
    template <class D, class Slots, class V = hn::Vec<D>>
    static HWY_INLINE V Combine(D, const ChannelAt<D, Slots>& c) {
      return c.ambient + c.Diffuse() * c.Lobe(0);
    }
  };
};

}  // namespace shd::material::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_MATERIAL_LAMBERT_INL_H_
