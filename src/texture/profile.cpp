// SPDX-License-Identifier: MIT
#include "texture/profile.h"

#include <cmath>
#include <cstring>

#include "core/simd_target.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/profile.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/profile-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class Profile>
struct LodPass {
  const Profile& profile;
  const Sampler& sampler;  // whose width and blur the batch applies
  LodRange range;
  ProfileFinish finish;
  bool lod_given;

  template <class D, class V>
  HWY_INLINE V Finished(D d, V lambda) const {
    const V lod = ClampLod(d, lambda, profile.sampler.lod_bias, range);
    if (finish == ProfileFinish::kNearest) return profile.NearestLevel(d, lod);
    if (finish == ProfileFinish::kNone || Profile::kLevelSteps == 0.0f) return lod;
    return RoundLevel(d, lod, Profile::kLevelSteps);
  }

  /// To the first column.
  template <class D>
  HWY_INLINE void operator()(D d, const Points<D>& p, const Texels& out, size_t i) const {
    const auto lambda = lod_given ? p.lod : profile.Lambda(d, p.derivatives);
    hn::StoreU(Finished(d, lambda), d, out.channel[0] + i);
  }
};

/// The columns of a ProbeLine and the reach.
template <class Profile>
struct ProbePass {
  LodPass<Profile> lods;
  const Sampler& sampler;

  template <class D>
  HWY_INLINE void operator()(D d, const Points<D>& p, const Texels& out, size_t i) const {
    const auto zero = hn::Zero(d), one = hn::Set(d, 1.0f);
    const Probes<D> probes =
        lods.lod_given ? Probes<D>{zero, zero, one, one, p.lod} : lods.profile.ProbesOf(d, p.derivatives);
    hn::StoreU(probes.step_u, d, out.channel[0] + i);
    hn::StoreU(probes.step_v, d, out.channel[1] + i);
    hn::StoreU(probes.count, d, out.channel[2] + i);
    hn::StoreU(lods.Finished(d, probes.lambda), d, out.channel[3] + i);
    hn::StoreU(probes.reach, d, out.du[0] + i);
  }
};

template <class Profile>
size_t RunPass(const Profile& profile, const Sampler& widening, const LodRange& range, ProfileFinish finish,
               bool probes, const Lookups& in, const Texels& out) {
  const LodPass<Profile> lods = {profile, widening, range, finish, in.lod != nullptr};
  if (!probes) return ForEachVector(profile.texture, lods, in, out);
  return ForEachVector(profile.texture, ProbePass<Profile>{lods, widening}, in, out);
}

/// To the columns of ProbePass, or to the one of LodPass.
size_t ProfilePass(const Texture& texture, const Sampler& sampler, const LodRange& range, ProfileFinish finish,
                   bool probes, const Lookups& in, const Texels& out) {
  switch (sampler.profile) {
    case SHD_PROFILE_VULKAN: return RunPass(VulkanProfile{texture, sampler}, sampler, range, finish, probes, in, out);
    case SHD_PROFILE_D3D11: return RunPass(D3d11Profile{texture, sampler}, sampler, range, finish, probes, in, out);
    default: {
      const Sampler plain = unwidened(sampler);  // it widens by itself
      const OiioProfile profile = {texture, sampler, finish == ProfileFinish::kNearest};
      return RunPass(profile, plain, range, finish, probes, in, out);
    }
  }
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::texture {
namespace {
HWY_EXPORT(ProfilePass);

/// The sampler of the kernels that take a block as given.
Sampler given_sampler(const Sampler& sampler) {
  Sampler given = unwidened(sampler);
  given.profile = SHD_PROFILE_EXACT;
  given.lod_bias = 0.0f;
  given.lod_min = 0.0f;
  given.lod_max = static_cast<float>(kMaxLevels);
  given.probes_given = sampler.filter == SHD_FILTER_ANISOTROPIC;
  given.probe_weights = sampler.profile == SHD_PROFILE_OIIO ? SHD_PROBE_WEIGHTS_GAUSSIAN : SHD_PROBE_WEIGHTS_EQUAL;
  return given;
}

}  // namespace

bool is_profiled(const Sampler& sampler) {
  if (sampler.profile == SHD_PROFILE_EXACT) return false;
  return sampler.filter == SHD_FILTER_NEAREST_MIP || sampler.filter == SHD_FILTER_BILINEAR_MIP ||
         sampler.filter == SHD_FILTER_TRILINEAR || sampler.filter == SHD_FILTER_ANISOTROPIC;
}

uint32_t nearest_level(const Sampler& sampler, float lod) {
  switch (sampler.profile) {
    case SHD_PROFILE_D3D11: return static_cast<uint32_t>(std::floor(lod * 256.0f + 0.5f) / 256.0f + 0.5f);
    case SHD_PROFILE_OIIO: return static_cast<uint32_t>(std::ceil(lod));
    default: return static_cast<uint32_t>(std::ceil(lod + 0.5f) - 1.0f);
  }
}

bool has_rounded_weights(const shd_sampler_desc& desc) {
  if (desc.profile != SHD_PROFILE_VULKAN && desc.profile != SHD_PROFILE_D3D11) return false;
  return desc.filter == SHD_FILTER_BILINEAR || desc.filter == SHD_FILTER_NEAREST_MIP ||
         desc.filter == SHD_FILTER_BILINEAR_MIP || desc.filter == SHD_FILTER_TRILINEAR ||
         desc.filter == SHD_FILTER_ANISOTROPIC;
}

void profile_block(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd, const Lookups& in,
                   ProfiledBlock* out) {
  const bool probes = sampler.filter == SHD_FILTER_ANISOTROPIC;
  const ProfileFinish finish =
      probes || sampler.filter == SHD_FILTER_TRILINEAR ? ProfileFinish::kRounded : ProfileFinish::kNearest;
  auto& c = out->columns;
  out->sampler = given_sampler(sampler);
  out->nonfinite = SHD_DISPATCH(ProfilePass, simd)(texture, sampler, lod_range(texture, sampler), finish, probes, in,
                                                   {{c[0], c[1], c[2], c[3]}, {c[4]}, {}});
  if (probes) {
    std::memcpy(out->reach, c[4], in.count * sizeof(float));
    out->lookups = {in.count, in.u, in.v, c[0], c[1], c[2], c[3], nullptr, in.layer, out->reach};
  } else {
    out->lookups = {in.count, in.u, in.v, nullptr, nullptr, nullptr, nullptr, c[0], in.layer, in.random};
  }
}

size_t profile_lod(const Texture& texture, const Sampler& sampler, const LodRange& range, ProfileLod which,
                   const core::SimdTarget& simd, const Lookups& in, float* out) {
  const auto pass = SHD_DISPATCH(ProfilePass, simd);
  if (which == ProfileLod::kLongerAxis) {
    return pass(texture, sampler, range, ProfileFinish::kNone, false, in, {{out}, {}, {}});
  }
  alignas(64) float unused[4][kProfileBlock];
  size_t nonfinite = 0;
  for (size_t first = 0; first < in.count; first += kProfileBlock) {
    const Lookups block = part_of(in, first, in.count - first < kProfileBlock ? in.count - first : kProfileBlock);
    nonfinite += pass(texture, sampler, range, ProfileFinish::kNone, true, block,
                      {{unused[0], unused[1], unused[2], out + first}, {unused[3]}, {}});
  }
  return nonfinite;
}

}  // namespace shd::texture
#endif
