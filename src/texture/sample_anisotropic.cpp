// SPDX-License-Identifier: MIT
// Trilinear probes along the longer axis of the footprint (McCormack, Perry, Farkas and Jouppi, "Feline: Fast
// Elliptical Lines for Anisotropic Texture Mapping", 1999), on the level of its shorter one.
#include "texture/sample.h"

#include <cstring>

#include "core/simd_target.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/sample_anisotropic.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/filter-inl.h"
#include "texture/kernel-inl.h"
#include "texture/prefetch-inl.h"
#include "texture/probe-inl.h"
#include "texture/probe_line-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The lookups of a block as ForEachProbeBlock() hands them out. The column `random`, of which this filter has no other
/// use, holds the bits of the distance in steps from the middle where a Gaussian weight is exp(-2).
template <class F, bool kBorder>
struct Anisotropic {
  const Texture& texture;
  const Sampler& sampler;

  template <class D>
  HWY_INLINE void operator()(D d, const Points<D>& p, const Texels& out, size_t i) const {
    using V = hn::Vec<D>;
    const ProbeLine<D> line(d, sampler, p);
    const V count = line.count, reach = hn::BitCast(d, p.random);
    const LevelPair<D> levels = LevelsOf(d, texture, p.first_texel, line.lod);
    const float most = hn::GetLane(hn::MaxOfLanes(d, count));
    QuadPair<F, D> quads;
    if (most == 1.0f) {
      FetchQuads<F>(d, texture, sampler, levels, line.u, line.v, &quads);
      return StoreChannels<F, kBorder>(d, ProbeValue<D>{quads, levels, sampler}, out, i);
    }
    Sum<D> sum;
    V total = hn::Zero(d);
    for (float k = 0.0f; k < most; k += 1.0f) {
      // Lanes that are done stay at their last probe with weight 0.
      const V position = line.position(d, hn::Set(d, k));
      FetchQuads<F>(d, texture, sampler, levels, line.u_at(position), line.v_at(position), &quads);
      const auto active = hn::Lt(hn::Set(d, k), count);
      V share;
      if (sampler.probe_weights == SHD_PROBE_WEIGHTS_EQUAL) {
        share = hn::IfThenElseZero(active, hn::Set(d, 1.0f / (k + 1.0f)));
      } else {
        const V weight = hn::IfThenElseZero(active, ProbeGaussian(d, hn::Div(position, reach)));
        total = hn::Add(total, weight);
        share = hn::Div(weight, total);
      }
      if (k == 0.0f) {
        sum.set(d, out, ProbeValue<D>{quads, levels, sampler});
      } else {
        sum.add(d, out, ProbeValue<D>{quads, levels, sampler}, share);
      }
    }
    StoreChannels<F, kBorder>(d, sum, out, i);
  }

  template <class D>
  struct ProbeValue {
    const QuadPair<F, D>& quads;
    const LevelPair<D>& levels;
    const Sampler& sampler;

    template <size_t C>
    HWY_INLINE auto of() const {
      return BlendQuads<F, kBorder, C>(D(), quads, levels, sampler);
    }
  };

  /// Running averages of the wanted channels.
  template <class D>
  struct Sum {
    using B = Blend<F, kBorder>;
    using Value = typename B::template Value<D>;
    Value value[4] = {};

    template <size_t C>
    HWY_INLINE Value of() const {
      return value[C];
    }
    HWY_INLINE void set(D, const Texels& out, const ProbeValue<D>& probe) {
      if (B::wanted(out, 0)) value[0] = probe.template of<0>();
      if (B::wanted(out, 1)) value[1] = probe.template of<1>();
      if (B::wanted(out, 2)) value[2] = probe.template of<2>();
      if (B::wanted(out, 3)) value[3] = probe.template of<3>();
    }
    HWY_INLINE void add(D d, const Texels& out, const ProbeValue<D>& probe, hn::Vec<D> share) {
      if (B::wanted(out, 0)) value[0] = B::blend(d, value[0], probe.template of<0>(), share);
      if (B::wanted(out, 1)) value[1] = B::blend(d, value[1], probe.template of<1>(), share);
      if (B::wanted(out, 2)) value[2] = B::blend(d, value[2], probe.template of<2>(), share);
      if (B::wanted(out, 3)) value[3] = B::blend(d, value[3], probe.template of<3>(), share);
    }
  };
};

struct AnisotropicKernel {
  template <class F>
  static size_t run(const Texture& texture, const Sampler& sampler, const Lookups& in, const Texels& out) {
    const auto filter = [&](const Sampler& plain, const Lookups& line, const Texels& to) {
      const float* lod = line.dvdy;
      WithPrefetch(texture, plain, line, to, 2, lod, [&](const Lookups& part, const Texels& values) {
        ForEachPoint<Anisotropic, F>(texture, plain, part, values);
      });
    };
    if (sampler.probes_given) {
      filter(sampler, in, out);
      return 0;  // the profile has counted
    }
    return ForEachProbeBlock(texture, sampler, in, out,
                             [&](const Sampler& plain, const Lookups& block, const Texels& to) {
                               alignas(64) uint32_t reach[kBlock];
                               std::memcpy(reach, block.dudy, block.count * sizeof(float));
                               Lookups line = block;
                               line.random = reach;
                               filter(plain, line, to);
                             });
  }
};

FilterKernels AnisotropicKernels() {
  return KernelsOf<AnisotropicKernel, true>();
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::texture {
namespace {
HWY_EXPORT(AnisotropicKernels);
}  // namespace

FilterKernels anisotropic_kernels(const core::SimdTarget& simd) {
  return SHD_DISPATCH(AnisotropicKernels, simd)();
}

}  // namespace shd::texture
#endif
