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
#include "texture/filter/ellipsoid-inl.h"
#include "texture/filter/filters-inl.h"
#include "texture/filter/pick-inl.h"
#include "texture/filter/pick_ellipse-inl.h"
#include "texture/filter/random-inl.h"
#include "texture/filter/runner-inl.h"
#include "texture/filter/slices-inl.h"

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
    if (from.random) {
      hn::Store(hn::LoadU(du, from.random + i), du, out->random + to);
    } else if (texture.depth != 0) {
      hn::Store(BitsOfPlace(d, u, v, FiniteOrZero(d, hn::LoadU(d, from.w + i))), du, out->random + to);
    } else {
      hn::Store(BitsOfPoint(d, u, v), du, out->random + to);
    }
  });
  return HWY_NAMESPACE::FindShapes(texture, sampler, in, static_cast<Shape*>(out));
}

template <class D, class Shape>
HWY_INLINE Rng<D> RngOf(D d, const Sampler& sampler, const RandomBlock<Shape>& block, size_t i) {
  return Rng<D>(d, hn::Load(hn::RebindToUnsigned<D>(), block.random + i), sampler.seed);
}

/// Picks a tap of a linear or cubic filter at the reduced coordinate at[0].
template <bool kCubic, class D>
HWY_NOINLINE Pick<D> PickTap(D d, shd_wrap wrap, const float* at, const AxisSize<D>& size, hn::Vec<D> random) {
  const hn::Vec<D> reduced = hn::Load(d, at);
  if constexpr (kCubic) {
    return PickCubic(d, wrap, reduced, size, random);
  } else {
    return PickLinear(d, wrap, reduced, size, random);
  }
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
    const Pick<D> x = PickTap<kCubic>(d, sampler.wrap_u, block.u + i, base.across, rng.next(d));
    const Pick<D> y = PickTap<kCubic>(d, sampler.wrap_v, block.v + i, base.down, rng.next(d));
    emit_pick(d, base, x, y, sink);
  }
};

/// Emits the quad of a level at reduced coordinates, or one of its texels, picked by its weight.
template <class D, class Sink>
HWY_INLINE void EmitPoint(D d, const Sampler& sampler, const Level<D>& level, hn::Vec<D> u, hn::Vec<D> v, Rng<D>* rng,
                          Sink& sink) {
  if (sampler.stochastic == SHD_STOCHASTIC_QUAD) {
    sink.quad(d, kStart, level, u, v);
    sink.finish();
  } else {
    const Pick<D> x = PickLinear(d, sampler.wrap_u, u, level.across, rng->next(d));
    const Pick<D> y = PickLinear(d, sampler.wrap_v, v, level.down, rng->next(d));
    emit_pick(d, level, x, y, sink);
  }
}

/// Picks one level, and then one texel of its quad, or the whole quad.
struct PickTrilinear : OnMipLevels {
  using OnMipLevels::OnMipLevels;
  using Block = RandomBlock<LodBlock>;

  /// Never prefetches: for one texel or quad per lookup, prefetches cost more than they save.
  static bool is_scattered(const Texture&, const PointBlock&) { return false; }

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const Block& block, size_t i, Sink& sink) const {
    Rng<D> rng = RngOf(d, sampler, block, i);
    const auto first_texel = FirstTexel(d, texture, block, i);
    const auto number = PickLevel(d, texture, hn::Load(d, block.lod + i), rng.next(d));
    const Level<D> level = LevelAt(d, texture, first_texel, number);
    EmitPoint(d, sampler, level, hn::Load(d, block.u + i), hn::Load(d, block.v + i), &rng, sink);
  }
};

/// Returns the position of the first probe whose running sum of weights is above x times the sum of all weights, or
/// of the last probe if rounding leaves none.
template <class D, class V>
HWY_INLINE V PickGaussian(D d, const ProbeLine<D>& line, V x) {
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

/// Picks one probe and returns its position.
template <class D>
HWY_INLINE hn::Vec<D> PickProbe(D d, const Sampler& sampler, const ProbeLine<D>& line, hn::Vec<D> x) {
  if (sampler.probe_weights == SHD_PROBE_WEIGHTS_EQUAL) return line.position(d, RoundDown(x * line.probes));
  return PickGaussian(d, line, x);
}

/// Picks one probe, and then one texel of its trilinear lookup, or one of its two quads.
struct PickAnisotropic : OnMipLevels {
  using OnMipLevels::OnMipLevels;
  using Block = RandomBlock<ProbeBlock>;

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const Block& block, size_t i, Sink& sink) const {
    const ProbeLine<D> line(d, sampler, block, i);
    Rng<D> rng = RngOf(d, sampler, block, i);
    const auto position = PickProbe(d, sampler, line, rng.next(d));
    const auto first_texel = FirstTexel(d, texture, block, i);
    const auto number = PickLevel(d, texture, hn::Load(d, block.lod + i), rng.next(d));
    const Level<D> level = LevelAt(d, texture, first_texel, number);
    EmitPoint(d, sampler, level, line.u_at(position), line.v_at(position), &rng, sink);
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

/// Emits the chosen texel of a lookup in a 3D texture.
template <class D, class Sink>
HWY_INLINE void emit_pick(D d, const Slices<D>& slices, const Pick<D>& x, const Pick<D>& y, const Pick<D>& z,
                          Sink& sink) {
  emit_pick(d, SliceOf(d, slices, z.index), x, Pick<D>{y.index, hn::And(y.in, z.in)}, sink);
}

/// EmitPoint() of a 3D texture: the two quads of a level, or one of their texels.
template <class D, class Sink>
HWY_NOINLINE void EmitPlace(D d, const Texture& texture, const Sampler& sampler, hn::Vec<D> level, hn::Vec<D> u,
                            hn::Vec<D> v, hn::Vec<D> w, Rng<D>* rng, Sink& sink) {
  const Slices<D> slices = SlicesAt(d, texture, level);
  if (sampler.stochastic == SHD_STOCHASTIC_QUAD) {
    EmitLinear(d, sampler, slices, u, v, w, 0, sink);
    sink.finish();
  } else {
    const Pick<D> x = PickLinear(d, sampler.wrap_u, u, slices.level.across, rng->next(d));
    const Pick<D> y = PickLinear(d, sampler.wrap_v, v, slices.level.down, rng->next(d));
    const Pick<D> z = PickLinear(d, sampler.wrap_w, w, slices.deep, rng->next(d));
    emit_pick(d, slices, x, y, z, sink);
  }
}

template <bool kCubic>
struct PickOnBaseInSlices : OnBaseSlices<RandomBlock<PlaceBlock>> {
  using OnBaseSlices<RandomBlock<PlaceBlock>>::OnBaseSlices;

  static bool is_scattered(const Texture& texture, const PlaceBlock& block) {
    return OnSlices<PlaceBlock>::is_scattered(texture, block);
  }

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const RandomBlock<PlaceBlock>& block, size_t i, Sink& sink) const {
    const Slices<D>& slices = this->base;
    const Sampler& with = this->sampler;
    Rng<D> rng = RngOf(d, with, block, i);
    const Pick<D> x = PickTap<kCubic>(d, with.wrap_u, block.u + i, slices.level.across, rng.next(d));
    const Pick<D> y = PickTap<kCubic>(d, with.wrap_v, block.v + i, slices.level.down, rng.next(d));
    const Pick<D> z = PickTap<kCubic>(d, with.wrap_w, block.w + i, slices.deep, rng.next(d));
    emit_pick(d, slices, x, y, z, sink);
  }
};

struct PickTrilinearInSlices : OnSlices<RandomBlock<PlaceLodBlock>> {
  using OnSlices<RandomBlock<PlaceLodBlock>>::OnSlices;

  static bool is_scattered(const Texture&, const PlaceLodBlock&) { return false; }  // as PickTrilinear

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const RandomBlock<PlaceLodBlock>& block, size_t i, Sink& sink) const {
    Rng<D> rng = RngOf(d, sampler, block, i);
    const auto level = PickLevel(d, texture, hn::Load(d, block.lod + i), rng.next(d));
    EmitPlace(d, texture, sampler, level, hn::Load(d, block.u + i), hn::Load(d, block.v + i), hn::Load(d, block.w + i),
              &rng, sink);
  }
};

struct PickAnisotropicInSlices : OnSlices<RandomBlock<PlaceProbeBlock>> {
  using OnSlices<RandomBlock<PlaceProbeBlock>>::OnSlices;

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const RandomBlock<PlaceProbeBlock>& block, size_t i, Sink& sink) const {
    const ProbeLine<D> line(d, sampler, block, i);
    Rng<D> rng = RngOf(d, sampler, block, i);
    const auto position = PickProbe(d, sampler, line, rng.next(d));
    const auto level = PickLevel(d, texture, hn::Load(d, block.lod + i), rng.next(d));
    const auto w = ProbeLine<D>::at(sampler.wrap_w, hn::Load(d, block.w + i), position,
                                    ProbeLine<D>::Distance(d, sampler.wrap_w, hn::Load(d, block.step_w + i)));
    EmitPlace(d, texture, sampler, level, line.u_at(position), line.v_at(position), w, &rng, sink);
  }
};

/// Picks the first texel of an ellipsoid whose running sum of weights is above random times the sum of all weights, as
/// PickInEllipse() does. A second walk over all texels finds it.
struct PickEllipsoid : OnSlices<RandomBlock<EllipsoidBlock>> {
  using OnSlices::OnSlices;

  static bool is_scattered(const Texture& texture, const EllipsoidBlock& block) {
    return is_scattered_in_slices(texture, block, block.w, block.level);
  }

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const RandomBlock<EllipsoidBlock>& block, size_t i, Sink& sink) const {
    const Ellipse<D> e(d, texture, sampler, block, i);
    const Slices<D> slices = SlicesAt(d, texture, hn::Load(d, block.level + i));
    Rng<D> rng = RngOf(d, sampler, block, i);
    const auto linear = hn::Lt(rng.next(d), e.bilinear);
    const auto first = rng.next(d);
    Pick<D> x = PickLinear(d, sampler.wrap_u, e.u, slices.level.across, first);
    Pick<D> y = PickLinear(d, sampler.wrap_v, e.v, slices.level.down, rng.next(d));
    Pick<D> z = PickLinear(d, sampler.wrap_w, hn::Load(d, block.w + i), slices.deep, rng.next(d));
    if (!hn::AllTrue(d, linear)) {
      const EllipsoidDepth<D> depth(d, sampler, slices, e, block, i);
      hn::Vec<D> column, row, slice;
      pick_inside(d, e, depth, first, &column, &row, &slice);
      replace(d, linear, sampler.wrap_u, column, slices.level.across, &x);
      replace(d, linear, sampler.wrap_v, row, slices.level.down, &y);
      replace(d, linear, sampler.wrap_w, slice, slices.deep, &z);
    }
    emit_pick(d, slices, x, y, z, sink);
  }

 private:
  /// Calls body(lines, k, line, texel, weight) for the texels of all slices k.
  template <class D, class Body>
  static HWY_INLINE void visit(D d, const Ellipse<D>& e, const EllipsoidDepth<D>& depth, const Body& body) {
    const float max_slice = depth.max_slice(d);
    for (float k = 0.0f; k <= max_slice; k += 1.0f) {
      const EllipsoidSection<D> section(d, depth, hn::Set(d, k));
      const auto least = hn::IfThenElse(section.empty, hn::Set(d, 1.0f), section.height);
      const EllipseLines<D> lines(d, section.x, section.y, e.shear, e.height2, e.width2, least);
      const float line_count = static_cast<float>(lines.lines(d)), texels = lines.texels(d);
      for (float n = 0.0f; n < line_count; n += 1.0f) {
        const auto line = lines.line(d, hn::Set(d, n));
        for (float t = 0.0f; t < texels; t += 1.0f) body(lines, k, n, t, lines.weight(d, line, t));
      }
    }
  }

  template <class D, class V>
  static HWY_INLINE void pick_inside(D d, const Ellipse<D>& e, const EllipsoidDepth<D>& depth, V random, V* column,
                                     V* row, V* slice) {
    V total = hn::Zero(d), sum = hn::Zero(d);
    visit(d, e, depth, [&](const auto&, float, float, float, V weight) SHD_INLINE_LAMBDA { total = total + weight; });
    const V wanted = random * total;
    *column = e.x.x;
    *row = e.y.x;
    *slice = depth.first;
    visit(d, e, depth, [&](const auto& lines, float k, float n, float t, V weight) SHD_INLINE_LAMBDA {
      const V before = sum;
      sum = sum + weight;
      const auto hit = hn::And(hn::Le(before, wanted), hn::Lt(wanted, sum));
      if (HWY_LIKELY(hn::AllFalse(d, hit))) return;
      V x, y;
      lines.locate(d, hn::Set(d, n), hn::Set(d, t), &x, &y);
      *column = hn::IfThenElse(hit, x, *column);
      *row = hn::IfThenElse(hit, y, *row);
      *slice = hn::IfThenElse(hit, depth.first + hn::Set(d, k), *slice);
    });
  }

  /// Replaces a pick by the texel `at`, except in the lanes `keeps`.
  template <class D>
  static HWY_INLINE void replace(D d, MaskOf<D> keeps, shd_wrap wrap, hn::Vec<D> at, const AxisSize<D>& size,
                                 Pick<D>* pick) {
    MaskOf<D> in;
    const auto index = Walk<D>(d, wrap, at, size).index(d, &in);
    pick->index = hn::IfThenElse(hn::RebindMask(hn::RebindToSigned<D>(), keeps), pick->index, index);
    pick->in = hn::Or(hn::And(keeps, pick->in), hn::AndNot(keeps, in));
  }
};

}  // namespace

size_t RunStochastic(const FilterCall& call) {
  switch (call.sampler.stochastic_filter) {
    case SHD_FILTER_BILINEAR: return Run<PickOnBase<false>>(call);
    case SHD_FILTER_BICUBIC: return Run<PickOnBase<true>>(call);
    case SHD_FILTER_ANISOTROPIC: return Run<PickAnisotropic>(call);
    case SHD_FILTER_EWA: return Run<PickEllipse>(call);
    default: return Run<PickTrilinear>(call);
  }
}

size_t RunStochasticInSlices(const FilterCall& call) {
  switch (call.sampler.stochastic_filter) {
    case SHD_FILTER_BILINEAR: return Run<PickOnBaseInSlices<false>>(call);
    case SHD_FILTER_BICUBIC: return Run<PickOnBaseInSlices<true>>(call);
    case SHD_FILTER_ANISOTROPIC: return Run<PickAnisotropicInSlices>(call);
    case SHD_FILTER_EWA: return Run<PickEllipsoid>(call);
    default: return Run<PickTrilinearInSlices>(call);
  }
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
