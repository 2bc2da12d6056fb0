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

/// max(0, n.h)^p with h the unit half vector of wo and l; 0 where wo + l = 0. The vectors must be unit vectors or 0.
template <class D, class V>
HWY_INLINE V BlinnPhongLobe(D d, const Point<V>& point, const Incoming<V>& in, V exponent) {
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  const auto sum = Sum(point.wo, in.l);
  const V squared = Dot(sum, sum);
  const auto usable = hn::Gt(squared, zero);
  const V length = hn::Sqrt(hn::IfThenElse(usable, squared, one));
  const V n_dot_h = Dot(point.n, sum) / length;
  const V cosine = hn::Min(hn::Max(n_dot_h, zero), one);
  return hn::IfThenElseZero(usable, simd::HWY_NAMESPACE::UnitPow(d, cosine, exponent));
}

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
    template <class D, class V>
    static HWY_INLINE void AddLight(D d, const Material&, const Point<V>& point, const Incoming<V>& in, const V* shape,
                                    V* lobe) {
      lobe[0] = in.cosine;
      lobe[1] = BlinnPhongLobe(d, point, in, shape[Shape::kExponent]);
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
