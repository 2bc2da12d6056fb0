// SPDX-License-Identifier: MIT
// A clear solid that reflects and refracts.

#if defined(SHD_MATERIAL_GLASS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_MATERIAL_GLASS_INL_H_
#undef SHD_MATERIAL_GLASS_INL_H_
#else
#define SHD_MATERIAL_GLASS_INL_H_
#endif

#include "material/metallic_roughness-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::material::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Direction in which the line of sight leaves a sphere of glass that it enters at the unit normal n: the refraction
/// (Snell's law) turns it twice by the same angle.
template <class D, class V>
HWY_INLINE Vec3V<V> SeenThroughSphere(D d, const Surroundings<D>& from, V ior) {
  const V one = hn::Set(d, 1.0f), eta = one / ior, cosine = hn::Max(from.n_dot_v, hn::Zero(d));
  const V twice = from.n_dot_v + from.n_dot_v;
  const Vec3V<V> in = {from.r.x - twice * from.n.x, from.r.y - twice * from.n.y, from.r.z - twice * from.n.z};
  const V inside = hn::Sqrt(hn::Max(one - eta * eta * (one - cosine * cosine), hn::Zero(d)));
  const V along = eta * cosine - inside;
  const Vec3V<V> t = {eta * in.x + along * from.n.x, eta * in.y + along * from.n.y, eta * in.z + along * from.n.z};
  const V turn = Dot(t, in), both = turn + turn;
  return {both * t.x - in.x, both * t.y - in.y, both * t.z - in.z};
}

/// k_a I_a + sum of E max(0, n.l) F D V + k_d (1 - F) L with L the radiance of the environment through the solid.
struct Glass : ModelBase {
  static constexpr uint32_t kSlots = kLitSlots | 1u << SHD_SLOT_ROUGHNESS;

  struct Lighting : MetallicRoughness::Lighting {
    static constexpr uint32_t kLobes = 2;

    template <class D, class V>
    static HWY_INLINE void Lobes(D d, const Material& m, const V* terms, const Cosines<V>& in, const V* shape,
                                 V* lobe) {
      const auto lobes = EvaluateMetallicRoughness(d, terms, in, shape[Shape::kAlphaSquared]);
      lobe[0] = hn::Zero(d);
      lobe[1] = hn::Set(d, m.dielectric_f0) * lobes.specular_f0 + lobes.specular_f90;
    }

    template <class D, class V>
    static HWY_INLINE void AddEnvironment(D d, const Material& m, const Surroundings<D>& from, const V* shape,
                                          V (&lobe)[2][3]) {
      const environment::LobeTable& table = *from.lobes;
      const V one = hn::Set(d, 1.0f), precision = one / shape[Shape::kAlphaSquared];
      const auto place = environment::HWY_NAMESPACE::GgxPoint(d, precision, from.n_dot_v);
      const V reflected = hn::Set(d, m.dielectric_f0) * place.LookUp(d, table.ggx_f0) + place.LookUp(d, table.ggx_f90);
      from.Radiance(from.map.ggx, SeenThroughSphere(d, from, hn::Set(d, m.ior)), precision, one - reflected, lobe[0]);
      from.Radiance(from.map.ggx, from.r, precision, reflected, lobe[1]);
    }
  };

  struct Combination {
    template <class D, class Slots, class V = hn::Vec<D>>
    static HWY_INLINE V Combine(D, const ChannelAt<D, Slots>& c) {
      return c.ambient + c.Diffuse() * c.Lobe(0) + c.Lobe(1);
    }
  };
};

}  // namespace shd::material::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_MATERIAL_GLASS_INL_H_
