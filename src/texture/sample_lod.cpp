// SPDX-License-Identifier: MIT
#include "texture/sample.h"

#include "core/simd_target.h"
#include "texture/profile.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/sample_lod.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/footprint-inl.h"
#include "texture/lod_block-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Writes the half axes in base texels: u and v of the longer, then of the shorter.
struct Axes {
  const Texture& texture;
  const Sampler& sampler;
  bool lod_given;

  template <class D>
  HWY_INLINE void operator()(D d, const Points<D>& p, const Texels& out, size_t i) const {
    const auto width = static_cast<float>(texture.width), height = static_cast<float>(texture.height);
    const Footprint<D> f = lod_given ? RoundFootprint(d, p.lod) : FootprintOf(d, p.derivatives, width, height);
    const auto shorter = hn::Mul(f.length, f.roundness);
    hn::StoreU(hn::Mul(f.length, f.u), d, out.channel[0] + i);
    hn::StoreU(hn::Mul(f.length, f.v), d, out.channel[1] + i);
    hn::StoreU(hn::Neg(hn::Mul(shorter, f.v)), d, out.channel[2] + i);
    hn::StoreU(hn::Mul(shorter, f.u), d, out.channel[3] + i);
  }
};

size_t LodBatch(const Texture& texture, const Sampler& sampler, const LodRange& range, const Lookups& in,
                const Texels& out) {
  return ForEachVector(texture, LevelOfDetail{texture, sampler, range, in.lod != nullptr}, in, out);
}
size_t AxesBatch(const Texture& texture, const Sampler& sampler, const Lookups& in, const Texels& out) {
  return ForEachVector(texture, Axes{texture, sampler, in.lod != nullptr}, in, out);
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::texture {
namespace {
HWY_EXPORT(LodBatch);
HWY_EXPORT(AxesBatch);
}  // namespace

size_t sample_lod(const Texture& texture, const Sampler& sampler, const LodRange& range, const core::SimdTarget& simd,
                  const Lookups& lookups, float* out) {
  if (sampler.profile != SHD_PROFILE_EXACT) {
    return profile_lod(texture, sampler, range, ProfileLod::kLongerAxis, simd, lookups, out);
  }
  return SHD_DISPATCH(LodBatch, simd)(texture, sampler, range, lookups, {{out}, {}, {}});
}

void sample_axes(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd, const Lookups& lookups,
                 const Texels& out) {
  SHD_DISPATCH(AxesBatch, simd)(texture, sampler, lookups, out);
}

}  // namespace shd::texture
#endif
