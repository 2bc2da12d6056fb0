// SPDX-License-Identifier: MIT
// Blinn, "Models of Light Reflection for Computer Synthesized Pictures" (1977).

#if defined(SHD_MATERIAL_BLINN_PHONG_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_MATERIAL_BLINN_PHONG_INL_H_
#undef SHD_MATERIAL_BLINN_PHONG_INL_H_
#else
#define SHD_MATERIAL_BLINN_PHONG_INL_H_
#endif

#include "material/specular-inl.h"
#include "simd/math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::material::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// max(0, n.h) with h the unit half vector of wo and l; -1 where wo + l = 0. The vectors must be unit vectors or 0.
template <class D, class V, class Choices>
HWY_INLINE V HalfCosine(D d, const Point<V>& point, const Vec3V<V>& l, Choices& choices) {
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  const auto sum = Sum(point.wo, l);
  const V squared = Dot(sum, sum);
  const auto usable = hn::Gt(squared, zero);
  const V length = hn::Sqrt(choices.Select(usable, squared, one));
  const V n_dot_h = Dot(point.n, sum) / length;
  return choices.Select(usable, hn::Min(hn::Max(n_dot_h, zero), one), hn::Neg(one));
}

struct HalfCosineTerms {
  static constexpr uint32_t kCount = 1, kColumns = 0;
  template <class D, class V, class Choices>
  static HWY_INLINE void Find(D d, const Point<V>& point, const Vec3V<V>& l, V, const V*, Choices& choices, V* terms) {
    terms[0] = HalfCosine(d, point, l, choices);
  }
};

/// The lobe of an environment: the mean radiance over a Phong lobe of the exponent p / 4, which has the same width near
/// normal incidence, times the integral of the lobe of Blinn for the point's n.v.
template <class D, class V, class Sum>
HWY_INLINE void BlinnPhongSurroundings(D d, const Surroundings<D>& from, V p, const Sum& table, float factor,
                                       V (&lobe)[2][3]) {
  const V one = hn::Set(d, 1.0f), inverse = one / (p + one);
  const V sum = environment::HWY_NAMESPACE::BlinnPhongPoint(d, inverse, from.n_dot_v).LookUp(d, table);
  from.Irradiance(lobe[0]);
  from.Radiance(from.map.phong, from.r, hn::Set(d, 0.25f) * p + one, sum * (hn::Set(d, factor) * inverse), lobe[1]);
}
constexpr float kBlinnPhongIntegral = 25.1327412f;  // 8 pi

/// Lambert + sum of k_s E max(0, n.h)^p.
struct BlinnPhong : SpecularBase {
  struct Lighting : SpecularLighting {
    using Terms = HalfCosineTerms;

    template <class D, class V>
    static HWY_INLINE void Lobes(D d, const Material&, const V* terms, const Cosines<V>& in, const V* shape, V* lobe) {
      lobe[0] = in.cosine;
      lobe[1] = simd::HWY_NAMESPACE::UnitPow(d, terms[0], shape[Shape::kExponent]);
    }

    template <class D, class V>
    static HWY_INLINE void AddEnvironment(D d, const Material&, const Surroundings<D>& from, const V* shape,
                                          V (&lobe)[2][3]) {
      BlinnPhongSurroundings(d, from, shape[Shape::kExponent], from.lobes->blinn_phong, kBlinnPhongIntegral, lobe);
    }
  };
};

}  // namespace shd::material::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_MATERIAL_BLINN_PHONG_INL_H_
