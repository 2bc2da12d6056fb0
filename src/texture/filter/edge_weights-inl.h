// SPDX-License-Identifier: MIT
// Quads at the edges of an image of directions as texels with weights. Derivatives need them: the weights of a corner
// of the cube, and those of a probe that leaves the image, depend on both coordinates. The shares of a quad do not.

#if defined(SHD_TEXTURE_EDGE_WEIGHTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_EDGE_WEIGHTS_INL_H_
#undef SHD_TEXTURE_EDGE_WEIGHTS_INL_H_
#else
#define SHD_TEXTURE_EDGE_WEIGHTS_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/domain/fold-inl.h"
#include "texture/filter/emitter-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Returns a product with its derivatives.
template <class D>
HWY_INLINE Share<D> Product(const Share<D>& a, const Share<D>& b) {
  return {a.value * b.value, a.rate_u * b.value + a.value * b.rate_u, a.rate_v * b.value + a.value * b.rate_v};
}

/// Returns 1 - a.
template <class D>
HWY_INLINE Share<D> Complement(D d, const Share<D>& a) {
  return {hn::Set(d, 1.0f) - a.value, hn::Neg(a.rate_u), hn::Neg(a.rate_v)};
}

template <class D>
HWY_INLINE Share<D> SelectShare(MaskOf<D> lanes, const Share<D>& a, const Share<D>& b) {
  return {hn::IfThenElse(lanes, a.value, b.value), hn::IfThenElse(lanes, a.rate_u, b.rate_u),
          hn::IfThenElse(lanes, a.rate_v, b.rate_v)};
}

/// The fractions of a quad on a level.
template <class D>
struct QuadFractions {
  Share<D> s, t;

  template <class Taps>
  HWY_INLINE QuadFractions(const PointRates<D>& rates, const Taps& taps)
      : s{taps.s, rates.u_u * taps.rate_s, rates.u_v * taps.rate_s},
        t{taps.t, rates.v_u * taps.rate_t, rates.v_v * taps.rate_t} {}
};

/// Texels with weights whose sum is 1.
template <class D>
struct WeightedTexels {
  TexelPlace<D> texel[8];
  Share<D> weight[8];
  size_t count = 0;

  /// Adds the texels of a quad. `part`: weight of the quad.
  HWY_INLINE void add(D d, const TexelPlace<D> (&quad)[4], const Share<D>& s, const Share<D>& t, const Share<D>& part) {
    const Share<D> top = Product<D>(part, Complement(d, t)), bottom = Product<D>(part, t), left = Complement(d, s);
    const Share<D> weights[4] = {Product<D>(top, left), Product<D>(top, s), Product<D>(bottom, left),
                                 Product<D>(bottom, s)};
    for (size_t k = 0; k < 4; ++k, ++count) texel[count] = quad[k], weight[count] = weights[k];
  }

  /// Shares the weight of a texel of a quad out to the other three. `missing`: lanes where texel k is missing.
  HWY_INLINE void share_out(D d, size_t k, MaskOf<D> missing) {
    const auto third = hn::IfThenElseZero(missing, hn::Set(d, 1.0f / 3.0f));
    for (size_t i = 0; i < 4; ++i) {
      if (i == k) continue;
      weight[i].value = weight[i].value + third * weight[k].value;
      weight[i].rate_u = weight[i].rate_u + third * weight[k].rate_u;
      weight[i].rate_v = weight[i].rate_v + third * weight[k].rate_v;
    }
    const Share<D> none = {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
    weight[k] = SelectShare<D>(missing, none, weight[k]);
  }

  /// Emits the texels in place of a kReplace element with a share: a lane with the share kWhole starts with its first
  /// weight that is not 0.
  template <class Sink>
  HWY_INLINE void emit(D d, uint32_t second, const Level<D>& level, hn::Vec<D> share, Sink& sink) const {
    using V = hn::Vec<D>;
    const V one = hn::Set(d, 1.0f), whole = hn::Min(share, one);
    V sum = one - whole, sum_u = hn::Zero(d), sum_v = hn::Zero(d);
    for (size_t k = 0; k < count; ++k) {
      const V value = whole * weight[k].value, rate_u = whole * weight[k].rate_u, rate_v = whole * weight[k].rate_v;
      const auto first = hn::Eq(sum, hn::Zero(d));
      sum = sum + value, sum_u = sum_u + rate_u, sum_v = sum_v + rate_v;
      const auto none = hn::Eq(sum, hn::Zero(d));
      const V part = hn::IfThenZeroElse(none, value / sum);
      const Share<D> blend = {hn::IfThenElse(first, hn::Set(d, kWhole), part),
                              hn::IfThenZeroElse(none, (rate_u - part * sum_u) / sum),
                              hn::IfThenZeroElse(none, (rate_v - part * sum_v) / sum)};
      sink.texel(d, kReplace | second, level, texel[k], hn::Eq(one, one), blend);
    }
  }
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_EDGE_WEIGHTS_INL_H_
