// SPDX-License-Identifier: MIT
#include "shade/surround.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shade/surround.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "material/models-inl.h"
#include "material/slot_lookup.h"
#include "simd/vec3-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::shade::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::Dot;
using simd::HWY_NAMESPACE::Load3;
using simd::HWY_NAMESPACE::Vec3V;

namespace {

using Tag = hn::ScalableTag<float>;
using Vec = hn::Vec<Tag>;

/// The part of the environment's light that occlusion keeps.
HWY_INLINE Vec Kept(const material::Material& material, const material::Parameters& parameters, size_t i) {
  const Tag d;
  const Vec one = hn::Set(d, 1.0f), strength = hn::Set(d, material.occlusion_strength);
  const material::HWY_NAMESPACE::SlotsAt<Tag> slots = {parameters, d, i};
  return one + strength * (slots.Get(1.0f, SHD_SLOT_OCCLUSION, 0) - one);
}

template <class Lighting>
void SurroundPoints(const material::Material& material, const LobeShape& shape, const EnvironmentLight& environment,
                    const raster::Fragments& f, const material::Parameters* parameters, const float* widening,
                    material::Lobes& out) {
  namespace mat = material::HWY_NAMESPACE;
  const Tag d;
  const Vec zero = hn::Zero(d), intensity = hn::Set(d, environment.intensity);
  const environment::LobeTable* const lobes = Lighting::kEnvironmentTables ? &environment::lobe_table() : nullptr;
  Vec constant[material::kMaxShapeColumns];
  const mat::SlotsAt<Tag> unset = {material::unset_parameters(), d, 0};
  Lighting::Shape::Derive(d, material, unset, zero, constant);
  for (size_t i = 0; i < f.count; i += hn::Lanes(d)) {
    const auto n = Load3(d, f.nx, f.ny, f.nz, i);
    Vec3V<Vec> r = n;
    Vec n_dot_v = zero;
    if constexpr (Lighting::kNeedsEye) {
      const auto v = Load3(d, f.ox, f.oy, f.oz, i);
      n_dot_v = Dot(n, v);
      const Vec twice = n_dot_v + n_dot_v;
      r = {twice * n.x - v.x, twice * n.y - v.y, twice * n.z - v.z};
    }
    Vec values[material::kMaxShapeColumns], lobe[Lighting::kLobes][3];
    for (uint32_t k = 0; k < Lighting::Shape::kColumns; ++k) {
      values[k] = shape.column[k] ? hn::Load(d, shape.column[k] + i) : constant[k];
    }
    if (shape.spread[0]) {
      const float* const* s = shape.spread;
      const auto a = Load3(d, s[0], s[1], s[2], i), b = Load3(d, s[3], s[4], s[5], i);
      Lighting::Shape::Widen(d, hn::Set(d, 0.5f) * (Dot(a, a) + Dot(b, b)), values);
    }
    if (widening) Lighting::Shape::Widen(d, hn::Load(d, widening + i), values);
    const mat::Surroundings<Tag> from(d, *environment.map, lobes, environment.world_to_map, n, r, n_dot_v);
    Lighting::AddEnvironment(d, material, from, values, lobe);
    Lighting::Normalize(d, values, lobe);
    const Vec scale = parameters ? intensity * Kept(material, *parameters, i) : intensity;
    for (uint32_t k = 0; k < 3 * Lighting::kLobes; ++k) {
      float* const to = out.lobe[k / 3][k % 3] + i;
      const Vec value = lobe[k / 3][k % 3] * scale;
      hn::Store(parameters ? hn::Load(d, to) + value : value, d, to);
    }
  }
}

}  // namespace

void Surround(const material::Material& material, const LobeShape& shape, const EnvironmentLight& environment,
              const raster::Fragments& points, const material::Parameters* parameters, const float* widening,
              material::Lobes& out) {
  material::HWY_NAMESPACE::VisitModel(material.model, [&](auto model) {
    using Lighting = typename decltype(model)::Lighting;
    if constexpr (Lighting::kReflectsEnvironment) {
      SurroundPoints<Lighting>(material, shape, environment, points, parameters, widening, out);
    }
  });
}

void AddSurroundings(const material::Material& material, const material::Parameters& parameters, uint32_t lobe_count,
                     const material::Lobes& environment, size_t count, material::Lobes& lobes) {
  const Tag d;
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    const Vec kept = Kept(material, parameters, i);
    for (uint32_t k = 0; k < 3 * lobe_count; ++k) {
      float* sum = lobes.lobe[k / 3][k % 3] + i;
      hn::Store(hn::Load(d, sum) + kept * hn::Load(d, environment.lobe[k / 3][k % 3] + i), d, sum);
    }
  }
}

}  // namespace shd::shade::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::shade {

HWY_EXPORT(Surround);
HWY_EXPORT(AddSurroundings);

void surround(const core::SimdTarget& simd, const material::Material& material, const LobeShape& shape,
              const EnvironmentLight& environment, const raster::Fragments& points,
              const material::Parameters* parameters, const float* widening, material::Lobes* out) {
  material::Parameters all;
  if (parameters) all = material::complete(*parameters);
  SHD_DISPATCH(Surround, simd)(material, shape, environment, points, parameters ? &all : nullptr, widening, *out);
}

void add_surroundings(const core::SimdTarget& simd, const material::Material& material,
                      const material::Parameters& parameters, const material::Lobes& environment, size_t count,
                      material::Lobes* lobes) {
  SHD_DISPATCH(AddSurroundings, simd)
  (material, material::complete(parameters), material::info_of(material.model).lobes, environment, count, *lobes);
}

}  // namespace shd::shade
#endif  // HWY_ONCE
