// SPDX-License-Identifier: MIT
#include "shade/combine.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shade/combine.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "material/models-inl.h"
#include "material/slot_lookup.h"

HWY_BEFORE_NAMESPACE();
namespace shd::shade::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

namespace {

/// Inputs of the combination of one batch.
struct Inputs {
  const material::Material& material;
  const material::Parameters& parameters;  // complete; for CombineDiffuse(), the diffuse slot is
  const material::Lobes& lobes;
  const float* ambient;  // [3] k_a I_a of the material
  float light_count;
  size_t count;
};

/// Finds out whether all numbers of a batch are finite: the difference of a finite number and itself is 0.
template <class D>
struct FiniteTest {
  using V = hn::Vec<D>;

  HWY_INLINE explicit FiniteTest(D d) : sum(hn::Zero(d)) {}
  HWY_INLINE void Add(V x) { sum = sum + (x - x); }

  V sum;
};

/// Radiance of all points, of whose slots only the diffuse one may have values. Returns false if it is not finite; the
/// unused rows of the last vector count.
template <class Combination>
HWY_NOINLINE bool CombineDiffuse(const Inputs& in, const Radiance& out) {
  using D = hn::ScalableTag<float>;
  using V = hn::Vec<D>;
  const D d;
  const material::Material& m = in.material;
  const float* const* column = in.parameters.value[SHD_SLOT_DIFFUSE];
  const float* const diffuse[3] = {column[0], column[1], column[2]};
  float* const to[4] = {out.channel[0], out.channel[1], out.channel[2], out.channel[3]};
  const float ambient[3] = {in.ambient[0], in.ambient[1], in.ambient[2]};
  const material::Lobes lobes = in.lobes;
  const uint32_t ambient_slot = m.ambient_slot;
  FiniteTest<D> finite(d);
  for (size_t i = 0; i < in.count; i += hn::Lanes(d)) {
    const material::HWY_NAMESPACE::DiffuseAt<D> slots = {diffuse, d, i};
    V color[3];
    for (int c = 0; c < 3; ++c) {
      color[c] =
          Combination::Combine(d, material::HWY_NAMESPACE::ChannelAt<D, decltype(slots)>{
                                      m, slots, lobes, c, in.light_count, slots.Get(ambient[c], ambient_slot, c)});
    }
    for (int c = 0; c < 3; ++c) hn::Store(color[c], d, to[c] + i);
    hn::Store(hn::Set(d, 1.0f), d, to[3] + i);
    finite.Add(color[0] + color[1] + color[2]);
  }
  return hn::AllTrue(d, hn::Eq(finite.sum, hn::Zero(d)));
}

/// Radiance of all points. a multiplies the colour if the blend mode is premultiplied. Returns as CombineDiffuse().
template <class Combination>
HWY_NOINLINE bool CombineColor(const Inputs& in, const Radiance& out) {
  using D = hn::ScalableTag<float>;
  using V = hn::Vec<D>;
  const D d;
  const material::Material& m = in.material;
  const bool has_opacity = material::has_opacity(m);
  const bool premultiplied = m.blend != SHD_BLEND_OPAQUE && m.blend != SHD_BLEND_STRAIGHT;
  const V one = hn::Set(d, 1.0f), strength = hn::Set(d, m.occlusion_strength);
  FiniteTest<D> finite(d);
  for (size_t i = 0; i < in.count; i += hn::Lanes(d)) {
    const material::HWY_NAMESPACE::SlotsAt<D> slots = {in.parameters, d, i};
    const V lost = slots.Get(1.0f, SHD_SLOT_OCCLUSION, 0) - one;
    const V kept = one + strength * lost;
    V a = one;
    if (has_opacity) a = slots.Get(m.opacity, SHD_SLOT_OPACITY, 0) * slots.Get(1.0f, SHD_SLOT_DIFFUSE, 3);
    for (int c = 0; c < 3; ++c) {
      const V ambient = slots.Get(in.ambient[c], m.ambient_slot, c) * kept;
      V color = Combination::Combine(
          d, material::HWY_NAMESPACE::ChannelAt<D, decltype(slots)>{m, slots, in.lobes, c, in.light_count, ambient});
      if (m.emission[c] > 0.0f) color = color + slots.Get(m.emission[c], SHD_SLOT_EMISSION, c);
      if (premultiplied) color = a * color;
      hn::Store(color, d, out.channel[c] + i);
      finite.Add(color);
    }
    hn::Store(a, d, out.channel[3] + i);
    finite.Add(a);
  }
  return hn::AllTrue(d, hn::Eq(finite.sum, hn::Zero(d)));
}

}  // namespace

bool Combine(const material::Material& material, const float* ambient, float light_count, const material::Lobes& lobes,
             const material::Parameters& parameters, bool only_diffuse, size_t count, const Radiance& out) {
  const Inputs in = {material, parameters, lobes, ambient, light_count, count};
  bool finite = false;
  material::HWY_NAMESPACE::VisitModel(material.model, [&](auto model) {
    using Combination = typename decltype(model)::Combination;
    finite = only_diffuse ? CombineDiffuse<Combination>(in, out) : CombineColor<Combination>(in, out);
  });
  return finite;
}

void SpreadCorners(const raster::Fragments& fragments, const uint32_t* points, const float* in, float* out) {
  const hn::ScalableTag<float> d;
  const hn::RebindToSigned<decltype(d)> di;
  const auto one = hn::Set(di, 1);
  const auto* signed_points = reinterpret_cast<const int32_t*>(points);
  for (size_t i = 0; i < fragments.count; i += hn::Lanes(d)) {
    const auto first = hn::Load(di, signed_points + i);
    const auto a0 = hn::GatherIndex(d, in, first);
    const auto a1 = hn::GatherIndex(d, in, first + one) - a0;
    const auto a2 = hn::GatherIndex(d, in, first + (one + one)) - a0;
    const auto sum = a0 + hn::Load(d, fragments.bary[1] + i) * a1;
    hn::Store(sum + hn::Load(d, fragments.bary[2] + i) * a2, d, out + i);
  }
}

size_t CountNonfinite(const Radiance& radiance, size_t count) {
  const hn::ScalableTag<float> d;
  size_t finite = 0;
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    auto zero = hn::Zero(d);  // x - x is 0 only for finite x
    for (int c = 0; c < 4; ++c) {
      const auto x = hn::Load(d, radiance.channel[c] + i);
      zero = zero + (x - x);
    }
    const auto rows = hn::FirstN(d, count - i);
    finite += hn::CountTrue(d, hn::And(rows, hn::Eq(zero, hn::Zero(d))));
  }
  return count - finite;
}

}  // namespace shd::shade::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::shade {

HWY_EXPORT(Combine);
HWY_EXPORT(CountNonfinite);
HWY_EXPORT(SpreadCorners);

namespace {

/// Whether only the diffuse slot has values, and nothing else than light and coefficients makes the colour.
bool has_only_diffuse(const material::Material& material, const material::Parameters& parameters) {
  if (material::has_opacity(material)) return false;
  for (const float emission : material.emission) {
    if (emission > 0.0f) return false;
  }
  for (uint32_t slot = 0; slot < material::kSlotCount; ++slot) {
    if (slot != SHD_SLOT_DIFFUSE && parameters.value[slot][0]) return false;
  }
  return true;
}

bool has_color(const float* const (&column)[4]) {
  return column[0] && column[1] && column[2];
}

}  // namespace

size_t combine(const core::SimdTarget& simd, const material::Material& material, const LightTable& lights,
               const material::Lobes& lobes, const material::Parameters& parameters, size_t count, Radiance* out) {
  const auto light_count = static_cast<float>(lights.count);
  const float times = material.flags & SHD_MATERIAL_AMBIENT_PER_LIGHT ? light_count : 1.0f;
  const bool has_ambient = material::info_of(material.model).slots >> SHD_SLOT_AMBIENT & 1;
  float ambient[3];
  for (int c = 0; c < 3; ++c) ambient[c] = (has_ambient ? material.ambient[c] : 1.0f) * lights.ambient[c] * times;
  const bool only_diffuse = has_only_diffuse(material, parameters);
  material::Parameters all;
  const bool is_complete = only_diffuse && has_color(parameters.value[SHD_SLOT_DIFFUSE]);
  if (!is_complete) all = material::complete(parameters);
  const bool finite = SHD_DISPATCH(Combine, simd)(material, ambient, light_count, lobes, is_complete ? parameters : all,
                                                  only_diffuse, count, *out);
  return finite ? 0 : count_nonfinite(simd, *out, count);
}

size_t count_nonfinite(const core::SimdTarget& simd, const Radiance& radiance, size_t count) {
  return SHD_DISPATCH(CountNonfinite, simd)(radiance, count);
}

void spread_corners(const core::SimdTarget& simd, const raster::Fragments& fragments, const uint32_t* points,
                    const float* in, float* out) {
  SHD_DISPATCH(SpreadCorners, simd)(fragments, points, in, out);
}

void spread_centroids(const uint32_t* points, size_t count, const float* in, float* out) {
  for (size_t i = 0; i < count; ++i) out[i] = in[points[i]];
}

}  // namespace shd::shade
#endif  // HWY_ONCE
