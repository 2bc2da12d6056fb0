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
SHD_KERNEL_PART Level<D> SameLevel(D d, const Texture& texture, uint32_t level) {
  const hn::RebindToSigned<D> di;
  const auto width = static_cast<int32_t>(level_size(texture.width, level));
  const auto height = static_cast<int32_t>(level_size(texture.height, level));
  return {{hn::Set(d, static_cast<float>(width)), hn::Set(di, width)},
          {hn::Set(d, static_cast<float>(height)), hn::Set(di, height)},
          hn::Set(di, static_cast<int32_t>(texture.offset[level]))};
}

/// max(1, floor(base * scale)), scale a power of two: exact, as sizes are below 2^24.
template <class D, class V>
HWY_INLINE AxisSize<D> ScaledSize(D d, uint32_t base, V scale) {
  const hn::RebindToSigned<D> di;
  const V size = hn::Max(hn::Floor(hn::Mul(hn::Set(d, static_cast<float>(base)), scale)), hn::Set(d, 1.0f));
  return {size, hn::ConvertTo(di, size)};
}

template <class D>
SHD_KERNEL_PART Level<D> LevelPerLane(D d, const Texture& texture, Ints<D> level) {
  const hn::RebindToSigned<D> di;
  const auto scale = hn::BitCast(d, hn::ShiftLeft<23>(hn::Sub(hn::Set(di, 127), level)));
  return {ScaledSize(d, texture.width, scale), ScaledSize(d, texture.height, scale),
          hn::GatherIndex(di, reinterpret_cast<const int32_t*>(texture.offset), level)};
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

/// How values of format F are read and blended. With a border, values leave the lerp domain of the format before
/// they meet the border colour, which may be any finite float.
template <class F, bool kBorder>
struct Blend {
  template <size_t C, class D>
  static HWY_INLINE hn::Vec<D> tap(D d, const typename F::template Texel<D>& texel, MaskOf<D> in,
                                   const Sampler& sampler) {
    const hn::Vec<D> value = F::template decode<C>(d, texel);
    if constexpr (!kBorder) return value;
    return hn::IfThenElse(in, F::template finish<C>(d, value), hn::Set(d, sampler.border[C]));
  }

  template <class D, class V>
  static HWY_INLINE V blend(D d, V a, V b, V s) {
    if constexpr (kBorder || F::kFloat) return Mix(d, a, b, s);
    return Lerp(d, a, b, s);
  }

  /// The result; one NaN for all, whatever the target makes of several.
  template <size_t C, class D>
  static HWY_INLINE hn::Vec<D> finish(D d, hn::Vec<D> value) {
    if constexpr (F::kFloat) return hn::IfThenElse(hn::Eq(value, value), value, hn::Set(d, __builtin_nanf("")));
    if constexpr (kBorder) return value;
    return F::template finish<C>(d, value);
  }
};

/// The four texels around a point of a level.
template <class F, class D>
struct Quad {
  using Texel = typename F::template Texel<D>;
  hn::Vec<D> s, t;
  Texel t00, t10, t01, t11;  // column, row
  MaskOf<D> in00, in10, in01, in11;
};

template <class F, class D>
SHD_KERNEL_PART Quad<F, D> FetchQuad(D d, const Texture& texture, const Sampler& sampler, const Level<D>& level,
                                     hn::Vec<D> u, hn::Vec<D> v) {
  const LinearTaps<D> x = WrapLinear(d, sampler.wrap_u, u, level.across);
  const LinearTaps<D> y = WrapLinear(d, sampler.wrap_v, v, level.down);
  const uint8_t* texels = texture.texels.data();
  const auto top = RowIndex(d, level, y.i0), bottom = RowIndex(d, level, y.i1);
  Quad<F, D> quad;
  quad.s = x.s;
  quad.t = y.s;
  quad.in00 = hn::And(x.in0, y.in0);
  quad.in10 = hn::And(x.in1, y.in0);
  quad.in01 = hn::And(x.in0, y.in1);
  quad.in11 = hn::And(x.in1, y.in1);
  if constexpr (F::kWords && kGathersNeighbours) {
    const hn::RebindToSigned<D> di;
    if (HWY_LIKELY(hn::AllTrue(di, hn::Eq(x.i1, hn::Add(x.i0, hn::Set(di, 1)))))) {
      GatherNeighbours(d, texels, top, bottom, x.i0, &quad.t00, &quad.t10, &quad.t01, &quad.t11);
      return quad;
    }
  }
  quad.t00 = F::fetch(d, texels, hn::Add(top, x.i0));
  quad.t10 = F::fetch(d, texels, hn::Add(top, x.i1));
  quad.t01 = F::fetch(d, texels, hn::Add(bottom, x.i0));
  quad.t11 = F::fetch(d, texels, hn::Add(bottom, x.i1));
  return quad;
}

/// Bilinear value of channel C, in the lerp domain.
template <class F, bool kBorder, size_t C, class D>
SHD_KERNEL_PART hn::Vec<D> BlendQuad(D d, const Quad<F, D>& quad, const Sampler& sampler) {
  using B = Blend<F, kBorder>;
  const auto top = B::blend(d, B::template tap<C>(d, quad.t00, quad.in00, sampler),
                            B::template tap<C>(d, quad.t10, quad.in10, sampler), quad.s);
  const auto bottom = B::blend(d, B::template tap<C>(d, quad.t01, quad.in01, sampler),
                               B::template tap<C>(d, quad.t11, quad.in11, sampler), quad.s);
  return B::blend(d, top, bottom, quad.t);
}

template <class F, bool kBorder, size_t C, class D>
HWY_INLINE void StoreQuadChannel(D d, const Quad<F, D>& quad, const Sampler& sampler, const Texels& out, size_t i) {
  if (!out.channel[C]) return;
  const auto value = BlendQuad<F, kBorder, C>(d, quad, sampler);
  hn::StoreU(Blend<F, kBorder>::template finish<C>(d, value), d, out.channel[C] + i);
}

/// Bilinear values of the wanted channels, to element i of their columns.
template <class F, bool kBorder, class D>
HWY_INLINE void StoreQuad(D d, const Quad<F, D>& quad, const Sampler& sampler, const Texels& out, size_t i) {
  StoreQuadChannel<F, kBorder, 0>(d, quad, sampler, out, i);
  if constexpr (F::kChannels == 4) {
    StoreQuadChannel<F, kBorder, 1>(d, quad, sampler, out, i);
    StoreQuadChannel<F, kBorder, 2>(d, quad, sampler, out, i);
    StoreQuadChannel<F, kBorder, 3>(d, quad, sampler, out, i);
  }
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_FILTER_INL_H_
