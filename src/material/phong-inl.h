// SPDX-License-Identifier: MIT
// Phong, "Illumination for Computer Generated Pictures" (1975).

#if defined(SHD_MATERIAL_PHONG_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_MATERIAL_PHONG_INL_H_
#undef SHD_MATERIAL_PHONG_INL_H_
#else
#define SHD_MATERIAL_PHONG_INL_H_
#endif

#include "material/specular-inl.h"
#include "simd/math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::material::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// max(0, wo.r) with r = 2 (n.l) n - l, the direction to the light mirrored at the normal. The vectors must be unit
/// vectors or 0.
template <class D, class V>
HWY_INLINE V MirroredCosine(D d, const Point<V>& point, const Vec3V<V>& l, V n_dot_l) {
  const V twice = n_dot_l + n_dot_l;
  const V o_dot_r = twice * Dot(point.n, point.wo) - Dot(point.wo, l);
  return hn::Min(hn::Max(o_dot_r, hn::Zero(d)), hn::Set(d, 1.0f));
}

struct MirroredCosineTerms {
  static constexpr uint32_t kCount = 1, kColumns = 0;
  template <class D, class V, class Choices>
  static HWY_INLINE void Find(D d, const Point<V>& point, const Vec3V<V>& l, V n_dot_l, const V*, Choices&, V* terms) {
    terms[0] = MirroredCosine(d, point, l, n_dot_l);
  }
};

/// The mirrored direction turns by twice the angle of n in the plane of wo and l, and by 2 h.l times the angle across
/// it; this is the mean precision of both, because h.l = |wo + l| / 2.
struct MirroredWidth {
  static constexpr int kNodes = 1;
  template <class D, class V>
  static HWY_INLINE V Precision(D, const V* shape, V length, V) {
    const V twice = shape[ExponentShape::kExponent] + shape[ExponentShape::kExponent];
    return twice * length;
  }
};

/// Lambert + sum of k_s E max(0, wo.r)^p.
struct Phong : SpecularBase {
  struct Lighting : SpecularLighting {
    using Terms = MirroredCosineTerms;
    using Width = MirroredWidth;

    template <class D, class V>
    static HWY_INLINE void Lobes(D d, const Material&, const V* terms, const Cosines<V>& in, const V* shape, V* lobe) {
      lobe[0] = in.cosine;
      lobe[1] = simd::HWY_NAMESPACE::UnitPow(d, terms[0], shape[Shape::kExponent]);
    }

    /// The integral of the whole lobe is 2 pi / (p + 1).
    template <class D, class V>
    static HWY_INLINE void AddEnvironment(D d, const Material&, const Surroundings<D>& from, const V* shape,
                                          V (&lobe)[2][3]) {
      const V one = hn::Set(d, 1.0f), precision = shape[Shape::kExponent] + one, inverse = one / precision;
      const auto place = environment::HWY_NAMESPACE::PhongPoint(d, inverse, from.n_dot_v);
      const V part = place.LookUp(d, from.lobes->phong);
      from.Irradiance(lobe[0]);
      from.Radiance(from.map.phong, from.r, precision, part * (hn::Set(d, 6.28318531f) * inverse), lobe[1]);
    }
  };
};

}  // namespace shd::material::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_MATERIAL_PHONG_INL_H_
