// SPDX-License-Identifier: MIT
// The metallic-roughness model below a clear coat: the glTF extension KHR_materials_clearcoat.

#if defined(SHD_MATERIAL_CLEAR_COAT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_MATERIAL_CLEAR_COAT_INL_H_
#undef SHD_MATERIAL_CLEAR_COAT_INL_H_
#else
#define SHD_MATERIAL_CLEAR_COAT_INL_H_
#endif

#include "material/metallic_roughness-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::material::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// alpha^2 of the base; alpha^2 and strength of the coat, and its normal, whose columns shade/ provides.
struct ClearCoatShape {
  enum Column : uint32_t { kAlphaSquared, kCoatAlphaSquared, kCoat, kNormal, kColumns = kNormal + 3 };
  static_assert(static_cast<uint32_t>(kNormal) == kCoatNormalColumn);
  static constexpr uint32_t kSlots =
      1u << SHD_SLOT_ROUGHNESS | 1u << SHD_SLOT_CLEARCOAT | 1u << SHD_SLOT_CLEARCOAT_ROUGHNESS;

  template <class D, class V>
  static HWY_INLINE void Derive(D d, const Material& m, const SlotsAt<D>& slots, V variance, V* shape) {
    RoughnessShape::Derive(d, m, slots, variance, shape);
    shape[kCoatAlphaSquared] = AlphaSquared(d, slots.Get(m.coat_roughness, SHD_SLOT_CLEARCOAT_ROUGHNESS, 0));
    const V coat = slots.Get(m.coat, SHD_SLOT_CLEARCOAT, 0);
    shape[kCoat] = hn::IfThenElseZero(hn::Gt(coat, hn::Zero(d)), hn::Min(coat, hn::Set(d, 1.0f)));
    shape[kNormal] = shape[kNormal + 1] = hn::Zero(d);
    shape[kNormal + 2] = hn::Set(d, 1.0f);
  }

  template <class D, class V>
  static HWY_INLINE void Widen(D d, V variance, V* shape) {
    RoughnessShape::Widen(d, variance, shape);
    RoughnessShape::Widen(d, variance, shape + kCoatAlphaSquared);
  }

  template <class V>
  static HWY_INLINE Vec3V<V> Normal(const V* shape) {
    return {shape[kNormal], shape[kNormal + 1], shape[kNormal + 2]};
  }

  /// Part of the light that the coat reflects: Schlick's formula for an index of refraction of 1.5.
  template <class D, class V>
  static HWY_INLINE V Reflected(D d, const V* shape, V n_dot_v) {
    const V one = hn::Set(d, 1.0f);
    const V m = one - hn::Min(hn::Abs(n_dot_v), one), m2 = m * m;
    return shape[kCoat] * (hn::Set(d, 0.04f) + hn::Set(d, 0.96f) * (m2 * m2 * m));
  }
};

/// The terms of the base and of the coat, n_c.l, and the part of the light that the coat reflects.
struct ClearCoatTerms {
  enum Term : uint32_t { kCoat = kMicrofacetTerms, kCoatNDotL = 2 * kMicrofacetTerms, kReflected, kCount };
  static constexpr uint32_t kColumns = ClearCoatShape::kColumns;
  template <class D, class V, class Choices>
  static HWY_INLINE void Find(D d, const Point<V>& point, const Vec3V<V>& l, V, const V* shape, Choices& choices,
                              V* terms) {
    const Vec3V<V> n = ClearCoatShape::Normal(shape);
    MicrofacetTerms(d, point, l, shape[ClearCoatShape::kAlphaSquared], choices, terms);
    MicrofacetTerms(d, {n, point.wo}, l, shape[ClearCoatShape::kCoatAlphaSquared], choices, terms + kCoat);
    terms[kCoatNDotL] = Dot(n, l);
    terms[kReflected] = ClearCoatShape::Reflected(d, shape, Dot(n, point.wo));
  }
};

/// Metallic-roughness times 1 - c F(n_c.v), plus sum of E max(0, n_c.l) c F(n_c.v) D V, with coat c and its normal n_c.
struct ClearCoat : MetallicRoughness {
  static constexpr uint32_t kSlots =
      MetallicRoughness::kSlots | ClearCoatShape::kSlots | 1u << SHD_SLOT_CLEARCOAT_NORMAL;

  struct Lighting : MetallicRoughness::Lighting {
    static constexpr uint32_t kLobes = 4;
    static constexpr bool kGatesLobes = true;
    static constexpr bool kAveragesNormals = false;
    using Shape = ClearCoatShape;
    using Terms = ClearCoatTerms;

    template <class D, class V>
    static HWY_INLINE void Lobes(D d, const Material& m, const V* terms, const Cosines<V>& in, const V* shape,
                                 V* lobe) {
      const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
      const V n_dot_l = terms[Terms::kCoatNDotL], reflected = terms[Terms::kReflected], rest = one - reflected;
      MetallicRoughness::Lighting::Lobes(d, m, terms, in, shape, lobe);
      const auto faces = hn::Gt(in.n_dot_l, zero);
      for (uint32_t k = 0; k < 3; ++k) lobe[k] = hn::IfThenElseZero(faces, lobe[k] * rest);
      const Cosines<V> to_coat = {n_dot_l, hn::Max(n_dot_l, zero)};
      const auto coat = EvaluateMetallicRoughness(d, terms + Terms::kCoat, to_coat, shape[Shape::kCoatAlphaSquared]);
      lobe[3] = hn::IfThenElseZero(hn::Gt(n_dot_l, zero), reflected * (coat.specular_f0 + coat.specular_f90));
    }

    template <class D, class V>
    static HWY_INLINE void AddEnvironment(D d, const Material& m, const Surroundings<D>& from, const V* shape,
                                          V (&lobe)[4][3]) {
      const environment::LobeTable& table = *from.lobes;
      const V one = hn::Set(d, 1.0f), twice = from.n_dot_v + from.n_dot_v;
      const Vec3V<V> n = from.Rotated(Shape::Normal(shape));
      const Vec3V<V> v = {twice * from.n.x - from.r.x, twice * from.n.y - from.r.y, twice * from.n.z - from.r.z};
      const V n_dot_v = Dot(n, v), reflected = Shape::Reflected(d, shape, n_dot_v), rest = one - reflected;
      V base[3][3];
      MetallicRoughness::Lighting::AddEnvironment(d, m, from, shape, base);
      for (uint32_t k = 0; k < 9; ++k) lobe[k / 3][k % 3] = base[k / 3][k % 3] * rest;
      const V precision = one / shape[Shape::kCoatAlphaSquared], double_cosine = n_dot_v + n_dot_v;
      const auto place = environment::HWY_NAMESPACE::GgxPoint(d, precision, n_dot_v);
      const V sum = place.LookUp(d, table.ggx_f0) + place.LookUp(d, table.ggx_f90);
      const Vec3V<V> r = {double_cosine * n.x - v.x, double_cosine * n.y - v.y, double_cosine * n.z - v.z};
      from.Radiance(from.map.ggx, LobeAxis(d, n, r, shape[Shape::kCoatAlphaSquared]), precision, reflected * sum,
                    lobe[3]);
    }
  };

  struct Combination {
    template <class D, class Slots, class V = hn::Vec<D>>
    static HWY_INLINE V Combine(D d, const ChannelAt<D, Slots>& c) {
      return MetallicRoughness::Combination::Combine(d, c) + c.Lobe(3);
    }
  };
};

}  // namespace shd::material::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_MATERIAL_CLEAR_COAT_INL_H_
