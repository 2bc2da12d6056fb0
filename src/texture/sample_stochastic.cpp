// SPDX-License-Identifier: MIT
// One texel per lookup, drawn with the weights of a filter (Pharr, Wronski, Salvi and Fajardo, "Filtering After
// Shading With Stochastic Texture Filtering", 2024): the mean over many draws is what that filter gives. A number x,
// uniform in [0, 1), is below a weight w with probability w, and never below 0.
#include "texture/sample.h"

#include "core/simd_target.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/sample_stochastic.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/cubic-inl.h"
#include "texture/filter-inl.h"
#include "texture/kernel-inl.h"
#include "texture/lod_block-inl.h"
#include "texture/probe_line-inl.h"
#include "texture/random-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// One tap along one axis.
template <class D>
struct Drawn {
  Ints<D> index;
  MaskOf<D> in;  // false = border colour
};

/// One of the two taps of linear filtering at a reduced coordinate.
template <class D>
HWY_INLINE Drawn<D> DrawLinear(D d, shd_wrap wrap, hn::Vec<D> reduced, const AxisSize<D>& size, hn::Vec<D> x) {
  const hn::RebindToSigned<D> di;
  const LinearTaps<D> taps = WrapLinear(d, wrap, reduced, size);
  const auto second = hn::Lt(x, taps.s);
  return {hn::IfThenElse(hn::RebindMask(di, second), taps.i1, taps.i0),
          hn::Or(hn::And(second, taps.in1), hn::AndNot(second, taps.in0))};
}

/// One of the four taps of the cubic B-spline, by the running sums of the weights: six times those are (1 - s)^3,
/// 3 s^3 - 6 s^2 + 4, 3 (1 - s)^3 - 6 (1 - s)^2 + 4 and s^3. At s = 0 the first three sum to 6 exactly, which 6 x never
/// reaches.
template <class D>
HWY_INLINE Drawn<D> DrawCubic(D d, shd_wrap wrap, hn::Vec<D> u, const AxisSize<D>& size, hn::Vec<D> x) {
  using V = hn::Vec<D>;
  const V one = hn::Set(d, 1.0f), three = hn::Set(d, 3.0f), four = hn::Set(d, 4.0f), six = hn::Set(d, 6.0f);
  const CubicPoint<D> at = LocateCubic(d, wrap, ReduceCoordinate(d, wrap, u), size);
  const V r = hn::Sub(one, at.s);
  const auto inner = [&](V t) { return hn::Add(hn::Mul(hn::Sub(hn::Mul(three, t), six), hn::Mul(t, t)), four); };
  const V first = hn::Mul(r, hn::Mul(r, r));
  const V second = hn::Add(first, inner(at.s));
  const V third = hn::Add(second, inner(r));
  const V scaled = hn::Mul(x, six);
  V tap = hn::Sub(at.second, one);
  for (const V sum : {first, second, third}) tap = hn::Add(tap, hn::IfThenElseZero(hn::Ge(scaled, sum), one));
  Drawn<D> drawn;
  drawn.index = WrapCubicTap(d, wrap, tap, size, &drawn.in);
  return drawn;
}

/// Of the levels floor(lod) and the next, one by the fraction.
template <class D>
HWY_INLINE Level<D> DrawLevel(D d, const Texture& texture, Ints<D> first_texel, hn::Vec<D> lod, hn::Vec<D> x) {
  const auto floor = hn::Floor(lod);
  const auto next = hn::IfThenElseZero(hn::Lt(x, hn::Sub(lod, floor)), hn::Set(d, 1.0f));
  const auto last = hn::Set(d, static_cast<float>(texture.level_count - 1));
  return LevelAt(d, texture, first_texel, hn::Min(hn::Add(floor, next), last));
}

template <class F, bool kBorder, class D>
HWY_INLINE void StoreDrawn(D d, const Texture& texture, const Sampler& sampler, const Level<D>& level,
                           const Drawn<D>& x, const Drawn<D>& y, const Texels& out, size_t i) {
  const auto texel = F::fetch(d, texture, hn::Add(RowIndex(d, level, y.index), x.index));
  StoreChannels<F, kBorder>(d, TapValue<F, kBorder, D>{texel, hn::And(x.in, y.in), sampler}, out, i);
}

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
      default:
        return ForEachLodBlock(texture, sampler, in, out, [&](const Lookups& block, const Texels& to) {
          ForEachPoint<DrawnTrilinear, F>(texture, sampler, block, to);
        });
    }
  }
};

size_t StochasticBatch(const Texture& texture, const Sampler& sampler, const Lookups& in, const Texels& out) {
  return RunValues<StochasticKernel>(texture, sampler, in, out);
}
#if HWY_TARGET == HWY_STATIC_TARGET
void RecordStochastic(const Texture& texture, const Sampler& sampler, const Lookups& in, const Texels& out) {
  StochasticKernel::run<Recorded>(texture, sampler, in, out);
}
#endif

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::texture {
namespace {
HWY_EXPORT(StochasticBatch);
}  // namespace

size_t sample_stochastic(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd,
                         const Lookups& lookups, const Texels& out) {
  return SHD_DISPATCH(StochasticBatch, simd)(texture, sampler, lookups, out);
}

void record_stochastic(const Texture& texture, const Sampler& sampler, const Lookups& lookups) {
  float unused[1];
  HWY_STATIC_DISPATCH(RecordStochastic)(texture, sampler, lookups, {{unused}, {}, {}});
}

}  // namespace shd::texture
#endif
