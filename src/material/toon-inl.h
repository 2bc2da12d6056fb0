// SPDX-License-Identifier: MIT
// Quantised Blinn-Phong.

#if defined(SHD_MATERIAL_TOON_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_MATERIAL_TOON_INL_H_
#undef SHD_MATERIAL_TOON_INL_H_
#else
#define SHD_MATERIAL_TOON_INL_H_
#endif

#include "material/blinn_phong-inl.h"
#include "simd/round-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::material::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::RoundUp;

/// Lambert plus the specular term of Blinn-Phong, with n.l rounded up to a multiple of 1 / toon_steps, and max(0,
/// n.h)^p replaced by 1 where it is at least 1/2, otherwise by 0.
struct Toon : SpecularBase {
  struct Lighting : SpecularLighting {
    using Terms = HalfCosineTerms;
    static constexpr bool kAveragesNormals = false;

    template <class D, class V>
    static HWY_INLINE void Lobes(D d, const Material& m, const V* terms, const Cosines<V>& in, const V* shape,
                                 V* lobe) {
      const V one = hn::Set(d, 1.0f), steps = hn::Set(d, m.toon_steps);
      lobe[0] = hn::Min(RoundUp(in.cosine * steps) / steps, one);
      const V highlight = simd::HWY_NAMESPACE::UnitPow(d, terms[0], shape[Shape::kExponent]);
      lobe[1] = hn::IfThenElseZero(hn::Ge(highlight, hn::Set(d, 0.5f)), one);
    }

    /// Many lights have no steps. The part of the directions with max(0, n.h)^p >= 1/2 is about ln 2 times the integral
    /// of the lobe.
    template <class D, class V>
    static HWY_INLINE void AddEnvironment(D d, const Material&, const Surroundings<D>& from, const V* shape,
                                          V (&lobe)[2][3]) {
      BlinnPhongSurroundings(d, from, shape[Shape::kExponent], from.lobes->blinn_phong,
                             0.693147181f * kBlinnPhongIntegral, lobe);
    }

    /// The gain is left out, because a step function has no energy to preserve.
    template <class D, class V>
    static HWY_INLINE void Normalize(D, const V*, V (&)[2][3]) {}
  };
};

}  // namespace shd::material::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_MATERIAL_TOON_INL_H_
