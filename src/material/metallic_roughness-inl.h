// SPDX-License-Identifier: MIT
// The metallic-roughness model of glTF 2.0, appendix B.

#if defined(SHD_MATERIAL_METALLIC_ROUGHNESS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_MATERIAL_METALLIC_ROUGHNESS_INL_H_
#undef SHD_MATERIAL_METALLIC_ROUGHNESS_INL_H_
#else
#define SHD_MATERIAL_METALLIC_ROUGHNESS_INL_H_
#endif

#include "material/roughness-inl.h"
#include "simd/math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::material::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Lobes of one light, divided by E, with f = (1 - v.h)^5.
template <class V>
struct MetallicRoughnessLobes {
  V diffuse;       // n.l (1 - f)
  V specular_f0;   // n.l D V (1 - f), with coefficient F0
  V specular_f90;  // n.l D V f, with coefficient F90 = 1
};

/// (n.sum)^2 (a^2 - 1) + |sum|^2 = (n.sum)^2 a^2 + |n x sum|^2, without cancellation near the centre of the highlight.
template <class D, class V>
HWY_INLINE V TrowbridgeReitzSpread(D d, const Vec3V<V>& n, const Vec3V<V>& sum, V alpha_squared) {
  const V n_dot_sum = hn::Max(Dot(n, sum), hn::Zero(d));
  const auto across = simd::HWY_NAMESPACE::Cross(n, sum);
  return n_dot_sum * n_dot_sum * alpha_squared + Dot(across, across);
}

/// Terms of the lobes of one light: the quotient of TrowbridgeReitzSpread() by |wo + l|^2, that square, and n.v, which
/// is clamped to at least 1e-4.
enum MicrofacetTerm : uint32_t { kSpread, kSquared, kNDotV, kMicrofacetTerms };

template <class D, class V, class Choices>
HWY_INLINE void MicrofacetTerms(D d, const Point<V>& point, const Vec3V<V>& l, V alpha_squared, Choices& choices,
                                V* terms) {
  const V one = hn::Set(d, 1.0f);
  const auto sum = Sum(point.wo, l);
  const V squared = Dot(sum, sum);
  const V inverse = one / choices.Select(hn::Gt(squared, hn::Zero(d)), squared, one);
  terms[kSpread] = TrowbridgeReitzSpread(d, point.n, sum, alpha_squared) * inverse;
  terms[kSquared] = squared;
  terms[kNDotV] = hn::Max(Dot(point.n, point.wo), hn::Set(d, 1e-4f));
}

struct RoughSurfaceTerms {
  static constexpr uint32_t kCount = kMicrofacetTerms, kColumns = RoughnessShape::kColumns;
  template <class D, class V, class Choices>
  static HWY_INLINE void Find(D d, const Point<V>& point, const Vec3V<V>& l, V, const V* shape, Choices& choices,
                              V* terms) {
    MicrofacetTerms(d, point, l, shape[RoughnessShape::kAlphaSquared], choices, terms);
  }
};

/// A Beckmann surface of equal width has slopes of variance alpha^2 / 2. Lobes that are narrow among the normals have
/// its precision k, wide lobes a fifth of k, because their tails count for normals far from the half vector.
struct MicrofacetWidth {
  static constexpr int kNodes = 4;
  template <class D, class V>
  static HWY_INLINE V Precision(D d, const V* shape, V, V variance) {
    const V k = hn::Set(d, 2.0f) / shape[RoughnessShape::kAlphaSquared];
    const V ratio = k * variance, squared = ratio * ratio;
    return k * ((hn::Set(d, 28.8f) + squared) / (hn::Set(d, 144.0f) + squared));
  }
};

/// D of Trowbridge and Reitz (Walter et al., "Microfacet Models for Refraction through Rough Surfaces", 2007) and the
/// masking and shadowing V of Heitz, "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs" (2014).
/// The result is 0 where wo + l = 0. Callers use the result only where n.l > 0.
template <class D, class V>
HWY_INLINE MetallicRoughnessLobes<V> EvaluateMetallicRoughness(D d, const V* terms, const Cosines<V>& in,
                                                               V alpha_squared) {
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  const V squared = terms[kSquared], n_dot_v = terms[kNDotV];
  const auto usable = hn::Gt(squared, zero);
  const V cosine = hn::Max(in.n_dot_l, zero);

  const V floor = hn::Max(terms[kSpread], hn::Set(d, 1e-12f));
  const V distribution = alpha_squared * hn::Set(d, simd::HWY_NAMESPACE::kInvPi) / (floor * floor);

  const V rest = one - alpha_squared;
  const auto shadowed = [&](V c) { return hn::Sqrt(c * c * rest + alpha_squared); };
  const V visibility = hn::Set(d, 0.5f) / (cosine * shadowed(n_dot_v) + n_dot_v * shadowed(cosine));

  // v.h = |v + l| / 2 for unit vectors.
  const V v_dot_h = hn::Min(hn::Set(d, 0.5f) * hn::Sqrt(squared), one);
  const V m = one - v_dot_h, m2 = m * m;
  const V f = m2 * m2 * m;
  const V lobe = hn::IfThenElseZero(usable, cosine * distribution * visibility);
  return {in.cosine * (one - f), lobe * (one - f), lobe * f};
}

/// The middle of a lobe of an environment: rough lobes turn from the reflected direction r towards the normal (Lagarde
/// and de Rousiers, "Moving Frostbite to Physically Based Rendering", 2014, section 4.9.3).
template <class D, class V>
HWY_INLINE Vec3V<V> LobeAxis(D d, const Vec3V<V>& n, const Vec3V<V>& r, V alpha_squared) {
  const V alpha = hn::Sqrt(alpha_squared), rest = hn::Set(d, 1.0f) - alpha;
  const V turn = rest * (hn::Sqrt(rest) + alpha);
  return {n.x + turn * (r.x - n.x), n.y + turn * (r.y - n.y), n.z + turn * (r.z - n.z)};
}

/// k_a I_a (b (1 - m) + F0) + sum of E max(0, n.l) (b (1 - m) (1 - f0) (1 - f) / pi + (F0 (1 - f) + f) D V) with base
/// colour b = k_d, metallic m, f0 the reflectance of the dielectric and F0 = f0 (1 - m) + b m.
struct MetallicRoughness : ModelBase {
  static constexpr uint32_t kSlots = kLitSlots | 1u << SHD_SLOT_METALLIC | 1u << SHD_SLOT_ROUGHNESS;
  static constexpr bool kColorsAmbient = true;

  struct Lighting : LightingBase {
    static constexpr uint32_t kLobes = 3;
    static constexpr bool kNeedsEye = true;
    using Shape = RoughnessShape;
    using Terms = RoughSurfaceTerms;
    using Width = MicrofacetWidth;

    template <class D, class V>
    static HWY_INLINE void Lobes(D d, const Material&, const V* terms, const Cosines<V>& in, const V* shape, V* lobe) {
      const auto lobes = EvaluateMetallicRoughness(d, terms, in, shape[Shape::kAlphaSquared]);
      lobe[0] = lobes.diffuse;
      lobe[1] = lobes.specular_f0;
      lobe[2] = lobes.specular_f90;
    }

    /// The mean radiance over the lobe for n = v = r, times the reflection of uniform light for the point's n.v (Karis,
    /// "Real Shading in Unreal Engine 4", 2013).
    static constexpr bool kReflectsEnvironment = true;
    static constexpr uint32_t kEnvironmentTables = SHD_ENVIRONMENT_TABLE_GGX;
    template <class D, class V>
    static HWY_INLINE void AddEnvironment(D d, const Material&, const Surroundings<D>& from, const V* shape,
                                          V (&lobe)[3][3]) {
      const environment::LobeTable& table = *from.lobes;
      const V precision = hn::Set(d, 1.0f) / shape[Shape::kAlphaSquared];
      const auto place = environment::HWY_NAMESPACE::GgxPoint(d, precision, from.n_dot_v);
      const V f0 = place.LookUp(d, table.ggx_f0), f90 = place.LookUp(d, table.ggx_f90);
      const V diffuse = place.LookUpRow(d, table.diffuse);
      from.Irradiance(lobe[0]);
      const Vec3V<V> axis = LobeAxis(d, from.n, from.r, shape[Shape::kAlphaSquared]);
      from.Radiance(from.map.ggx, axis, precision, hn::Set(d, 1.0f), lobe[1]);
      for (int c = 0; c < 3; ++c) {
        lobe[0][c] = lobe[0][c] * diffuse;
        lobe[2][c] = lobe[1][c] * f90;
        lobe[1][c] = lobe[1][c] * f0;
      }
    }
  };

  struct Combination {
    template <class D, class Slots, class V = hn::Vec<D>>
    static HWY_INLINE V Combine(D d, const ChannelAt<D, Slots>& c) {
      const V one = hn::Set(d, 1.0f), dielectric_f0 = hn::Set(d, c.material.dielectric_f0);
      const V base = c.Diffuse(), metallic = c.Metallic(), rest = one - metallic;
      const V scattering = base * rest;
      const V f0 = dielectric_f0 * rest + base * metallic;
      const V diffuse = scattering * (one - dielectric_f0) * hn::Set(d, simd::HWY_NAMESPACE::kInvPi);
      const V reflected = f0 * c.Lobe(1) + c.Lobe(2);
      return c.ambient * (scattering + f0) + (diffuse * c.Lobe(0) + reflected);
    }
  };
};

}  // namespace shd::material::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_MATERIAL_METALLIC_ROUGHNESS_INL_H_
