// SPDX-License-Identifier: MIT
#include "shade/combine.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shade/combine.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace shd::shade::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A coefficient: a constant times a column, if there is one.
struct Coefficient {
  float constant;
  const float* column;
  template <class D>
  HWY_INLINE hn::Vec<D> Get(D d, size_t i) const {
    const auto value = hn::Set(d, constant);
    return column ? hn::Mul(value, hn::Load(d, column + i)) : value;
  }
};

/// What one channel of a model is made of.
struct Channel {
  Coefficient diffuse, specular, ambient;  // k_d; k_s; k_a I_a of the material
  Coefficient metallic, emission;
  Coefficient occlusion;  // o alone
  const float* lobe[kMaxLobes];
};

/// L without emission of each model at rows from i on. `ambient` is occluded.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V Reflect(D d, const material::Material& m, const Channel& c, float lights, int channel, V ambient,
                     size_t i) {
  const V diffuse = c.diffuse.Get(d, i);
  const auto lobe = [&](int k) { return hn::Load(d, c.lobe[k] + i); };
  switch (m.model) {
    case SHD_MODEL_UNLIT: return diffuse;
    case SHD_MODEL_LAMBERT: return hn::Add(ambient, hn::Mul(diffuse, lobe(0)));
    case SHD_MODEL_COMBINED:
      return hn::Add(hn::Mul(diffuse, hn::Add(ambient, lobe(0))), hn::Mul(c.specular.Get(d, i), lobe(1)));
    case SHD_MODEL_BLINN_PHONG_NORMALIZED: {
      const V scattered = hn::Mul(hn::Mul(diffuse, hn::Set(d, 0.318309886f)), lobe(0));
      return hn::Add(hn::Add(ambient, scattered), hn::Mul(c.specular.Get(d, i), lobe(1)));
    }
    case SHD_MODEL_GOOCH: {
      const V warmth = lights > 0.0f ? hn::Div(lobe(0), hn::Set(d, lights)) : hn::Set(d, 0.5f);
      const V warm = hn::Add(hn::Set(d, m.warm[channel]), hn::Mul(hn::Set(d, m.warm_mix), diffuse));
      const V cool = hn::Add(hn::Set(d, m.cool[channel]), hn::Mul(hn::Set(d, m.cool_mix), diffuse));
      return hn::Add(hn::Mul(warmth, warm), hn::Mul(hn::Sub(hn::Set(d, 1.0f), warmth), cool));
    }
    case SHD_MODEL_METALLIC_ROUGHNESS: {
      const V one = hn::Set(d, 1.0f), f = hn::Set(d, m.dielectric);
      const V metallic = c.metallic.Get(d, i), rest = hn::Sub(one, metallic);
      const V scattering = hn::Mul(diffuse, rest);
      const V mirror = hn::Add(hn::Mul(f, rest), hn::Mul(diffuse, metallic));
      const V scattered = hn::Mul(hn::Mul(hn::Mul(scattering, hn::Sub(one, f)), hn::Set(d, 0.318309886f)), lobe(0));
      const V reflected = hn::Add(hn::Mul(mirror, lobe(1)), lobe(2));
      return hn::Add(hn::Mul(ambient, hn::Add(scattering, mirror)), hn::Add(scattered, reflected));
    }
    case SHD_MODEL_MATCAP: return hn::Mul(diffuse, lobe(0));
    case SHD_MODEL_SHOW_NORMAL:
    case SHD_MODEL_SHOW_UV:
    case SHD_MODEL_SHOW_LEVEL:
    case SHD_MODEL_SHOW_BARYCENTRICS: return lobe(0);
    default:  // Phong, Blinn-Phong, toon
      return hn::Add(hn::Add(ambient, hn::Mul(diffuse, lobe(0))), hn::Mul(c.specular.Get(d, i), lobe(1)));
  }
}

Channel ChannelOf(const material::Material& m, const float* ambient, const Lobes& lobes, const Parameters& p, int c) {
  Channel channel = {{m.diffuse[c], p.value[SHD_SLOT_DIFFUSE][c]},
                     {m.specular[c], p.value[SHD_SLOT_SPECULAR][c]},
                     {ambient[c], p.value[SHD_SLOT_AMBIENT][c]},
                     {m.metallic, p.value[SHD_SLOT_METALLIC][0]},
                     {m.emission[c], p.value[SHD_SLOT_EMISSION][c]},
                     {1.0f, p.value[SHD_SLOT_OCCLUSION][0]},
                     {}};
  for (uint32_t k = 0; k < kMaxLobes; ++k) channel.lobe[k] = lobes.lobe[k][c];
  return channel;
}

/// One channel of all rows. The model is the same for all of them: the compiler takes the choice out of the loop.
void CombineChannel(const material::Material& m, const Channel& c, float lights, int channel, size_t count,
                    float* out) {
  const hn::ScalableTag<float> d;
  const auto one = hn::Set(d, 1.0f), strength = hn::Set(d, m.occlusion_strength);
  const bool emits = m.emission[channel] > 0.0f;
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    auto ambient = c.ambient.Get(d, i);
    if (c.occlusion.column) {
      ambient = hn::Mul(ambient, hn::Add(one, hn::Mul(strength, hn::Sub(c.occlusion.Get(d, i), one))));
    }
    auto sum = Reflect(d, m, c, lights, channel, ambient, i);
    if (emits) sum = hn::Add(sum, c.emission.Get(d, i));
    hn::Store(sum, d, out + i);
  }
}

void Combine(const material::Material& material, const float* ambient, float lights, const Lobes& lobes,
             const Parameters& parameters, size_t count, Radiance& out) {
  const hn::ScalableTag<float> d;
  for (int c = 0; c < 3; ++c) {
    CombineChannel(material, ChannelOf(material, ambient, lobes, parameters, c), lights, c, count, out.channel[c]);
  }
  const bool has_opacity = material::has_opacity(material);
  const Coefficient opacity = {has_opacity ? material.opacity : 1.0f,
                               has_opacity ? parameters.value[SHD_SLOT_OPACITY][0] : nullptr};
  const Coefficient texel = {1.0f, has_opacity ? parameters.value[SHD_SLOT_DIFFUSE][3] : nullptr};
  const bool premultiplied = material.blend != SHD_BLEND_OPAQUE && material.blend != SHD_BLEND_STRAIGHT;
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    auto a = opacity.Get(d, i);
    if (texel.column) a = hn::Mul(a, texel.Get(d, i));
    hn::Store(a, d, out.channel[3] + i);
    for (int c = 0; premultiplied && c < 3; ++c) {
      hn::Store(hn::Mul(a, hn::Load(d, out.channel[c] + i)), d, out.channel[c] + i);
    }
  }
}

void SpreadCorners(const raster::Fragments& fragments, const uint32_t* rows, const float* in, float* out) {
  const hn::ScalableTag<float> d;
  const hn::RebindToSigned<decltype(d)> di;
  const auto one = hn::Set(di, 1);
  const auto* signed_rows = reinterpret_cast<const int32_t*>(rows);
  for (size_t i = 0; i < fragments.count; i += hn::Lanes(d)) {
    const auto row = hn::Load(di, signed_rows + i);
    const auto a0 = hn::GatherIndex(d, in, row);
    const auto a1 = hn::Sub(hn::GatherIndex(d, in, hn::Add(row, one)), a0);
    const auto a2 = hn::Sub(hn::GatherIndex(d, in, hn::Add(row, hn::Add(one, one))), a0);
    const auto sum = hn::Add(a0, hn::Mul(hn::Load(d, fragments.bary[1] + i), a1));
    hn::Store(hn::Add(sum, hn::Mul(hn::Load(d, fragments.bary[2] + i), a2)), d, out + i);
  }
}

}  // namespace shd::shade::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::shade {

HWY_EXPORT(Combine);
HWY_EXPORT(SpreadCorners);

void combine(const core::SimdTarget& simd, const material::Material& material, const LightTable& lights,
             const Lobes& lobes, const Parameters& parameters, size_t count, Radiance* out) {
  const auto light_count = static_cast<float>(lights.count);
  const float times = material.flags & SHD_AMBIENT_PER_LIGHT ? light_count : 1.0f;
  const bool own_ambient = material.model != SHD_MODEL_COMBINED;
  float ambient[3];
  for (int c = 0; c < 3; ++c) ambient[c] = (own_ambient ? material.ambient[c] : 1.0f) * lights.ambient[c] * times;
  SHD_DISPATCH(Combine, simd)(material, ambient, light_count, lobes, parameters, count, *out);
}

void spread_corners(const core::SimdTarget& simd, const raster::Fragments& fragments, const uint32_t* rows,
                    const float* in, float* out) {
  SHD_DISPATCH(SpreadCorners, simd)(fragments, rows, in, out);
}

void spread_centroids(const uint32_t* rows, size_t count, const float* in, float* out) {
  for (size_t i = 0; i < count; ++i) out[i] = in[rows[i]];
}

}  // namespace shd::shade
#endif  // HWY_ONCE
