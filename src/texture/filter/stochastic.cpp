// SPDX-License-Identifier: MIT
// Stochastic filtering: one texel or quad per lookup, picked by the weights of a filter. The result is an unbiased
// one-sample estimate of this filter (Pharr, Wronski, Salvi and Fajardo, "Filtering After Shading With Stochastic
// Texture Filtering", 2024).
#include "texture/stream.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/filter/stochastic.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "simd/round-inl.h"
#include "texture/filter/anisotropic-inl.h"
#include "texture/filter/bases-inl.h"
#include "texture/filter/filters-inl.h"
#include "texture/filter/pick-inl.h"
#include "texture/filter/pick_ellipse-inl.h"
#include "texture/filter/random-inl.h"
#include "texture/filter/runner-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::RoundDown;
namespace {

/// A block of shapes, with random bits for each lookup.
template <class Shape>
struct RandomBlock : Shape {
  alignas(64) uint32_t random[kBlock];
};

/// Fills a block with shapes and with the random bits of lookups. Without a column of random bits they are a hash of
/// the coordinates.
template <class Shape>
size_t FindShapes(const Texture& texture, const Sampler& sampler, const Lookups& in, RandomBlock<Shape>* out) {
  ForEachVector(in, [&](auto d, const Lookups& from, size_t i, size_t to) {
    const hn::RebindToUnsigned<decltype(d)> du;
    const auto u = FiniteOrZero(d, hn::LoadU(d, from.u + i)), v = FiniteOrZero(d, hn::LoadU(d, from.v + i));
    hn::Store(from.random ? hn::LoadU(du, from.random + i) : BitsOfPoint(d, u, v), du, out->random + to);
  });
  return HWY_NAMESPACE::FindShapes(texture, sampler, in, static_cast<Shape*>(out));
}

template <class D, class Shape>
HWY_INLINE Rng<D> RngOf(D d, const Sampler& sampler, const RandomBlock<Shape>& block, size_t i) {
  return Rng<D>(d, hn::Load(hn::RebindToUnsigned<D>(), block.random + i), sampler.seed);
}

/// Picks a texel of the base level by the weights of a bilinear or bicubic filter.
template <bool kCubic>
struct PickOnBase : OnBaseLevel {
  using OnBaseLevel::OnBaseLevel;
  using Block = RandomBlock<PointBlock>;

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const Block& block, size_t i, Sink& sink) const {
    const Level<D> base = level(d, block, i);
    Rng<D> rng = RngOf(d, sampler, block, i);
    const Pick<D> x = pick(d, sampler.wrap_u, block.u + i, base.across, rng.next(d));
    const Pick<D> y = pick(d, sampler.wrap_v, block.v + i, base.down, rng.next(d));
    emit_pick(d, base, x, y, sink);
  }

 private:
  template <class D>
  static HWY_INLINE Pick<D> pick(D d, shd_wrap wrap, const float* at, const AxisSize<D>& size, hn::Vec<D> random) {
    const hn::Vec<D> reduced = hn::Load(d, at);
    if constexpr (kCubic) {
      return PickCubic(d, wrap, reduced, size, random);
    } else {
      return PickLinear(d, wrap, reduced, size, random);
    }
  }
};

/// Emits the quad of a level at reduced coordinates, or one of its texels, picked by its weight.
template <bool kQuad, class D, class Sink>
HWY_INLINE void EmitPoint(D d, const Sampler& sampler, const Level<D>& level, hn::Vec<D> u, hn::Vec<D> v, Rng<D>* rng,
                          Sink& sink) {
  if constexpr (kQuad) {
    sink.quad(d, kStart, level, u, v);
    sink.finish();
  } else {
    const Pick<D> x = PickLinear(d, sampler.wrap_u, u, level.across, rng->next(d));
    const Pick<D> y = PickLinear(d, sampler.wrap_v, v, level.down, rng->next(d));
    emit_pick(d, level, x, y, sink);
  }
}

/// Picks one level, and then one texel of its quad, or the whole quad.
template <bool kQuad>
struct PickTrilinear : OnMipLevels {
  using OnMipLevels::OnMipLevels;
  using Block = RandomBlock<LodBlock>;

  /// Never prefetches: for one texel or quad per lookup, prefetches cost more than they save.
  static bool is_scattered(const Texture&, const PointBlock&) { return false; }

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const Block& block, size_t i, Sink& sink) const {
    Rng<D> rng = RngOf(d, sampler, block, i);
    const auto first_texel = FirstTexel(d, texture, block, i);
    const Level<D> level = PickLevel(d, texture, first_texel, hn::Load(d, block.lod + i), rng.next(d));
    EmitPoint<kQuad>(d, sampler, level, hn::Load(d, block.u + i), hn::Load(d, block.v + i), &rng, sink);
  }
};

/// Picks one probe, and then one texel of its trilinear lookup, or one of its two quads.
template <bool kQuad>
struct PickAnisotropic : OnMipLevels {
  using OnMipLevels::OnMipLevels;
  using Block = RandomBlock<ProbeBlock>;

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const Block& block, size_t i, Sink& sink) const {
    const ProbeLine<D> line(d, sampler, block, i);
    Rng<D> rng = RngOf(d, sampler, block, i);
    const auto x = rng.next(d);
    const auto position = sampler.probe_weights == SHD_PROBE_WEIGHTS_EQUAL
                              ? line.position(d, RoundDown(x * line.probes))
                              : PickGaussian(d, line, x);
    const auto first_texel = FirstTexel(d, texture, block, i);
    const Level<D> level = PickLevel(d, texture, first_texel, hn::Load(d, block.lod + i), rng.next(d));
    EmitPoint<kQuad>(d, sampler, level, line.u_at(position), line.v_at(position), &rng, sink);
  }

  /// Returns the position of the first probe whose running sum of weights is above x times the sum of all weights, or
  /// of the last probe if rounding leaves none.
  template <class D, class V>
  static HWY_INLINE V PickGaussian(D d, const ProbeLine<D>& line, V x) {
    const float max_probes = hn::GetLane(hn::MaxOfLanes(d, line.probes));
    const auto weight = [&](float k) {
      const V position = line.position(d, hn::Set(d, k));
      return hn::IfThenElseZero(hn::Lt(hn::Set(d, k), line.probes), ProbeGaussian(d, position / line.probes));
    };
    V total = hn::Zero(d), sum = hn::Zero(d), probe = hn::Zero(d);
    for (float k = 0.0f; k < max_probes; k += 1.0f) total = total + weight(k);
    const V wanted = x * total;
    for (float k = 0.0f; k < max_probes; k += 1.0f) {
      sum = sum + weight(k);
      probe = probe + hn::IfThenElseZero(hn::Ge(wanted, sum), hn::Set(d, 1.0f));
    }
    return line.position(d, probe);
  }
};

struct PickEllipse {
  using Block = RandomBlock<EllipseBlock>;

  const Texture& texture;
  const Sampler& sampler;

  PickEllipse(const Texture& of_texture, const Sampler& of_sampler) : texture(of_texture), sampler(of_sampler) {}

  static bool is_scattered(const Texture& texture, const Block& block) {
    return texture::is_scattered(texture, block, block.level);
  }

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const Block& block, size_t i, Sink& sink) const {
    const Ellipse<D> ellipse(d, texture, sampler, block, i);
    Rng<D> rng = RngOf(d, sampler, block, i);
    Pick<D> x, y;
    PickEwa(d, sampler, ellipse, &rng, &x, &y);
    emit_pick(d, ellipse.level, x, y, sink);
  }
};

}  // namespace

size_t RunStochastic(const FilterCall& call) {
  if (call.sampler.stochastic == SHD_STOCHASTIC_QUAD) {
    return call.sampler.stochastic_filter == SHD_FILTER_ANISOTROPIC ? Run<PickAnisotropic<true>>(call)
                                                                    : Run<PickTrilinear<true>>(call);
  }
  switch (call.sampler.stochastic_filter) {
    case SHD_FILTER_BILINEAR: return Run<PickOnBase<false>>(call);
    case SHD_FILTER_BICUBIC: return Run<PickOnBase<true>>(call);
    case SHD_FILTER_ANISOTROPIC: return Run<PickAnisotropic<false>>(call);
    case SHD_FILTER_EWA: return Run<PickEllipse>(call);
    default: return Run<PickTrilinear<false>>(call);
  }
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
