// SPDX-License-Identifier: MIT
// Probes along the longer axis of the footprint (McCormack, Perry, Farkas and Jouppi, "Feline: Fast Elliptical Lines
// for Anisotropic Texture Mapping", 1999).
#include "texture/footprint/probes.h"

#include "core/simd_target.h"
#include "texture/footprint/profile.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/footprint/probes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/footprint/points-inl.h"
#include "texture/footprint/shapes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Part of a probe's width that the footprint may exceed its probes by before it gets another probe. Alternatives on a
/// receding floor (2048^2 checkerboard): 1/2 in place of 1/8 costs 3.3 dB. More than one probe per width of the shorter
/// axis is slower and gains at most 0.6 dB. Probes up to the ends of the footprint, instead of half a width before
/// them, cost 5 dB.
constexpr float kSlack = 0.125f;

size_t FindProbes(const Texture& texture, const Sampler& sampler, const LodRange& range, LodRounding rounding,
                  const Lookups& in, ProbeBlock* out) {
  if (uses_profile(sampler, rounding)) return FindProfiledProbes(texture, sampler, range, rounding, in, out);
  const auto width = static_cast<float>(texture.width), height = static_cast<float>(texture.height);
  const bool lod_given = in.lod != nullptr;
  return FillBlock(texture, sampler, in, out, [&](auto d, const auto& p, size_t to) SHD_INLINE_LAMBDA {
    const auto f = lod_given ? RoundFootprint(d, p.lod) : FootprintOf(d, p.derivatives, width, height);
    const auto one = hn::Set(d, 1.0f), limit = hn::Set(d, 0x1p60f);
    const auto ratio = one / hn::Max(f.roundness, hn::Set(d, 1.0f / sampler.max_anisotropy));
    const auto lambda = f.lambda - simd::HWY_NAMESPACE::Log2(d, ratio);
    const auto probes = hn::Ceil(ratio - hn::Set(d, kSlack));
    const auto half_step = f.length / (probes + probes);
    const auto step_u = half_step * f.u / hn::Set(d, width), step_v = half_step * f.v / hn::Set(d, height);
    hn::Store(hn::Max(hn::Min(step_u, limit), hn::Neg(limit)), d, out->step_u + to);
    hn::Store(hn::Max(hn::Min(step_v, limit), hn::Neg(limit)), d, out->step_v + to);
    hn::Store(probes, d, out->probes + to);
    hn::Store(probes, d, out->reach + to);
    hn::Store(ClampLod(d, lambda, sampler.lod_bias, range), d, out->lod + to);
  });
}

/// Implements find_probes().
size_t ProbesOfFilter(const Texture& texture, const Sampler& sampler, const Lookups& in, ProbeBlock* out) {
  return FindProbes(texture, sampler, lod_range(texture, sampler), LodRounding::kFilter, in, out);
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::texture {
namespace {
HWY_EXPORT(ProbesOfFilter);
}  // namespace

size_t find_probes(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd, const Lookups& lookups,
                   ProbeBlock* out) {
  return SHD_DISPATCH(ProbesOfFilter, simd)(texture, sampler, lookups, out);
}

}  // namespace shd::texture
#endif
