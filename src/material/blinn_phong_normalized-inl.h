// SPDX-License-Identifier: MIT
// Giesen, "Phong and Blinn-Phong Normalization Factors" (2009).

#if defined(SHD_MATERIAL_BLINN_PHONG_NORMALIZED_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_MATERIAL_BLINN_PHONG_NORMALIZED_INL_H_
#undef SHD_MATERIAL_BLINN_PHONG_NORMALIZED_INL_H_
#else
#define SHD_MATERIAL_BLINN_PHONG_NORMALIZED_INL_H_
#endif

#include "material/blinn_phong-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::material::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// N = (p + 2)(p + 4) / (8 pi (2^(-p/2) + p)), the inverse of the integral of (n.h)^p n.l over the directions l for
/// wo = n.
template <class D, class V>
HWY_INLINE V BlinnPhongNorm(D d, V p) {
  const V falling = simd::HWY_NAMESPACE::Exp2(d, p * hn::Set(d, -0.5f));
  const V above = (p + hn::Set(d, 2.0f)) * (p + hn::Set(d, 4.0f));
  return above / (hn::Set(d, 25.1327412f) * (falling + p));
}

/// k_a I_a + sum of (k_d / pi + k_s N max(0, n.h)^p) E max(0, n.l).
struct BlinnPhongNormalized : SpecularBase {
  struct Lighting : SpecularLighting {
    using Terms = HalfCosineTerms;

    template <class D, class V>
    static HWY_INLINE void Lobes(D d, const Material&, const V* terms, const Cosines<V>& in, const V* shape, V* lobe) {
      const V power = simd::HWY_NAMESPACE::UnitPow(d, terms[0], shape[Shape::kExponent]);
      lobe[0] = in.cosine;
      lobe[1] = hn::Max(in.n_dot_l, hn::Zero(d)) * power;
    }

    template <class D, class V>
    static HWY_INLINE void AddEnvironment(D d, const Material&, const Surroundings<D>& from, const V* shape,
                                          V (&lobe)[2][3]) {
      BlinnPhongSurroundings(d, from, shape[Shape::kExponent], from.lobes->blinn_phong_cosine, kBlinnPhongIntegral,
                             lobe);
    }

    template <class D, class V>
    static HWY_INLINE void Normalize(D d, const V* shape, V (&sum)[2][3]) {
      const V norm = BlinnPhongNorm(d, shape[Shape::kExponent]);
      for (V& channel : sum[1]) channel = channel * norm;
    }
  };

  struct Combination {
    template <class D, class Slots, class V = hn::Vec<D>>
    static HWY_INLINE V Combine(D d, const ChannelAt<D, Slots>& c) {
      const V scattered = c.Diffuse() * hn::Set(d, simd::HWY_NAMESPACE::kInvPi) * c.Lobe(0);
      return c.ambient + scattered + c.Specular() * c.Lobe(1);
    }
  };
};

}  // namespace shd::material::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_MATERIAL_BLINN_PHONG_NORMALIZED_INL_H_
