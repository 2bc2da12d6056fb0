// SPDX-License-Identifier: MIT
#include "shade/illuminate.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shade/illuminate.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "light/incident-inl.h"
#include "material/models-inl.h"
#include "material/slope_spread-inl.h"
#include "material/slot_lookup.h"

HWY_BEFORE_NAMESPACE();
namespace shd::shade::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::Dot;
using simd::HWY_NAMESPACE::Load3;

namespace {

/// Adds I w, times the factors of cookies and shadows, to the channels of a lobe. Zero weights stay zero even if a
/// factor is NaN.
template <class D, class V>
HWY_INLINE void Accumulate(D d, const ActiveLight& active, size_t i, V w, V (&sum)[3]) {
  const auto is_lit = hn::Gt(w, hn::Zero(d));
  for (int c = 0; c < 3; ++c) {
    const V left = active.factor[c] ? hn::IfThenElseZero(is_lit, w * hn::Load(d, active.factor[c] + i)) : w;
    sum[c] = sum[c] + hn::Set(d, active.light->intensity[c]) * left;
  }
}

/// Adds the lobes of one light at a vector of points. If `gated`, specular lobes are 0 where n.l <= 0.
template <class Lighting, class D, class V>
HWY_INLINE void AddLight(D d, const material::Material& material, const ActiveLight& active, size_t i,
                         const simd::HWY_NAMESPACE::Vec3V<V>& p, const material::HWY_NAMESPACE::Point<V>& point,
                         const V* shape, bool gated, V (&sum)[Lighting::kLobes][3]) {
  const auto incident = light::HWY_NAMESPACE::IncidentAt(d, *active.light, p);
  const V n_dot_l = Dot(point.n, incident.l);
  const material::HWY_NAMESPACE::Incoming<V> in = {incident.l, n_dot_l, hn::Max(n_dot_l, hn::Zero(d))};
  V lobe[Lighting::kLobes];
  if constexpr (Lighting::kIgnoresIrradiance) {
    Lighting::AddLight(d, material, point, in, shape, lobe);
    for (V& channel : sum[0]) channel = channel + lobe[0];
  } else {
    const auto faces = hn::Gt(in.n_dot_l, hn::Zero(d));
    // The light is behind every point of the vector: all terms are +0, and adding them changes no bit.
    if (gated && hn::AllFalse(d, faces)) return;
    Lighting::AddLight(d, material, point, in, shape, lobe);
    for (uint32_t k = 0; k < Lighting::kLobes; ++k) {
      const V kept = k && gated ? hn::IfThenElseZero(faces, lobe[k]) : lobe[k];
      Accumulate(d, active, i, incident.falloff * kept, sum[k]);
    }
  }
}

/// Lobes of one light, averaged over normals: those of the normal that reflects or, if they have long tails, the sum
/// over the nodes of a rule. `in` holds the mean normal's n.l and the mean cosine.
template <class Lighting, class D, class V>
HWY_INLINE void AverageLobes(D d, const material::Material& material,
                             const material::HWY_NAMESPACE::SlopeSpread<V>& spread,
                             const simd::HWY_NAMESPACE::Vec3V<V>& wo, const material::HWY_NAMESPACE::Incoming<V>& in,
                             const V* shape, bool gated, V (&mean)[Lighting::kLobes]) {
  namespace mat = material::HWY_NAMESPACE;
  const V zero = hn::Zero(d);
  const auto way = simd::HWY_NAMESPACE::Sum(wo, in.l);
  const V squared = Dot(way, way);
  const V length = hn::Sqrt(hn::IfThenElse(hn::Gt(squared, zero), squared, hn::Set(d, 1.0f)));
  const V k = Lighting::Precision(d, shape, length, spread.longest);
  // Lobes of the normal n, with all specular lobes 0 if it is averted. They are the only use of the lobes' formulas.
  V lobe[Lighting::kLobes];
  const auto evaluate = [&](const simd::HWY_NAMESPACE::Vec3V<V>& n) {
    const V n_dot_l = Dot(n, in.l);
    Lighting::AddLight(d, material, {n, wo}, {in.l, n_dot_l, in.cosine}, shape, lobe);
    const auto faces = hn::Gt(n_dot_l, zero);
    for (uint32_t j = 1; j < Lighting::kLobes; ++j) lobe[j] = gated ? hn::IfThenElseZero(faces, lobe[j]) : lobe[j];
  };
  if constexpr (Lighting::kHasLongTails) {
    const auto rule = mat::MakeNormalRule(d, spread, way, length, k);
    for (V& sum : mean) sum = zero;
    for (int i = 0; i < mat::kNodes; ++i) {
      const auto node = mat::NodeAt(d, spread, rule, i);
      evaluate(node.n);
      for (uint32_t j = 1; j < Lighting::kLobes; ++j) mean[j] = mean[j] + node.weight * lobe[j];
    }
    // All nodes are the mean normal where there is no spread.
    const auto varies = hn::Gt(spread.trace, zero);
    for (uint32_t j = 1; j < Lighting::kLobes; ++j) mean[j] = hn::IfThenElse(varies, mean[j], lobe[j]);
  } else {
    const auto reflector = mat::FindReflector(d, spread, way, length, k);
    evaluate(reflector.n);
    for (uint32_t j = 1; j < Lighting::kLobes; ++j) mean[j] = reflector.gain * lobe[j];
  }
  mean[0] = lobe[0];
}

/// As AddLight, with the lobes averaged over normals.
template <class Lighting, class D, class V>
HWY_INLINE void AddLightOverNormals(D d, const material::Material& material, const ActiveLight& active, size_t i,
                                    const simd::HWY_NAMESPACE::Vec3V<V>& p,
                                    const material::HWY_NAMESPACE::SlopeSpread<V>& spread,
                                    const simd::HWY_NAMESPACE::Vec3V<V>& wo, const V* shape, bool gated,
                                    V (&sum)[Lighting::kLobes][3]) {
  namespace mat = material::HWY_NAMESPACE;
  const auto incident = light::HWY_NAMESPACE::IncidentAt(d, *active.light, p);
  const V n_dot_l = Dot(spread.n, incident.l);
  const mat::Incoming<V> in = {incident.l, n_dot_l, mat::FilteredCosine(d, spread, incident.l, n_dot_l)};
  const auto faces = hn::Gt(in.cosine, hn::Zero(d));
  if (gated && hn::AllFalse(d, faces)) return;
  V lobe[Lighting::kLobes];
  if constexpr (Lighting::kLobes == 1) {
    Lighting::AddLight(d, material, {spread.n, wo}, in, shape, lobe);
  } else {
    AverageLobes<Lighting>(d, material, spread, wo, in, shape, gated, lobe);
  }
  for (uint32_t k = 0; k < Lighting::kLobes; ++k) {
    Accumulate(d, active, i, incident.falloff * (k && gated ? hn::IfThenElseZero(faces, lobe[k]) : lobe[k]), sum[k]);
  }
}

/// `over_normals`: the lobes are averaged over normals whose slopes have the covariance of shape.spread.
template <class Lighting, bool over_normals>
void IlluminatePoints(const material::Material& material, const LobeShape& shape, const ActiveLight* lights,
                      size_t count, const raster::Fragments& f, LightGroup group, material::Lobes& out) {
  using D = hn::ScalableTag<float>;
  const D d;
  using V = hn::Vec<D>;
  constexpr uint32_t kLobes = Lighting::kLobes;
  const bool gated =
      !Lighting::kGatesLobes && !(Lighting::kMayBeUngated && material.flags & SHD_MATERIAL_SPECULAR_UNGATED);
  const V zero = hn::Zero(d);
  V constant[material::kMaxShapeColumns];
  const material::HWY_NAMESPACE::SlotsAt<D> unset = {material::unset_parameters(), d, 0};
  Lighting::Shape::Derive(d, material, unset, zero, constant);
  for (size_t i = 0; i < f.count; i += hn::Lanes(d)) {
    const auto p = Load3(d, f.px, f.py, f.pz, i);
    const material::HWY_NAMESPACE::Point<V> point = {Load3(d, f.nx, f.ny, f.nz, i), Load3(d, f.ox, f.oy, f.oz, i)};
    V values[material::kMaxShapeColumns], sum[kLobes][3];
    for (uint32_t k = 0; k < Lighting::Shape::kColumns; ++k) {
      values[k] = shape.column[k] ? hn::Load(d, shape.column[k] + i) : constant[k];
    }
    for (uint32_t k = 0; k < 3 * kLobes; ++k) {
      sum[k / 3][k % 3] = group.continues ? hn::Load(d, out.lobe[k / 3][k % 3] + i) : zero;
    }
    if constexpr (over_normals) {
      const float* const* s = shape.spread;
      auto a = Load3(d, s[0], s[1], s[2], i), b = Load3(d, s[3], s[4], s[5], i);
      if constexpr (Lighting::kHasLongTails) material::HWY_NAMESPACE::TurnToAxes(d, a, b);
      const auto spread = material::HWY_NAMESPACE::MakeSlopeSpread(d, point.n, a, b);
      for (size_t j = 0; j < count; ++j)
        AddLightOverNormals<Lighting>(d, material, lights[j], i, p, spread, point.wo, values, gated, sum);
    } else {
      for (size_t j = 0; j < count; ++j) AddLight<Lighting>(d, material, lights[j], i, p, point, values, gated, sum);
    }
    if (group.finishes) Lighting::Normalize(d, values, sum);
    for (uint32_t k = 0; k < 3 * kLobes; ++k) hn::Store(sum[k / 3][k % 3], d, out.lobe[k / 3][k % 3] + i);
  }
}

template <class Shape>
void DeriveShape(const material::Material& material, const material::Parameters& parameters, const float* variance,
                 size_t count, float* const* out) {
  using D = hn::ScalableTag<float>;
  const D d;
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    hn::Vec<D> value[Shape::kColumns];
    const auto lost = variance ? hn::Load(d, variance + i) : hn::Zero(d);
    Shape::Derive(d, material, material::HWY_NAMESPACE::SlotsAt<D>{parameters, d, i}, lost, value);
    for (uint32_t k = 0; k < Shape::kColumns; ++k) hn::Store(value[k], d, out[k] + i);
  }
}

}  // namespace

void Illuminate(const material::Material& material, const LobeShape& shape, const ActiveLight* lights, size_t count,
                const raster::Fragments& points, LightGroup group, material::Lobes& out) {
  material::HWY_NAMESPACE::VisitModel(material.model, [&](auto model) {
    using Lighting = typename decltype(model)::Lighting;
    if constexpr (Lighting::kLobes != 0) {
      if constexpr (Lighting::kAveragesNormals) {
        if (shape.spread[0])
          return IlluminatePoints<Lighting, true>(material, shape, lights, count, points, group, out);
      }
      IlluminatePoints<Lighting, false>(material, shape, lights, count, points, group, out);
    }
  });
}

void ShapeLobes(const material::Material& material, const material::Parameters& parameters, const float* variance,
                size_t count, float* const* out) {
  material::HWY_NAMESPACE::VisitModel(material.model, [&](auto model) {
    using Shape = typename decltype(model)::Lighting::Shape;
    if constexpr (Shape::kColumns != 0) DeriveShape<Shape>(material, parameters, variance, count, out);
  });
}

}  // namespace shd::shade::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::shade {

HWY_EXPORT(Illuminate);
HWY_EXPORT(ShapeLobes);

LobeShape shape_lobes(const core::SimdTarget& simd, const material::Material& material,
                      const material::Parameters& parameters, const float* variance, size_t count, Columns* columns) {
  const material::ModelInfo& info = material::info_of(material.model);
  bool varies = variance != nullptr;
  for (uint32_t slot = 0; slot < material::kSlotCount; ++slot) {
    varies |= info.shape_slots >> slot & 1 && parameters.value[slot][0];
  }
  LobeShape shape = {};
  if (!varies) return shape;
  SHD_DISPATCH(ShapeLobes, simd)(material, material::complete(parameters), variance, count, columns->shape);
  for (uint32_t k = 0; k < info.shape_columns; ++k) shape.column[k] = columns->shape[k];
  return shape;
}

void illuminate(const core::SimdTarget& simd, const material::Material& material, const LobeShape& shape,
                const ActiveLight* lights, size_t count, const raster::Fragments& points, LightGroup group,
                material::Lobes* out) {
  SHD_DISPATCH(Illuminate, simd)(material, shape, lights, count, points, group, *out);
}

}  // namespace shd::shade
#endif  // HWY_ONCE
