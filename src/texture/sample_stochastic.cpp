// SPDX-License-Identifier: MIT
// One texel per lookup, drawn with the weights of a filter (Pharr, Wronski, Salvi and Fajardo, "Filtering After
// Shading With Stochastic Texture Filtering", 2024): the mean over many draws is what that filter gives.
#include "texture/sample.h"

#include "core/simd_target.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/sample_stochastic.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/draw-inl.h"
#include "texture/draw_ellipse-inl.h"
#include "texture/kernel-inl.h"
#include "texture/lod_block-inl.h"
#include "texture/probe_line-inl.h"
#include "texture/random-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class F, bool kBorder>
struct DrawnBilinear {
  const Texture& texture;
  const Sampler& sampler;

  template <class D>
  HWY_INLINE void operator()(D d, const Points<D>& p, const Texels& out, size_t i) const {
    const Level<D> level = SameLevel(d, texture, p.first_texel, 0);
    Draws<D> draws(d, p.random, sampler.seed);
    const Drawn<D> x =
        DrawLinear(d, sampler.wrap_u, ReduceCoordinate(d, sampler.wrap_u, p.u), level.across, draws.next(d));
    const Drawn<D> y =
        DrawLinear(d, sampler.wrap_v, ReduceCoordinate(d, sampler.wrap_v, p.v), level.down, draws.next(d));
    StoreDrawn<F, kBorder>(d, texture, sampler, level, x, y, out, i);
  }
};

template <class F, bool kBorder>
struct DrawnBicubic {
  const Texture& texture;
  const Sampler& sampler;

  template <class D>
  HWY_INLINE void operator()(D d, const Points<D>& p, const Texels& out, size_t i) const {
    const Level<D> level = SameLevel(d, texture, p.first_texel, 0);
    Draws<D> draws(d, p.random, sampler.seed);
    const Drawn<D> x = DrawCubic(d, sampler.wrap_u, p.u, level.across, draws.next(d));
    const Drawn<D> y = DrawCubic(d, sampler.wrap_v, p.v, level.down, draws.next(d));
    StoreDrawn<F, kBorder>(d, texture, sampler, level, x, y, out, i);
  }
};

template <class F, bool kBorder>
struct DrawnTrilinear {
  const Texture& texture;
  const Sampler& sampler;

  template <class D>
  HWY_INLINE void operator()(D d, const Points<D>& p, const Texels& out, size_t i) const {
    Draws<D> draws(d, p.random, sampler.seed);
    const Level<D> level = DrawLevel(d, texture, p.first_texel, p.lod, draws.next(d));
    const Drawn<D> x =
        DrawLinear(d, sampler.wrap_u, ReduceCoordinate(d, sampler.wrap_u, p.u), level.across, draws.next(d));
    const Drawn<D> y =
        DrawLinear(d, sampler.wrap_v, ReduceCoordinate(d, sampler.wrap_v, p.v), level.down, draws.next(d));
    StoreDrawn<F, kBorder>(d, texture, sampler, level, x, y, out, i);
  }
};

/// One probe, then one texel of its trilinear lookup.
template <class F, bool kBorder>
struct DrawnAnisotropic {
  const Texture& texture;
  const Sampler& sampler;

  template <class D>
  HWY_INLINE void operator()(D d, const Points<D>& p, const Texels& out, size_t i) const {
    using V = hn::Vec<D>;
    const ProbeLine<D> line(d, sampler, p);
    Draws<D> draws(d, p.random, sampler.seed);
    const V probe = draws.next(d);
    const V position = sampler.probe_weights == SHD_PROBE_WEIGHTS_EQUAL
                           ? line.position(d, hn::Floor(hn::Mul(probe, line.count)))
                           : DrawGaussian(d, line, probe);
    const Level<D> level = DrawLevel(d, texture, p.first_texel, line.lod, draws.next(d));
    const Drawn<D> x = DrawLinear(d, sampler.wrap_u, line.u_at(position), level.across, draws.next(d));
    const Drawn<D> y = DrawLinear(d, sampler.wrap_v, line.v_at(position), level.down, draws.next(d));
    StoreDrawn<F, kBorder>(d, texture, sampler, level, x, y, out, i);
  }

  /// Position of the first probe with the running sum of weights above x times their sum; the last one at least.
  template <class D, class V>
  static HWY_INLINE V DrawGaussian(D d, const ProbeLine<D>& line, V x) {
    const float most = hn::GetLane(hn::MaxOfLanes(d, line.count));
    const auto weight = [&](float k) {
      const V position = line.position(d, hn::Set(d, k));
      return hn::IfThenElseZero(hn::Lt(hn::Set(d, k), line.count), ProbeGaussian(d, hn::Div(position, line.count)));
    };
    V total = hn::Zero(d), sum = hn::Zero(d), probe = hn::Zero(d);
    for (float k = 0.0f; k < most; k += 1.0f) total = hn::Add(total, weight(k));
    const V wanted = hn::Mul(x, total);
    for (float k = 0.0f; k < most; k += 1.0f) {
      sum = hn::Add(sum, weight(k));
      probe = hn::Add(probe, hn::IfThenElseZero(hn::Ge(wanted, sum), hn::Set(d, 1.0f)));
    }
    return line.position(d, probe);
  }
};

/// One texel of the ellipse, or one of the bilinear lookup that it gives way to.
template <class F, bool kBorder>
struct DrawnEwa {
  const Texture& texture;
  const Sampler& sampler;

  template <class D>
  HWY_INLINE void operator()(D d, const Points<D>& p, const Texels& out, size_t i) const {
    const EllipsePoint<D> e(d, texture, sampler, p);
    Draws<D> draws(d, p.random, sampler.seed);
    Drawn<D> x, y;
    DrawEwa(d, sampler, e, &draws, &x, &y);
    StoreDrawn<F, kBorder>(d, texture, sampler, e.level, x, y, out, i);
  }
};

struct StochasticKernel {
  template <class F>
  static size_t run(const Texture& texture, const Sampler& sampler, const Lookups& in, const Texels& out) {
    switch (sampler.expectation) {
      case SHD_FILTER_BILINEAR: return ForEachPoint<DrawnBilinear, F>(texture, sampler, in, out);
      case SHD_FILTER_BICUBIC: return ForEachPoint<DrawnBicubic, F>(texture, sampler, in, out);
      case SHD_FILTER_ANISOTROPIC:
        return ForEachProbeBlock(texture, sampler, in, out,
                                 [&](const Sampler& plain, const Lookups& block, const Texels& to) {
                                   ForEachPoint<DrawnAnisotropic, F>(texture, plain, block, to);
                                 });
      case SHD_FILTER_EWA:
        return ForEachEllipseBlock(texture, sampler, in, out,
                                   [&](const Sampler& plain, const Lookups& block, const Texels& to) {
                                     ForEachPoint<DrawnEwa, F>(texture, plain, block, to);
                                   });
      default:
        return ForEachLodBlock(texture, sampler, in, out, [&](const Lookups& block, const Texels& to) {
          ForEachPoint<DrawnTrilinear, F>(texture, sampler, block, to);
        });
    }
  }
};

FilterKernels StochasticKernels() {
  return KernelsOf<StochasticKernel, false>();
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::texture {
namespace {
HWY_EXPORT(StochasticKernels);
}  // namespace

FilterKernels stochastic_kernels(const core::SimdTarget& simd) {
  return SHD_DISPATCH(StochasticKernels, simd)();
}

}  // namespace shd::texture
#endif
