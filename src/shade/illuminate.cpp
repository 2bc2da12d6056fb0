// SPDX-License-Identifier: MIT
#include "shade/illuminate.h"

#include <type_traits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shade/illuminate.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "light/incident-inl.h"
#include "material/blinn_phong-inl.h"
#include "material/lambert-inl.h"
#include "material/metallic_roughness-inl.h"
#include "material/phong-inl.h"
#include "material/roughness-inl.h"
#include "material/toon-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::shade::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::Dot;
using simd::HWY_NAMESPACE::Vec3V;

/// A vector of rows and what shapes their lobes.
template <class V>
struct Rows {
  Vec3V<V> n, wo;
  V exponent, alpha_squared;
};

/// One light at a vector of rows.
template <class V>
struct Arriving {
  Vec3V<V> l;
  V n_dot_l;
};

// What each model makes of one light: its lobes over E.

struct LambertModel {
  static constexpr uint32_t kLobes = 1;
  template <class D, class V>
  HWY_INLINE void Add(D d, const material::Material&, const Rows<V>&, const Arriving<V>& in, V (&lobe)[1]) const {
    lobe[0] = material::HWY_NAMESPACE::Lambert(d, in.n_dot_l);
  }
};

struct BlinnPhongModel {
  static constexpr uint32_t kLobes = 2;
  template <class D, class V>
  HWY_INLINE void Add(D d, const material::Material&, const Rows<V>& r, const Arriving<V>& in, V (&lobe)[2]) const {
    lobe[0] = material::HWY_NAMESPACE::Lambert(d, in.n_dot_l);
    lobe[1] = material::HWY_NAMESPACE::BlinnPhong(d, r.n, r.wo, in.l, r.exponent);
  }
};

struct NormalizedModel {
  static constexpr uint32_t kLobes = 2;
  template <class D, class V>
  HWY_INLINE void Add(D d, const material::Material&, const Rows<V>& r, const Arriving<V>& in, V (&lobe)[2]) const {
    lobe[0] = material::HWY_NAMESPACE::Lambert(d, in.n_dot_l);
    lobe[1] = hn::Mul(lobe[0], material::HWY_NAMESPACE::BlinnPhong(d, r.n, r.wo, in.l, r.exponent));
  }
};

struct PhongModel {
  static constexpr uint32_t kLobes = 2;
  template <class D, class V>
  HWY_INLINE void Add(D d, const material::Material&, const Rows<V>& r, const Arriving<V>& in, V (&lobe)[2]) const {
    lobe[0] = material::HWY_NAMESPACE::Lambert(d, in.n_dot_l);
    lobe[1] = material::HWY_NAMESPACE::Phong(d, r.n, r.wo, in.l, in.n_dot_l, r.exponent);
  }
};

struct ToonModel {
  static constexpr uint32_t kLobes = 2;
  template <class D, class V>
  HWY_INLINE void Add(D d, const material::Material& m, const Rows<V>& r, const Arriving<V>& in, V (&lobe)[2]) const {
    const V cosine = material::HWY_NAMESPACE::Lambert(d, in.n_dot_l);
    lobe[0] = material::HWY_NAMESPACE::ToonDiffuse(d, cosine, m.toon_steps);
    const V shine = material::HWY_NAMESPACE::BlinnPhong(d, r.n, r.wo, in.l, r.exponent);
    lobe[1] = material::HWY_NAMESPACE::ToonSpecular(d, shine);
  }
};

struct MetallicRoughnessModel {
  static constexpr uint32_t kLobes = 3;
  template <class D, class V>
  HWY_INLINE void Add(D d, const material::Material&, const Rows<V>& r, const Arriving<V>& in, V (&lobe)[3]) const {
    const auto lobes = material::HWY_NAMESPACE::MetallicRoughnessLobes(d, r.n, r.wo, in.l, in.n_dot_l, r.alpha_squared);
    lobe[0] = lobes.diffuse;
    lobe[1] = lobes.mirror;
    lobe[2] = lobes.edge;
  }
};

/// Adds I w, or what texture and shadow leave of it, to a lobe's channels. Nothing stays nothing, whatever the texel.
template <class D, class V>
HWY_INLINE void Accumulate(D d, const ActiveLight& active, size_t i, V w, V (&sum)[3]) {
  const auto gives = hn::Gt(w, hn::Zero(d));
  for (int c = 0; c < 3; ++c) {
    const V left = active.factor[c] ? hn::IfThenElseZero(gives, hn::Mul(w, hn::Load(d, active.factor[c] + i))) : w;
    sum[c] = hn::Add(sum[c], hn::Mul(hn::Set(d, active.light->intensity[c]), left));
  }
}

/// Reads and writes columns from row i on.
template <class D>
struct At {
  D d;
  size_t i;
  HWY_INLINE hn::Vec<D> Load(const float* column, float constant) const {
    return column ? hn::Load(d, column + i) : hn::Set(d, constant);
  }
  HWY_INLINE Vec3V<hn::Vec<D>> Load3(const float* x, const float* y, const float* z) const {
    return {hn::Load(d, x + i), hn::Load(d, y + i), hn::Load(d, z + i)};
  }
};

/// What is the same for all lights of a row: N of the normalised model, and the gain, on specular lobes.
template <class Model, class D, class V>
HWY_INLINE void Finish(D d, const Shape& shape, const Rows<V>& r, size_t i, V (&sum)[Model::kLobes][3]) {
  if constexpr (Model::kLobes == 2) {
    V scale = shape.gain ? hn::Load(d, shape.gain + i) : hn::Set(d, 1.0f);
    if constexpr (std::is_same_v<Model, NormalizedModel>) {
      scale = material::HWY_NAMESPACE::BlinnPhongNorm(d, r.exponent);
    }
    if (!shape.gain && !std::is_same_v<Model, NormalizedModel>) return;
    for (int c = 0; c < 3; ++c) sum[1][c] = hn::Mul(sum[1][c], scale);
  }
}

template <class Model>
HWY_INLINE void IlluminateRows(const material::Material& material, const Shape& shape, const ActiveLight* lights,
                               size_t count, const raster::Fragments& f, bool continues, bool finishes, Lobes& out) {
  const hn::ScalableTag<float> d;
  using V = hn::Vec<decltype(d)>;
  constexpr uint32_t kLobes = Model::kLobes;
  const bool gated = kLobes != 2 || !(material.flags & SHD_SPECULAR_UNGATED);
  const float alpha = hn::GetLane(material::HWY_NAMESPACE::AlphaSquared(d, hn::Set(d, material.roughness)));
  const V zero = hn::Zero(d);
  for (size_t i = 0; i < f.count; i += hn::Lanes(d)) {
    const At<decltype(d)> at = {d, i};
    const Vec3V<V> p = at.Load3(f.px, f.py, f.pz);
    const Rows<V> r = {at.Load3(f.nx, f.ny, f.nz), at.Load3(f.ox, f.oy, f.oz),
                       at.Load(shape.exponent, material.exponent), at.Load(shape.alpha_squared, alpha)};
    V sum[kLobes][3];
    for (uint32_t k = 0; k < kLobes; ++k) {
      for (int c = 0; c < 3; ++c) sum[k][c] = continues ? hn::Load(d, out.lobe[k][c] + i) : zero;
    }
    for (size_t j = 0; j < count; ++j) {
      const auto incident = light::HWY_NAMESPACE::IncidentAt(d, *lights[j].light, p);
      const V n_dot_l = Dot(r.n, incident.l);
      const auto faces = hn::Gt(n_dot_l, zero);
      // Behind every row of the vector: all terms are +0, and adding them changes no bit.
      if ((gated || kLobes == 1) && hn::AllFalse(d, faces)) continue;
      V lobe[kLobes];
      Model().Add(d, material, r, Arriving<V>{incident.l, n_dot_l}, lobe);
      for (uint32_t k = 0; k < kLobes; ++k) {
        const V kept = k && gated ? hn::IfThenElseZero(faces, lobe[k]) : lobe[k];
        Accumulate(d, lights[j], i, hn::Mul(incident.falloff, kept), sum[k]);
      }
    }
    if (finishes) Finish<Model>(d, shape, r, i, sum);
    for (uint32_t k = 0; k < kLobes; ++k) {
      for (int c = 0; c < 3; ++c) hn::Store(sum[k][c], d, out.lobe[k][c] + i);
    }
  }
}

/// (1 + n.l) / 2, whatever the light gives.
void IlluminateGooch(const ActiveLight* lights, size_t count, const raster::Fragments& f, bool continues, Lobes& out) {
  const hn::ScalableTag<float> d;
  using V = hn::Vec<decltype(d)>;
  const V half = hn::Set(d, 0.5f);
  for (size_t i = 0; i < f.count; i += hn::Lanes(d)) {
    const At<decltype(d)> at = {d, i};
    const Vec3V<V> p = at.Load3(f.px, f.py, f.pz), n = at.Load3(f.nx, f.ny, f.nz);
    V sum = continues ? hn::Load(d, out.lobe[0][0] + i) : hn::Zero(d);
    for (size_t j = 0; j < count; ++j) {
      const auto incident = light::HWY_NAMESPACE::IncidentAt(d, *lights[j].light, p);
      sum = hn::Add(sum, hn::Add(half, hn::Mul(half, Dot(n, incident.l))));
    }
    for (int c = 0; c < 3; ++c) hn::Store(sum, d, out.lobe[0][c] + i);
  }
}

void Illuminate(const material::Material& m, const Shape& shape, const ActiveLight* lights, size_t count,
                const raster::Fragments& f, LightGroup group, Lobes& out) {
  const bool more = group.continues, last = group.finishes;
  switch (m.model) {
    case SHD_MODEL_BLINN_PHONG:
    case SHD_MODEL_COMBINED: return IlluminateRows<BlinnPhongModel>(m, shape, lights, count, f, more, last, out);
    case SHD_MODEL_BLINN_PHONG_NORMALIZED:
      return IlluminateRows<NormalizedModel>(m, shape, lights, count, f, more, last, out);
    case SHD_MODEL_PHONG: return IlluminateRows<PhongModel>(m, shape, lights, count, f, more, last, out);
    case SHD_MODEL_TOON: return IlluminateRows<ToonModel>(m, shape, lights, count, f, more, last, out);
    case SHD_MODEL_METALLIC_ROUGHNESS:
      return IlluminateRows<MetallicRoughnessModel>(m, shape, lights, count, f, more, last, out);
    case SHD_MODEL_GOOCH: return IlluminateGooch(lights, count, f, more, out);
    default: return IlluminateRows<LambertModel>(m, shape, lights, count, f, more, last, out);
  }
}

}  // namespace shd::shade::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::shade {

HWY_EXPORT(Illuminate);

void illuminate(const core::SimdTarget& simd, const material::Material& material, const Shape& shape,
                const ActiveLight* lights, size_t count, const raster::Fragments& rows, LightGroup group, Lobes* out) {
  SHD_DISPATCH(Illuminate, simd)(material, shape, lights, count, rows, group, *out);
}

}  // namespace shd::shade
#endif  // HWY_ONCE
