// SPDX-License-Identifier: MIT
// Gooch et al., "A Non-Photorealistic Lighting Model" (1998).

#if defined(SHD_MATERIAL_GOOCH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_MATERIAL_GOOCH_INL_H_
#undef SHD_MATERIAL_GOOCH_INL_H_
#else
#define SHD_MATERIAL_GOOCH_INL_H_
#endif

#include "material/model-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::material::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// k_w (warm + warm_mix k_d) + (1 - k_w) (cool + cool_mix k_d), with k_w the mean of (1 + n.l) / 2 over the lights,
/// 1/2 without lights.
struct Gooch : ModelBase {
  static constexpr uint32_t kSlots = kColorSlots | kNormalSlots;

  struct Lighting : LightingBase {
    static constexpr uint32_t kLobes = 1;
    static constexpr bool kIgnoresIrradiance = true;
    static constexpr bool kAveragesNormals = false;

    template <class D, class V>
    static HWY_INLINE void Lobes(D d, const Material&, const V*, const Cosines<V>& in, const V*, V* lobe) {
      const V half = hn::Set(d, 0.5f);
      lobe[0] = half + half * in.n_dot_l;
    }
  };

  struct Combination {
    template <class D, class Slots, class V = hn::Vec<D>>
    static HWY_INLINE V Combine(D d, const ChannelAt<D, Slots>& c) {
      const Material& m = c.material;
      const V diffuse = c.Diffuse();
      const V warmth = c.light_count > 0.0f ? c.Lobe(0) / hn::Set(d, c.light_count) : hn::Set(d, 0.5f);
      const V warm = hn::Set(d, m.warm[c.channel]) + hn::Set(d, m.warm_mix) * diffuse;
      const V cool = hn::Set(d, m.cool[c.channel]) + hn::Set(d, m.cool_mix) * diffuse;
      return warmth * warm + (hn::Set(d, 1.0f) - warmth) * cool;
    }
  };
};

}  // namespace shd::material::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_MATERIAL_GOOCH_INL_H_
