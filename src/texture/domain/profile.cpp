// SPDX-License-Identifier: MIT
#include "texture/domain/profile.h"

#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/domain/profile.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/domain/profile-inl.h"
#include "texture/domain/shapes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Rounding of a level of detail after bias and clamps: none, fraction to 8 bits, or nearest level.
enum class Finish { kNone, kFraction, kNearest };

Finish finish_of(const Sampler& sampler, LodRounding rounding) {
  if (rounding == LodRounding::kNone) return Finish::kNone;
  const bool one_level = sampler.filter == SHD_FILTER_NEAREST_MIP || sampler.filter == SHD_FILTER_BILINEAR_MIP;
  return one_level ? Finish::kNearest : Finish::kFraction;
}

template <class Profile, class D, class V>
HWY_INLINE V Finished(D d, const Profile& profile, const LodRange& range, Finish finish, V lambda) {
  const V lod = ClampLod(d, lambda, profile.sampler.lod_bias, range);
  if (finish == Finish::kNearest) return profile.NearestLevel(d, lod);
  if (finish == Finish::kNone || Profile::kLevelSteps == 0.0f) return lod;
  return RoundLevel(d, lod, Profile::kLevelSteps);
}

/// Calls body(profile, widening). FillBlock() applies width and blur of the sampler `widening`, which has none if the
/// profile applies them itself.
template <class Body>
HWY_INLINE size_t WithProfile(const Texture& texture, const Sampler& sampler, Finish finish, const Body& body) {
  switch (sampler.profile) {
    case SHD_PROFILE_VULKAN: return body(VulkanProfile{texture, sampler}, sampler);
    case SHD_PROFILE_D3D11: return body(D3d11Profile{texture, sampler}, sampler);
    default: return body(OiioProfile{texture, sampler, finish == Finish::kNearest}, unwidened(sampler));
  }
}

size_t FindProfiledLods(const Texture& texture, const Sampler& sampler, const LodRange& range, LodRounding rounding,
                        const Lookups& in, LodBlock* out) {
  const Finish finish = finish_of(sampler, rounding);
  const bool lod_given = in.lod != nullptr;
  return WithProfile(texture, sampler, finish, [&](const auto& profile, const Sampler& widening) {
    return FillBlock(texture, widening, in, out, [&](auto d, const auto& p, size_t to) SHD_INLINE_LAMBDA {
      const auto lambda = lod_given ? p.lod : profile.Lambda(d, p.derivatives);
      hn::Store(Finished(d, profile, range, finish, lambda), d, out->lod + to);
    });
  });
}

size_t FindProfiledProbes(const Texture& texture, const Sampler& sampler, const LodRange& range, LodRounding rounding,
                          const Lookups& in, ProbeBlock* out) {
  const Finish finish = finish_of(sampler, rounding);
  const bool lod_given = in.lod != nullptr;
  return WithProfile(texture, sampler, finish, [&](const auto& profile, const Sampler& widening) {
    return FillBlock(texture, widening, in, out, [&](auto d, const auto& p, size_t to) SHD_INLINE_LAMBDA {
      using D = decltype(d);
      const auto zero = hn::Zero(d), one = hn::Set(d, 1.0f);
      const Probes<D> probes = lod_given ? Probes<D>{zero, zero, one, one, p.lod} : profile.ProbesOf(d, p.derivatives);
      hn::Store(probes.step_u, d, out->step_u + to);
      hn::Store(probes.step_v, d, out->step_v + to);
      hn::Store(probes.count, d, out->probes + to);
      hn::Store(probes.reach, d, out->reach + to);
      hn::Store(Finished(d, profile, range, finish, probes.lambda), d, out->lod + to);
    });
  });
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::texture {

uint32_t nearest_level(const Sampler& sampler, float lod) {
  switch (sampler.profile) {
    case SHD_PROFILE_D3D11: return static_cast<uint32_t>(std::floor(lod * 256.0f + 0.5f) / 256.0f + 0.5f);
    case SHD_PROFILE_OIIO: return static_cast<uint32_t>(std::ceil(lod));
    default: return static_cast<uint32_t>(std::ceil(lod + 0.5f) - 1.0f);
  }
}

Weights weights_of(const shd_sampler_desc& desc) {
  if (desc.filter == SHD_FILTER_HERMITE) return Weights::kHermite;
  if (desc.profile != SHD_PROFILE_VULKAN && desc.profile != SHD_PROFILE_D3D11) return Weights::kLinear;
  const bool rounded = desc.filter == SHD_FILTER_BILINEAR || desc.filter == SHD_FILTER_ANISOTROPIC ||
                       reads_isotropic_levels(desc.filter);
  return rounded ? Weights::kRounded : Weights::kLinear;
}

}  // namespace shd::texture
#endif
