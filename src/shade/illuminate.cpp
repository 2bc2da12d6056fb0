// SPDX-License-Identifier: MIT
#include "shade/illuminate.h"

#include <algorithm>

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

/// Points whose lights are summed in short loops, so that their columns stay in L1.
constexpr size_t kBlock = 64;
static_assert(raster::kBatch % kBlock == 0, "the last block must lie in the columns");

/// The points of a block, and columns of the shape of its lobes, which begin with the block.
struct Block {
  const material::Material& material;
  const raster::Fragments& f;
  size_t first, count;
  const float* shape[material::kMaxShapeColumns];

  template <class D, class V>
  HWY_INLINE void LoadShape(D d, size_t i, uint32_t count_of_columns, V* out) const {
    for (uint32_t k = 0; k < count_of_columns; ++k) out[k] = hn::Load(d, shape[k] + i);
  }
  template <class D, class V = hn::Vec<D>>
  HWY_INLINE material::HWY_NAMESPACE::Point<V> PointAt(D d, size_t i) const {
    return {Load3(d, f.nx, f.ny, f.nz, first + i), Load3(d, f.ox, f.oy, f.oz, first + i)};
  }
};

/// Sums over the lights at the points of a block: columns that begin with the block.
template <class Lighting>
struct Sums {
  float* column[Lighting::kLobes][3];
};

/// Sets the sums of a whole block to 0. The zero is volatile, so that gcc stores vectors: its `rep stos` takes longer
/// for short columns.
HWY_NOINLINE void StartSums(const material::Lobes& out, uint32_t lobes, size_t first) {
  const hn::ScalableTag<float> d;
  const volatile float nothing = 0.0f;
  const auto zero = hn::Set(d, nothing);
  for (uint32_t k = 0; k < lobes; ++k) {
    float *const r = out.lobe[k][0] + first, *const g = out.lobe[k][1] + first, *const b = out.lobe[k][2] + first;
    for (size_t i = 0; i < kBlock; i += hn::Lanes(d)) {
      hn::Store(zero, d, r + i);
      hn::Store(zero, d, g + i);
      hn::Store(zero, d, b + i);
    }
  }
}

/// A light of a block with its factors.
struct Addition {
  const light::Light light;  // a copy, which no store changes
  const float* factor[3];    // by the points of the block; null = 1

  Addition(const ActiveLight& active, const Block& block) : light(*active.light), factor() {
    for (int c = 0; c < 3 && active.factor[0]; ++c) factor[c] = active.factor[c] + block.first;
  }
};

/// Adds I w, times the factors of cookies and shadows, to the channels of a lobe. Zero weights stay zero even if a
/// factor is NaN.
template <class D, class V>
HWY_INLINE void Accumulate(D d, const Addition& addition, size_t i, V w, float* const (&sum)[3]) {
  const auto add = [&](int c, V left) HWY_ATTR {
    hn::Store(hn::Load(d, sum[c] + i) + hn::Set(d, addition.light.intensity[c]) * left, d, sum[c] + i);
  };
  if (HWY_LIKELY(addition.factor[0] == nullptr)) {
    for (int c = 0; c < 3; ++c) add(c, w);
  } else {
    const auto is_lit = hn::Gt(w, hn::Zero(d));
    for (int c = 0; c < 3; ++c) add(c, hn::IfThenElseZero(is_lit, w * hn::Load(d, addition.factor[c] + i)));
  }
}

/// Columns of one light at the points of a block.
template <class Terms>
struct LightColumns {
  alignas(64) float falloff[kBlock], n_dot_l[kBlock], term[Terms::kCount + 1][kBlock];
};

/// First loop over the points of a block: direction and distance of a light, and what its lobes need of both. Returns
/// whether some point faces the light. Pointers are copied, so that no store changes them.
template <class Terms, class Choices, class D = hn::ScalableTag<float>>
HWY_INLINE bool FindTermsBy(Choices& choices, const Block& block, const light::Light& from, LightColumns<Terms>& out) {
  using V = hn::Vec<D>;
  const D d;
  const light::Light light = from;
  const raster::Fragments& f = block.f;
  const size_t first = block.first, count = block.count;
  const float *const px = f.px + first, *const py = f.py + first, *const pz = f.pz + first;
  const float *const nx = f.nx + first, *const ny = f.ny + first, *const nz = f.nz + first;
  const float *const ox = f.ox + first, *const oy = f.oy + first, *const oz = f.oz + first;
  const float* column[Terms::kColumns + 1];
  for (uint32_t k = 0; k < Terms::kColumns; ++k) column[k] = block.shape[k];
  auto faces = hn::Gt(hn::Zero(d), hn::Zero(d));
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto p = Load3(d, px, py, pz, i);
    const material::HWY_NAMESPACE::Point<V> point = {Load3(d, nx, ny, nz, i), Load3(d, ox, oy, oz, i)};
    const auto incident = light::HWY_NAMESPACE::IncidentAt(d, light, p, choices);
    const V n_dot_l = Dot(point.n, incident.l);
    V shape[Terms::kColumns + 1], terms[Terms::kCount + 1];
    for (uint32_t k = 0; k < Terms::kColumns; ++k) shape[k] = hn::Load(d, column[k] + i);
    Terms::Find(d, point, incident.l, n_dot_l, shape, choices, terms);
    faces = hn::Or(faces, hn::Gt(n_dot_l, hn::Zero(d)));
    hn::Store(incident.falloff, d, out.falloff + i);
    hn::Store(n_dot_l, d, out.n_dot_l + i);
    for (uint32_t k = 0; k < Terms::kCount; ++k) hn::Store(terms[k], d, out.term[k] + i);
  }
  return !hn::AllFalse(d, faces);
}

template <class Terms>
HWY_NOINLINE void FindTermsOfAny(const Block& block, const light::Light& light, LightColumns<Terms>& out) {
  const hn::ScalableTag<float> d;
  simd::HWY_NAMESPACE::Choices<decltype(d)> choices(d);
  FindTermsBy(choices, block, light, out);
}

/// As FindTermsBy(). Models with the same terms share the function. Returns false only if the light is behind every
/// point and all points are usual: then its lobes are +0, and adding them changes no bit.
template <class Terms>
HWY_NOINLINE bool FindTerms(const Block& block, const light::Light& light, LightColumns<Terms>& out) {
  const hn::ScalableTag<float> d;
  simd::HWY_NAMESPACE::UsualChoices<decltype(d)> choices(d);
  const bool faces = FindTermsBy(choices, block, light, out);
  if (HWY_LIKELY(hn::AllTrue(d, choices.usual))) return faces;
  FindTermsOfAny(block, light, out);
  return true;
}

/// Adds the lobes of one light at the points of a block. If `gated`, specular lobes are 0 where n.l <= 0.
template <class Lighting, class D>
HWY_INLINE void AddLight(D d, const Block& block, const ActiveLight& active, bool gated, const Sums<Lighting>& sums) {
  using V = hn::Vec<D>;
  const Addition addition(active, block);
  const light::Light& light = addition.light;
  LightColumns<typename Lighting::Terms> columns;
  const bool adds = FindTerms(block, light, columns);
  if (!Lighting::kIgnoresIrradiance && gated && !adds) return;
  const V zero = hn::Zero(d);
  for (size_t i = 0; i < block.count; i += hn::Lanes(d)) {
    const V n_dot_l = hn::Load(d, columns.n_dot_l + i);
    V shape[material::kMaxShapeColumns], terms[Lighting::Terms::kCount + 1], lobe[Lighting::kLobes];
    block.LoadShape(d, i, Lighting::Shape::kColumns, shape);
    for (uint32_t k = 0; k < Lighting::Terms::kCount; ++k) terms[k] = hn::Load(d, columns.term[k] + i);
    Lighting::Lobes(d, block.material, terms, {n_dot_l, hn::Max(n_dot_l, zero)}, shape, lobe);
    if constexpr (Lighting::kIgnoresIrradiance) {
      for (float* sum : sums.column[0]) {
        hn::Store(hn::Load(d, sum + i) + lobe[0], d, sum + i);
      }
    } else {
      const auto faces_light = hn::Gt(n_dot_l, zero);
      const V falloff = hn::Load(d, columns.falloff + i);
      for (uint32_t k = 0; k < Lighting::kLobes; ++k) {
        const V kept = k && gated ? hn::IfThenElseZero(faces_light, lobe[k]) : lobe[k];
        Accumulate(d, addition, i, falloff * kept, sums.column[k]);
      }
    }
  }
}

/// One light at one vector of points with spread normals: its direction and falloff, the mean of max(0, n.l), and the
/// normals over which lobes are averaged. Lobes with long tails are summed over the nodes of a rule. The other lobes
/// are those of the normal that reflects.
template <class V>
struct LightOverNormals {
  simd::HWY_NAMESPACE::Vec3V<V> l;
  V falloff, n_dot_l, cosine;
  simd::HWY_NAMESPACE::Vec3V<V> n[material::HWY_NAMESPACE::kNodes];
  V weight[material::HWY_NAMESPACE::kNodes];
};

/// Finds normals for lobes of a width; models with the same width share the function. Returns false if the light is
/// behind all points.
template <class Width, class V>
HWY_NOINLINE bool FindNormals(const Block& block, const light::Light& light, size_t i,
                              const material::HWY_NAMESPACE::SlopeSpread<V>& spread,
                              const simd::HWY_NAMESPACE::Vec3V<V>& wo, const V* shape, LightOverNormals<V>& out) {
  namespace mat = material::HWY_NAMESPACE;
  const hn::ScalableTag<float> d;
  const auto p = Load3(d, block.f.px, block.f.py, block.f.pz, block.first + i);
  simd::HWY_NAMESPACE::Choices<decltype(d)> choices(d);
  const auto incident = light::HWY_NAMESPACE::IncidentAt(d, light, p, choices);
  out.l = incident.l, out.falloff = incident.falloff;
  out.n_dot_l = Dot(spread.n, incident.l);
  out.cosine = mat::FilteredCosine(d, spread, incident.l, out.n_dot_l);
  if constexpr (Width::kNodes > 0) {
    const auto way = simd::HWY_NAMESPACE::Sum(wo, incident.l);
    const V squared = Dot(way, way);
    const V length = hn::Sqrt(hn::IfThenElse(hn::Gt(squared, hn::Zero(d)), squared, hn::Set(d, 1.0f)));
    const V k = Width::Precision(d, shape, length, spread.longest);
    if constexpr (Width::kNodes == 1) {
      const auto reflector = mat::FindReflector(d, spread, way, length, k);
      out.n[0] = reflector.n, out.weight[0] = reflector.gain;
    } else {
      static_assert(Width::kNodes == mat::kNodes);
      const auto rule = mat::MakeNormalRule(d, spread, way, length, k);
      for (int j = 0; j < mat::kNodes; ++j) {
        const auto node = mat::NodeAt(d, spread, rule, j);
        out.n[j] = node.n, out.weight[j] = node.weight;
      }
    }
  }
  return !hn::AllFalse(d, hn::Gt(out.cosine, hn::Zero(d)));
}

/// Lobes of one light, averaged over normals. If `gated`, specular lobes of averted normals are 0.
template <class Lighting, class D, class V>
HWY_INLINE void AverageLobes(D d, const material::Material& material, const LightOverNormals<V>& light,
                             const material::HWY_NAMESPACE::SlopeSpread<V>& spread,
                             const simd::HWY_NAMESPACE::Vec3V<V>& wo, const V* shape, bool gated,
                             V (&mean)[Lighting::kLobes]) {
  namespace mat = material::HWY_NAMESPACE;
  const V zero = hn::Zero(d);
  V lobe[Lighting::kLobes];
  for (V& sum : mean) sum = zero;
  for (int i = 0; i < Lighting::Width::kNodes; ++i) {
    const V n_dot_l = Dot(light.n[i], light.l);
    mat::LobesOf<Lighting>(d, material, {light.n[i], wo}, light.l, {n_dot_l, light.cosine}, shape, lobe);
    const auto faces = hn::Gt(n_dot_l, zero);
    for (uint32_t j = 1; j < Lighting::kLobes; ++j) {
      lobe[j] = gated ? hn::IfThenElseZero(faces, lobe[j]) : lobe[j];
      const V part = light.weight[i] * lobe[j];
      mean[j] = Lighting::Width::kNodes == 1 ? part : mean[j] + part;
    }
  }
  if constexpr (Lighting::Width::kNodes > 1) {
    // All nodes are the mean normal where there is no spread.
    const auto varies = hn::Gt(spread.trace, zero);
    for (uint32_t j = 1; j < Lighting::kLobes; ++j) mean[j] = hn::IfThenElse(varies, mean[j], lobe[j]);
  }
  mean[0] = lobe[0];
}

/// As AddLight, at one vector of points, with the lobes averaged over normals.
template <class Lighting, class D, class V>
HWY_INLINE void AddLightOverNormals(D d, const Block& block, const ActiveLight& active, size_t i,
                                    const material::HWY_NAMESPACE::SlopeSpread<V>& spread,
                                    const simd::HWY_NAMESPACE::Vec3V<V>& wo, const V* shape, bool gated,
                                    const Sums<Lighting>& sums) {
  LightOverNormals<V> light;
  const bool is_lit = FindNormals<typename Lighting::Width>(block, *active.light, i, spread, wo, shape, light);
  if (gated && !is_lit) return;
  V lobe[Lighting::kLobes];
  if constexpr (Lighting::kLobes == 1) {
    material::HWY_NAMESPACE::LobesOf<Lighting>(d, block.material, {spread.n, wo}, light.l,
                                               {light.n_dot_l, light.cosine}, shape, lobe);
  } else {
    AverageLobes<Lighting>(d, block.material, light, spread, wo, shape, gated, lobe);
  }
  const Addition addition(active, block);
  const auto faces = hn::Gt(light.cosine, hn::Zero(d));
  for (uint32_t k = 0; k < Lighting::kLobes; ++k) {
    const V kept = k && gated ? hn::IfThenElseZero(faces, lobe[k]) : lobe[k];
    Accumulate(d, addition, i, light.falloff * kept, sums.column[k]);
  }
}

/// The spread of the normals of one vector of points, from the six columns of LobeShape::spread.
template <bool on_axes, class V>
HWY_NOINLINE material::HWY_NAMESPACE::SlopeSpread<V> SpreadAt(const simd::HWY_NAMESPACE::Vec3V<V>& n,
                                                              const float* const* columns, size_t at) {
  const hn::ScalableTag<float> d;
  auto a = Load3(d, columns[0], columns[1], columns[2], at), b = Load3(d, columns[3], columns[4], columns[5], at);
  if constexpr (on_axes) material::HWY_NAMESPACE::TurnToAxes(d, a, b);
  return material::HWY_NAMESPACE::MakeSlopeSpread(d, n, a, b);
}

/// Adds the lobes of all lights, averaged over normals whose slopes have the covariance of `columns`.
template <class Lighting>
HWY_NOINLINE void AddLightsOverNormals(const Block& block, const float* const* columns, const ActiveLight* lights,
                                       size_t count, bool gated, const Sums<Lighting>& sums) {
  using D = hn::ScalableTag<float>;
  using V = hn::Vec<D>;
  const D d;
  for (size_t i = 0; i < block.count; i += hn::Lanes(d)) {
    const auto point = block.PointAt(d, i);
    const auto spread = SpreadAt<(Lighting::Width::kNodes > 1)>(point.n, columns, block.first + i);
    V shape[material::kMaxShapeColumns];
    block.LoadShape(d, i, Lighting::Shape::kColumns, shape);
    for (size_t j = 0; j < count; ++j)
      AddLightOverNormals<Lighting>(d, block, lights[j], i, spread, point.wo, shape, gated, sums);
  }
}

/// Shape parameters of a material without slots, at the points of a block. Models with the same shape share the kernel.
template <class Shape>
struct ConstantShape {
  HWY_NOINLINE explicit ConstantShape(const material::Material& material) {
    using D = hn::ScalableTag<float>;
    const D d;
    hn::Vec<D> value[material::kMaxShapeColumns];
    const material::HWY_NAMESPACE::SlotsAt<D> unset = {material::unset_parameters(), d, 0};
    Shape::Derive(d, material, unset, hn::Zero(d), value);
    for (uint32_t k = 0; k < Shape::kColumns; ++k) {
      for (size_t i = 0; i < kBlock; i += hn::Lanes(d)) hn::Store(value[k], d, column[k] + i);
    }
  }

  alignas(64) float column[Shape::kColumns + 1][kBlock];
};

/// Scales the sums over all lights.
template <class Lighting, class D>
HWY_NOINLINE void NormalizeBlock(D d, const Block& block, const Sums<Lighting>& sums) {
  using V = hn::Vec<D>;
  for (size_t i = 0; i < block.count; i += hn::Lanes(d)) {
    V shape[material::kMaxShapeColumns], sum[Lighting::kLobes][3];
    block.LoadShape(d, i, Lighting::Shape::kColumns, shape);
    for (uint32_t k = 0; k < 3 * Lighting::kLobes; ++k) sum[k / 3][k % 3] = hn::Load(d, sums.column[k / 3][k % 3] + i);
    Lighting::Normalize(d, shape, sum);
    for (uint32_t k = 0; k < 3 * Lighting::kLobes; ++k) hn::Store(sum[k / 3][k % 3], d, sums.column[k / 3][k % 3] + i);
  }
}

/// Whether NormalizeBlock() multiplies all sums by 1.
template <class Lighting>
HWY_NOINLINE bool is_normalized(const ConstantShape<typename Lighting::Shape>& constant, const LobeShape& shape) {
  using D = hn::ScalableTag<float>;
  using V = hn::Vec<D>;
  const D d;
  const V one = hn::Set(d, 1.0f);
  V values[material::kMaxShapeColumns], factor[Lighting::kLobes][3];
  for (uint32_t k = 0; k < Lighting::Shape::kColumns; ++k) {
    if (shape.column[k]) return false;
    values[k] = hn::Load(d, constant.column[k]);
  }
  for (uint32_t k = 0; k < 3 * Lighting::kLobes; ++k) factor[k / 3][k % 3] = one;
  Lighting::Normalize(d, values, factor);
  bool same = true;
  for (uint32_t k = 0; k < 3 * Lighting::kLobes; ++k) same = same && hn::AllTrue(d, hn::Eq(factor[k / 3][k % 3], one));
  return same;
}

template <class Lighting>
void IlluminatePoints(const material::Material& material, const LobeShape& shape, const ActiveLight* lights,
                      size_t count, const raster::Fragments& f, LightGroup group, material::Lobes& out) {
  const hn::ScalableTag<float> d;
  const bool gated =
      !Lighting::kGatesLobes && !(Lighting::kMayBeUngated && material.flags & SHD_MATERIAL_SPECULAR_UNGATED);
  const uint32_t lobes = material::info_of(material.model).lobes;  // no constant: gcc copies functions for those
  const ConstantShape<typename Lighting::Shape> constant(material);
  const bool scales = group.finishes && !is_normalized<Lighting>(constant, shape);
  for (size_t first = 0; first < f.count; first += kBlock) {
    Block block = {material, f, first, std::min(kBlock, f.count - first), {}};
    for (uint32_t k = 0; k < Lighting::Shape::kColumns; ++k) {
      block.shape[k] = shape.column[k] ? shape.column[k] + first : constant.column[k];
    }
    Sums<Lighting> sums;
    for (uint32_t k = 0; k < 3 * Lighting::kLobes; ++k) {
      sums.column[k / 3][k % 3] = out.lobe[k / 3][k % 3] + first;
    }
    if (!group.continues) StartSums(out, lobes, first);
    const bool over_normals = Lighting::kAveragesNormals && shape.spread[0];
    if constexpr (Lighting::kAveragesNormals) {
      if (over_normals) AddLightsOverNormals(block, shape.spread, lights, count, gated, sums);
    }
    for (size_t j = 0; j < count && !over_normals; ++j) AddLight(d, block, lights[j], gated, sums);
    if (scales) NormalizeBlock(d, block, sums);
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
      IlluminatePoints<Lighting>(material, shape, lights, count, points, group, out);
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
