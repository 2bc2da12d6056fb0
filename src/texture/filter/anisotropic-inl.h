// SPDX-License-Identifier: MIT

#if defined(SHD_TEXTURE_ANISOTROPIC_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_ANISOTROPIC_INL_H_
#undef SHD_TEXTURE_ANISOTROPIC_INL_H_
#else
#define SHD_TEXTURE_ANISOTROPIC_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/filter/bases-inl.h"
#include "texture/filter/probe_line-inl.h"
#include "texture/stream.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The filter SHD_FILTER_ANISOTROPIC. All probes read the same two levels. Bilinear lookups on the finer level form the
/// first average, lookups on the coarser level the second. The merge blends the averages by the fraction between the
/// levels.
struct Anisotropic : OnMipLevels {
  using OnMipLevels::OnMipLevels;
  using Block = ProbeBlock;

  static size_t find(const Texture& texture, const Sampler& sampler, const Lookups& in, ProbeBlock* block) {
    return FindProbes(texture, sampler, lod_range(texture, sampler), LodRounding::kFilter, in, block);
  }

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const ProbeBlock& block, size_t i, Sink& sink) const {
    using V = hn::Vec<D>;
    const ProbeLine<D> line(d, sampler, block, i);
    const LevelPair<D> levels = LevelsOf(d, texture, FirstTexel(d, texture, block, i), hn::Load(d, block.lod + i));
    const float max_probes = hn::GetLane(hn::MaxOfLanes(d, line.probes));
    const V reach = hn::Load(d, block.reach + i);
    V total = hn::Zero(d);
    uint32_t how = kStart;
    for (float k = 0.0f; k < max_probes; k += 1.0f) {
      // Finished lanes repeat their last probe with weight 0.
      const V position = line.position(d, hn::Set(d, k));
      const V u = line.u_at(position), v = line.v_at(position);
      const auto active = hn::Lt(hn::Set(d, k), line.probes);
      V share;
      if (sampler.probe_weights == SHD_PROBE_WEIGHTS_EQUAL) {
        share = hn::IfThenElseZero(active, hn::Set(d, 1.0f / (k + 1.0f)));
      } else {
        const V weight = hn::IfThenElseZero(active, ProbeGaussian(d, position / reach));
        total = total + weight;
        share = weight / total;
      }
      sink.quad(d, how, levels.high, u, v, share);
      if (levels.blended) sink.quad(d, how | kSecond, levels.low, u, v, share);
      how = kBlend;
    }
    if (levels.blended) sink.merge(d, levels.fraction);
    sink.finish();
  }
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_ANISOTROPIC_INL_H_
