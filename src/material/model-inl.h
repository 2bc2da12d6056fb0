// SPDX-License-Identifier: MIT
// Members of the structs of the models, and the arguments of their functions.

#if defined(SHD_MATERIAL_MODEL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_MATERIAL_MODEL_INL_H_
#undef SHD_MATERIAL_MODEL_INL_H_
#else
#define SHD_MATERIAL_MODEL_INL_H_
#endif

#include "environment/look_up-inl.h"
#include "material/material.h"
#include "simd/choices-inl.h"
#include "simd/vec3-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::material::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using simd::HWY_NAMESPACE::Dot;
using simd::HWY_NAMESPACE::Sum;
using simd::HWY_NAMESPACE::Vec3V;

/// A point on a surface: unit normal, and unit vector to the eye (unspecified without kNeedsEye).
template <class V>
struct Point {
  Vec3V<V> n, wo;
};

/// One light at a point. `cosine` is max(0, n.l), or its mean over the normals of a filtered normal map, one of which
/// has n_dot_l.
template <class V>
struct Cosines {
  V n_dot_l;
  V cosine;
};

/// The light of an environment at a point: its normal n and the direction r of mirror reflection, in the space of the
/// environment's maps.
template <class D>
struct Surroundings {
  using V = hn::Vec<D>;
  const environment::Environment& map;
  const environment::LobeTable* lobes;  // null for models without kEnvironmentTables
  D d;
  const float* world_to_map;  // column-major rotation
  Vec3V<V> n, r;
  V n_dot_v;

  /// Takes n and r in world space. gcc 12 clears aggregates of vectors before it initialises them, which costs 2 % of
  /// a frame.
  HWY_INLINE Surroundings(D tag, const environment::Environment& environment, const environment::LobeTable* table,
                          const float* rotation, const Vec3V<V>& normal, const Vec3V<V>& reflected, V cosine)
      : map(environment),
        lobes(table),
        d(tag),
        world_to_map(rotation),
        n(Rotated(normal)),
        r(Rotated(reflected)),
        n_dot_v(cosine) {}

  HWY_INLINE Vec3V<V> Rotated(const Vec3V<V>& v) const {
    const float* m = world_to_map;
    const auto row = [&](int k) HWY_ATTR {
      return hn::Set(d, m[k]) * v.x + hn::Set(d, m[3 + k]) * v.y + hn::Set(d, m[6 + k]) * v.z;
    };
    return {row(0), row(1), row(2)};
  }

  /// Sets the channels of a lobe to the irradiance.
  HWY_INLINE void Irradiance(V (&lobe)[3]) const {
    const auto color = environment::HWY_NAMESPACE::Irradiance(d, map, n);
    for (int c = 0; c < 3; ++c) lobe[c] = color.channel[c];
  }

  /// Sets the channels of a lobe to the mean radiance over the lobe of a precision around a direction, times a factor.
  HWY_INLINE void Radiance(const environment::Chain& chain, const Vec3V<V>& axis, V precision, V factor,
                           V (&lobe)[3]) const {
    namespace env = environment::HWY_NAMESPACE;
    const auto color =
        env::LookUpChain(d, map.texels.data(), chain, env::SquarePoint(d, axis), env::PrecisionLog2(d, precision));
    for (int c = 0; c < 3; ++c) lobe[c] = color.channel[c] * factor;
  }
};

/// Values of slots at points from i on. No column is null: see complete().
template <class D>
struct SlotsAt {
  using V = hn::Vec<D>;
  const Parameters& parameters;
  D d;
  size_t i;

  /// A constant of the material times the value of its slot.
  HWY_INLINE V Get(float constant, uint32_t slot, int channel) const {
    return hn::Set(d, constant) * hn::Load(d, parameters.value[slot][channel] + i);
  }
};

/// Values of slots at points from i on, of which only the diffuse slot has values.
template <class D>
struct DiffuseAt {
  using V = hn::Vec<D>;
  const float* const (&diffuse)[3];
  D d;
  size_t i;

  /// As SlotsAt::Get(): the value of another slot is 1, and a factor of 1 changes no bit.
  HWY_INLINE V Get(float constant, uint32_t slot, int channel) const {
    const V factor = hn::Set(d, constant);
    return slot == SHD_SLOT_DIFFUSE ? factor * hn::Load(d, diffuse[channel] + i) : factor;
  }
};

/// Coefficients and lobes of one channel at points from i on. `Slots` is SlotsAt or DiffuseAt.
template <class D, class Slots>
struct ChannelAt {
  using V = hn::Vec<D>;
  const Material& material;
  const Slots slots;
  const Lobes& lobes;
  int channel;
  float light_count;
  V ambient;  // k_a I_a with occlusion

  HWY_INLINE V Diffuse() const { return slots.Get(material.diffuse[channel], SHD_SLOT_DIFFUSE, channel); }
  HWY_INLINE V Specular() const { return slots.Get(material.specular[channel], SHD_SLOT_SPECULAR, channel); }
  HWY_INLINE V Metallic() const { return slots.Get(material.metallic, SHD_SLOT_METALLIC, 0); }
  HWY_INLINE V Lobe(int k) const { return hn::Load(slots.d, lobes.lobe[k][channel] + slots.i); }
};

/// Shape of lobes that depend only on the light and the normal.
struct NoShape {
  static constexpr uint32_t kSlots = 0, kColumns = 0;
  template <class D, class V>
  static HWY_INLINE void Derive(D, const Material&, const SlotsAt<D>&, V, V*) {}
  template <class D, class V>
  static HWY_INLINE void Widen(D, V, V*) {}
};

/// Values that Lighting::Terms finds for Lighting::Lobes: the lobes of one light are computed in two steps, so that
/// each runs in a short loop over many points. Models with the same values share a struct, and the loop that finds
/// them:
///   kCount    number of values
///   kColumns  number of the first values of Shape that it reads
///   Find(d, point, l, n_dot_l, shape, choices, terms)
/// where l is the unit vector to a light, and `choices` makes choices that nearly all points decide in one way: see
/// choices-inl.h.
struct NoTerms {
  static constexpr uint32_t kCount = 0, kColumns = 0;
  template <class D, class V, class Choices>
  static HWY_INLINE void Find(D, const Point<V>&, const Vec3V<V>&, V, const V*, Choices&, V*) {}
};

/// Width of the specular lobes of Lighting that averages normals, shared like Terms:
///   kNodes    number of normals over which they are averaged: 1 for lobes that are nearly Gaussian, 0 for none
///   kColumns  number of the first values of Shape that it reads
///   Precision(d, shape, length, variance)
/// gives the precision (1 / variance) of a Gaussian of slopes around the half vector (wo + l) / length that is like the
/// lobes, for slope_spread-inl.h. `variance` is the largest variance of slopes.
struct NoWidth {
  static constexpr int kNodes = 0;
};

/// Lighting of unlit models, and default members for the lighting of other models.
struct LightingBase {
  /// Number of RGB sums over the lights, at most kMaxLobes; 0 = unlit. Lobe 0 is diffuse, the others are specular.
  static constexpr uint32_t kLobes = 0;
  /// Whether the lobes depend on wo.
  static constexpr bool kNeedsEye = false;
  /// Whether SHD_MATERIAL_SPECULAR_UNGATED keeps the specular lobes where n.l <= 0. If false, they are always 0 there.
  static constexpr bool kMayBeUngated = false;
  /// Whether AddLight() sets specular lobes to 0 where they are not lit. If false, they are set to 0 where n.l <= 0.
  static constexpr bool kGatesLobes = false;
  /// Whether lobe 0 sums every light with weight 1 instead of E, without range, cookie, shadow or side.
  static constexpr bool kIgnoresIrradiance = false;
  /// Whether the lobes are averaged over the normals of SHD_NORMAL_ENCODING_MOMENTS; otherwise their mean is used.
  static constexpr bool kAveragesNormals = true;
  /// Parameters of the lobes at a point: a struct with
  ///   kSlots    bits of the slots that it reads
  ///   kColumns  number of values, at most kMaxShapeColumns
  ///   Derive(d, material, slots, variance, values)
  ///   Widen(d, variance, values)  adds a variance of slopes to values
  /// where `variance` is the variance of slopes removed by filtering normal maps, or 0.
  using Shape = NoShape;

  using Terms = NoTerms;
  using Width = NoWidth;

  // Lighting with lobes also has
  //   Lobes(d, material, terms, cosines, shape, lobe)
  // which sets lobe[kLobes] to the contribution of one light, divided by E. Unless kIgnoresIrradiance, lobe 0 must be 0
  // where n.l <= 0, because lights behind all points of a block are skipped.
  //
  // Lighting that reflects environments also has
  //   kEnvironmentTables                               shd_environment_table bits that it takes
  //   AddEnvironment(d, material, surroundings, shape, lobe)
  // which sets lobe[kLobes][3] to the contribution of an environment of intensity 1, before Normalize().
  static constexpr bool kReflectsEnvironment = false;
  static constexpr uint32_t kEnvironmentTables = 0;

  /// Scales the sums over all lights.
  template <class D, class V, class Sums>
  static HWY_INLINE void Normalize(D, const V*, Sums&) {}
};

/// Lobes of one light at a point, divided by E.
template <class Lighting, class D, class V>
HWY_INLINE void LobesOf(D d, const Material& material, const Point<V>& point, const Vec3V<V>& l,
                        const Cosines<V>& cosines, const V* shape, V* lobe) {
  simd::HWY_NAMESPACE::Choices<D> choices(d);
  V terms[Lighting::Terms::kCount + 1];
  Lighting::Terms::Find(d, point, l, cosines.n_dot_l, shape, choices, terms);
  Lighting::Lobes(d, material, terms, cosines, shape, lobe);
}

/// Default members of a model. Each model also has
///   kSlots                           bits of the slots that it reads
///   Combination::Combine(d, channel) L of one channel without emission
/// Models that inherit Lighting or Combination share the kernels instantiated from them.
struct ModelBase {
  /// Whether normal maps and bumps change the result of the model.
  static constexpr bool kHasNormal = true;
  /// Whether Combine() multiplies the ambient light by the diffuse colour itself.
  static constexpr bool kColorsAmbient = false;
  /// raster::Interpolated bits of the columns that Show() reads, except the normal.
  static constexpr uint32_t kShownColumns = 0;

  using Lighting = LightingBase;

  /// Writes the colour of unlit models to lobe 0 of the fragments.
  static void Show(const ShowInputs&, float* const*) {}
};

/// Slots that every model reads, and slots of groups of models.
constexpr uint32_t kColorSlots =
    1u << SHD_SLOT_DIFFUSE | 1u << SHD_SLOT_TINT | 1u << SHD_SLOT_OPACITY | 1u << SHD_SLOT_EMISSION;
constexpr uint32_t kNormalSlots = 1u << SHD_SLOT_NORMAL | 1u << SHD_SLOT_NORMAL_MIXED | 1u << SHD_SLOT_HEIGHT;
constexpr uint32_t kAmbientSlots = 1u << SHD_SLOT_AMBIENT | 1u << SHD_SLOT_OCCLUSION;
constexpr uint32_t kLitSlots = kColorSlots | kNormalSlots | kAmbientSlots;

}  // namespace shd::material::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_MATERIAL_MODEL_INL_H_
