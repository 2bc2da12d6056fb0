// SPDX-License-Identifier: MIT
// Taps and blends that every filter shares.

#if defined(SHD_TEXTURE_FILTER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_FILTER_INL_H_
#undef SHD_TEXTURE_FILTER_INL_H_
#else
#define SHD_TEXTURE_FILTER_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/format-inl.h"
#include "texture/storage.h"
#include "texture/wrap-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// One level per lane, or the same for all.
template <class D>
struct Level {
  AxisSize<D> across, down;
  Ints<D> offset;
};

template <class D>
SHD_KERNEL_PART Level<D> SameLevel(D d, const Texture& texture, Ints<D> first_texel, uint32_t level) {
  const hn::RebindToSigned<D> di;
  const auto width = static_cast<int32_t>(level_size(texture.width, level));
  const auto height = static_cast<int32_t>(level_size(texture.height, level));
  return {{hn::Set(d, static_cast<float>(width)), hn::Set(di, width)},
          {hn::Set(d, static_cast<float>(height)), hn::Set(di, height)},
          hn::Add(first_texel, hn::Set(di, static_cast<int32_t>(texture.offset[level])))};
}

/// max(1, floor(base * scale)), scale a power of two: exact, as sizes are below 2^24.
template <class D, class V>
HWY_INLINE AxisSize<D> ScaledSize(D d, uint32_t base, V scale) {
  const hn::RebindToSigned<D> di;
  const V size = hn::Max(hn::Floor(hn::Mul(hn::Set(d, static_cast<float>(base)), scale)), hn::Set(d, 1.0f));
  return {size, hn::ConvertTo(di, size)};
}

template <class D>
SHD_KERNEL_PART Level<D> LevelPerLane(D d, const Texture& texture, Ints<D> first_texel, Ints<D> level) {
  const hn::RebindToSigned<D> di;
  const auto scale = hn::BitCast(d, hn::ShiftLeft<23>(hn::Sub(hn::Set(di, 127), level)));
  return {ScaledSize(d, texture.width, scale), ScaledSize(d, texture.height, scale),
          hn::Add(first_texel, hn::GatherIndex(di, reinterpret_cast<const int32_t*>(texture.offset), level))};
}

/// A level per lane, given as a whole float: the same bits by a shorter way where all lanes agree.
template <class D>
HWY_INLINE Level<D> LevelAt(D d, const Texture& texture, Ints<D> first_texel, hn::Vec<D> level) {
  const hn::RebindToSigned<D> di;
  const float first = hn::GetLane(level);
  if (hn::AllTrue(d, hn::Eq(level, hn::Set(d, first)))) {
    return SameLevel(d, texture, first_texel, static_cast<uint32_t>(first));
  }
  return LevelPerLane(d, texture, first_texel, hn::ConvertTo(di, level));
}

/// Index of the first texel of row y from the first of the texture: all the addressing there is, as levels are
/// packed rows.
template <class D>
HWY_INLINE Ints<D> RowIndex(D, const Level<D>& level, Ints<D> y) {
  return hn::Add(hn::Mul(y, level.across.whole), level.offset);
}

/// a + s (b - a) for values whose difference cannot overflow: a itself where a == b or s == 0.
template <class D, class V>
HWY_INLINE V Lerp(D, V a, V b, V s) {
  return hn::Add(a, hn::Mul(s, hn::Sub(b, a)));
}

/// Lerp for any floats: a value of weight 0 never counts, infinities and NaN of other weights do, and finite values
/// stay finite, as (1 - s) a + s b takes over where b - a overflows.
template <class D, class V>
HWY_INLINE V Mix(D d, V a, V b, V s) {
  const V difference = hn::Sub(b, a);
  const auto finite = hn::Eq(hn::Sub(difference, difference), hn::Zero(d));
  V mixed = hn::Add(a, hn::Mul(s, difference));
  if (HWY_UNLIKELY(!hn::AllTrue(d, finite))) {
    const V weighted = hn::Add(hn::Mul(hn::Sub(hn::Set(d, 1.0f), s), a), hn::Mul(s, b));
    mixed = hn::IfThenElse(finite, mixed, weighted);
  }
  return hn::IfThenElse(hn::Eq(s, hn::Zero(d)), a, mixed);
}

/// How values of format F are read, blended and stored. With a border, values leave the lerp domain of the format
/// before they meet the border colour, which may be any finite float. Every filter is a tree of blends, so that equal
/// texels give exactly their value. Kernels name the kind of every blend, for specialisations that follow the tree:
/// by a weight that does not depend on the point, or by the fraction along u or v with its rate.
template <class F, bool kBorder>
struct Blend {
  template <class D>
  using Value = hn::Vec<D>;

  template <size_t C, class D>
  static HWY_INLINE Value<D> tap(D d, const typename F::template Texel<D>& texel, MaskOf<D> in,
                                 const Sampler& sampler) {
    const hn::Vec<D> value = F::template decode<C>(d, texel);
    if constexpr (!kBorder) return value;
    return hn::IfThenElse(in, F::template finish<C>(d, value), hn::Set(d, sampler.border[C]));
  }

  /// a + s (b - a); s in [0, 1] but for the lobes of cubic kernels.
  template <class D>
  static HWY_INLINE Value<D> blend(D d, Value<D> a, Value<D> b, hn::Vec<D> s) {
    if constexpr (kBorder || F::kFloat) return Mix(d, a, b, s);
    return Lerp(d, a, b, s);
  }
  /// The same with ds/du = rate.
  template <class D>
  static HWY_INLINE Value<D> blend_u(D d, Value<D> a, Value<D> b, hn::Vec<D> s, hn::Vec<D>) {
    return blend(d, a, b, s);
  }
  /// The same with ds/dv = rate.
  template <class D>
  static HWY_INLINE Value<D> blend_v(D d, Value<D> a, Value<D> b, hn::Vec<D> s, hn::Vec<D>) {
    return blend(d, a, b, s);
  }

  /// b in the lanes of `first`, else a blend with ds/du = rate_u and ds/dv = rate_v.
  template <class D>
  static HWY_INLINE Value<D> join(D d, MaskOf<D> first, Value<D> a, Value<D> b, hn::Vec<D> s, hn::Vec<D>, hn::Vec<D>) {
    return hn::IfThenElse(first, b, blend(d, a, b, s));
  }

  /// The result; one NaN for all, whatever the target makes of several.
  template <size_t C, class D>
  static HWY_INLINE hn::Vec<D> finish(D d, Value<D> value) {
    if constexpr (F::kFloat) return hn::IfThenElse(hn::Eq(value, value), value, hn::Set(d, __builtin_nanf("")));
    if constexpr (kBorder) return value;
    return F::template finish<C>(d, value);
  }

  /// Finishes and writes to element i.
  template <size_t C, class D>
  static HWY_INLINE void store(D d, Value<D> value, const Texels& out, size_t i) {
    hn::StoreU(finish<C>(d, value), d, out.channel[C] + i);
  }
  static HWY_INLINE bool wanted(const Texels& out, size_t channel) { return out.channel[channel] != nullptr; }
};

/// value.of<C>() of every wanted channel C, to element i of its column.
template <class F, bool kBorder, class D, class ValueOf>
HWY_INLINE void StoreChannels(D d, const ValueOf& value, const Texels& out, size_t i) {
  using B = Blend<F, kBorder>;
  if (B::wanted(out, 0)) B::template store<0>(d, value.template of<0>(), out, i);
  if (B::wanted(out, 1)) B::template store<1>(d, value.template of<1>(), out, i);
  if (B::wanted(out, 2)) B::template store<2>(d, value.template of<2>(), out, i);
  if (B::wanted(out, 3)) B::template store<3>(d, value.template of<3>(), out, i);
}

/// One texel of a level.
template <class F, bool kBorder, class D>
struct TapValue {
  const typename F::template Texel<D>& texel;
  MaskOf<D> in;
  const Sampler& sampler;

  template <size_t C>
  HWY_INLINE auto of() const {
    return Blend<F, kBorder>::template tap<C>(D(), texel, in, sampler);
  }
};

/// The texel of a level that contains (u, v), to element i of the wanted columns.
template <class F, bool kBorder, class D>
HWY_INLINE void StoreNearest(D d, const Texture& texture, const Sampler& sampler, const Level<D>& level, hn::Vec<D> u,
                             hn::Vec<D> v, const Texels& out, size_t i) {
  MaskOf<D> in_x, in_y;
  const auto x = WrapNearest(d, sampler.wrap_u, ReduceCoordinate(d, sampler.wrap_u, u), level.across, &in_x);
  const auto y = WrapNearest(d, sampler.wrap_v, ReduceCoordinate(d, sampler.wrap_v, v), level.down, &in_y);
  const auto texel = F::fetch(d, texture, hn::Add(RowIndex(d, level, y), x));
  StoreChannels<F, kBorder>(d, TapValue<F, kBorder, D>{texel, hn::And(in_x, in_y), sampler}, out, i);
}

/// The four texels around a point of a level.
template <class F, class D>
struct Quad {
  using Texel = typename F::template Texel<D>;
  hn::Vec<D> s, t, rate_s, rate_t;
  Texel t00, t10, t01, t11;  // column, row
  MaskOf<D> in00, in10, in01, in11;
};

/// The texels at taps x and y of a level.
template <class F, class D>
SHD_KERNEL_PART Quad<F, D> FetchTaps(D d, const Texture& texture, const Level<D>& level, const LinearTaps<D>& x,
                                     const LinearTaps<D>& y) {
  const auto top = RowIndex(d, level, y.i0), bottom = RowIndex(d, level, y.i1);
  Quad<F, D> quad;
  quad.s = x.s;
  quad.t = y.s;
  quad.rate_s = x.rate;
  quad.rate_t = y.rate;
  quad.in00 = hn::And(x.in0, y.in0);
  quad.in10 = hn::And(x.in1, y.in0);
  quad.in01 = hn::And(x.in0, y.in1);
  quad.in11 = hn::And(x.in1, y.in1);
  if constexpr (F::kWords && kGathersNeighbours) {
    const hn::RebindToSigned<D> di;
    const uint8_t* texels = TexelsOf(d, texture, top);  // a lane's four lie on one level
    if (HWY_LIKELY(texels && texture.channels == 4 && hn::AllTrue(di, hn::Eq(x.i1, hn::Add(x.i0, hn::Set(di, 1)))))) {
      GatherNeighbours(d, texels, top, bottom, x.i0, &quad.t00, &quad.t10, &quad.t01, &quad.t11);
      return quad;
    }
  }
  quad.t00 = F::fetch(d, texture, hn::Add(top, x.i0));
  quad.t10 = F::fetch(d, texture, hn::Add(top, x.i1));
  quad.t01 = F::fetch(d, texture, hn::Add(bottom, x.i0));
  quad.t11 = F::fetch(d, texture, hn::Add(bottom, x.i1));
  return quad;
}

/// Weights to 8 bits, as texture units have them; a weight of 1 is 0 of the other tap.
template <class D>
HWY_INLINE void RoundWeights(D d, LinearTaps<D>* taps) {
  const hn::RebindToSigned<D> di;
  const auto steps = hn::Set(d, 256.0f);
  const auto s = hn::Div(hn::Floor(hn::Add(hn::Mul(taps->s, steps), hn::Set(d, 0.5f))), steps);
  const auto next = hn::Eq(s, hn::Set(d, 1.0f));
  taps->s = hn::IfThenZeroElse(next, s);
  taps->i0 = hn::IfThenElse(hn::RebindMask(di, next), taps->i1, taps->i0);
  taps->in0 = hn::Or(hn::And(next, taps->in1), hn::AndNot(next, taps->in0));
}

template <class F, class D>
SHD_KERNEL_PART Quad<F, D> FetchQuad(D d, const Texture& texture, const Sampler& sampler, const Level<D>& level,
                                     hn::Vec<D> u, hn::Vec<D> v) {
  LinearTaps<D> x = WrapLinear(d, sampler.wrap_u, u, level.across);
  LinearTaps<D> y = WrapLinear(d, sampler.wrap_v, v, level.down);
  if (HWY_UNLIKELY(sampler.rounded_weights)) {
    RoundWeights(d, &x);
    RoundWeights(d, &y);
  }
  return FetchTaps<F>(d, texture, level, x, y);
}

/// Bilinear value of channel C, in the lerp domain.
template <class F, bool kBorder, size_t C, class D>
SHD_KERNEL_PART auto BlendQuad(D d, const Quad<F, D>& quad, const Sampler& sampler) {
  using B = Blend<F, kBorder>;
  const auto t00 = B::template tap<C>(d, quad.t00, quad.in00, sampler);
  const auto t10 = B::template tap<C>(d, quad.t10, quad.in10, sampler);
  const auto top = B::blend_u(d, t00, t10, quad.s, quad.rate_s);
  const auto t01 = B::template tap<C>(d, quad.t01, quad.in01, sampler);
  const auto t11 = B::template tap<C>(d, quad.t11, quad.in11, sampler);
  const auto bottom = B::blend_u(d, t01, t11, quad.s, quad.rate_s);
  return B::blend_v(d, top, bottom, quad.t, quad.rate_t);
}

/// Bilinear values of the wanted channels, to element i of their columns.
template <class F, bool kBorder, class D>
struct QuadValue {
  const Quad<F, D>& quad;
  const Sampler& sampler;

  template <size_t C>
  HWY_INLINE auto of() const {
    return BlendQuad<F, kBorder, C>(D(), quad, sampler);
  }
};
template <class F, bool kBorder, class D>
HWY_INLINE void StoreQuad(D d, const Quad<F, D>& quad, const Sampler& sampler, const Texels& out, size_t i) {
  StoreChannels<F, kBorder>(d, QuadValue<F, kBorder, D>{quad, sampler}, out, i);
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_FILTER_INL_H_
