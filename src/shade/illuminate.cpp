// SPDX-License-Identifier: MIT
#include "shade/illuminate.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shade/illuminate.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "light/incident-inl.h"
#include "material/blinn_phong-inl.h"
#include "material/lambert-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::shade::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::Dot;
using simd::HWY_NAMESPACE::Vec3V;

template <class D, class V>
HWY_INLINE void Accumulate(D d, const float* intensity, V factor, V (&sum)[3]) {
  for (int c = 0; c < 3; ++c) sum[c] = hn::Add(sum[c], hn::Mul(hn::Set(d, intensity[c]), factor));
}

template <bool kSpecular>
HWY_INLINE void IlluminateRows(const material::Material& material, const LightTable& lights,
                               const raster::Fragments& rows, Lobes& out) {
  const hn::ScalableTag<float> d;
  using V = hn::Vec<decltype(d)>;
  const bool gated = !(material.flags & SHD_SPECULAR_UNGATED);
  const V exponent = hn::Set(d, material.exponent), zero = hn::Zero(d);
  for (size_t i = 0; i < rows.count; i += hn::Lanes(d)) {
    const Vec3V<V> p = {hn::Load(d, rows.px + i), hn::Load(d, rows.py + i), hn::Load(d, rows.pz + i)};
    const Vec3V<V> n = {hn::Load(d, rows.nx + i), hn::Load(d, rows.ny + i), hn::Load(d, rows.nz + i)};
    const Vec3V<V> wo = {hn::Load(d, rows.ox + i), hn::Load(d, rows.oy + i), hn::Load(d, rows.oz + i)};
    V diffuse[3] = {zero, zero, zero}, specular[3] = {zero, zero, zero};
    for (size_t k = 0; k < lights.count; ++k) {
      const light::Light& light = lights.lights[k];
      const auto incident = light::HWY_NAMESPACE::IncidentAt(d, light, p);
      const V n_dot_l = Dot(n, incident.l);
      // Behind every row of the vector: all terms are +0, and adding them changes no bit.
      if ((gated || !kSpecular) && hn::AllFalse(d, hn::Gt(n_dot_l, zero))) continue;
      const V cosine = material::HWY_NAMESPACE::Lambert(d, n_dot_l);
      Accumulate(d, light.intensity, hn::Mul(incident.falloff, cosine), diffuse);
      if (kSpecular) {
        const V lobe = material::HWY_NAMESPACE::BlinnPhong(d, n, wo, incident.l, exponent);
        const V kept = gated ? hn::IfThenElseZero(hn::Gt(n_dot_l, zero), lobe) : lobe;
        Accumulate(d, light.intensity, hn::Mul(incident.falloff, kept), specular);
      }
    }
    for (int c = 0; c < 3; ++c) hn::Store(diffuse[c], d, out.diffuse[c] + i);
    if (!kSpecular) continue;
    for (int c = 0; c < 3; ++c) hn::Store(specular[c], d, out.specular[c] + i);
  }
}

void Illuminate(const material::Material& material, const LightTable& lights, const raster::Fragments& rows,
                Lobes& out) {
  if (material.model == SHD_MODEL_BLINN_PHONG) {
    IlluminateRows<true>(material, lights, rows, out);
  } else {
    IlluminateRows<false>(material, lights, rows, out);
  }
}

}  // namespace shd::shade::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::shade {

HWY_EXPORT(Illuminate);

void illuminate(const core::SimdTarget& simd, const material::Material& material, const LightTable& lights,
                const raster::Fragments& rows, Lobes* out) {
  SHD_DISPATCH(Illuminate, simd)(material, lights, rows, *out);
}

}  // namespace shd::shade
#endif  // HWY_ONCE
