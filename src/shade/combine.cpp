// SPDX-License-Identifier: MIT
#include "shade/combine.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shade/combine.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace shd::shade::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

void Combine(const material::Material& material, const float* ambient, const Lobes* lobes, const float* const* texture,
             size_t count, Radiance& out) {
  const hn::ScalableTag<float> d;
  const bool specular = material.model == SHD_MODEL_BLINN_PHONG;
  for (int c = 0; c < 3; ++c) {
    const auto base = hn::Set(d, ambient[c]);
    const auto kd = hn::Set(d, material.diffuse[c]), ks = hn::Set(d, material.specular[c]);
    for (size_t i = 0; i < count; i += hn::Lanes(d)) {
      const auto albedo = texture ? hn::Mul(kd, hn::Load(d, texture[c] + i)) : kd;
      auto sum = lobes ? hn::Add(base, hn::Mul(albedo, hn::Load(d, lobes->diffuse[c] + i))) : albedo;
      if (specular) sum = hn::Add(sum, hn::Mul(ks, hn::Load(d, lobes->specular[c] + i)));
      hn::Store(sum, d, out.channel[c] + i);
    }
  }
  const auto opacity = hn::Set(d, has_opacity(material) ? material.opacity : 1.0f);
  const bool textured = texture && has_opacity(material);
  const bool premultiplied = material.blend != SHD_BLEND_OPAQUE && material.blend != SHD_BLEND_STRAIGHT;
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto a = textured ? hn::Mul(opacity, hn::Load(d, texture[3] + i)) : opacity;
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
             const Lobes* lobes, const float* const texture[4], size_t count, Radiance* out) {
  const float times = material.flags & SHD_AMBIENT_PER_LIGHT ? static_cast<float>(lights.count) : 1.0f;
  float ambient[3];
  for (int c = 0; c < 3; ++c) ambient[c] = material.ambient[c] * lights.ambient[c] * times;
  SHD_DISPATCH(Combine, simd)(material, ambient, lobes, texture, count, *out);
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
