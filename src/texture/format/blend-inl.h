// SPDX-License-Identifier: MIT
// How the texels of a format are blended. Every filter is a tree of blends, so that equal texels give exactly their
// value. A Blend has
//
//   Value<D>         one channel of one vector of lookups
//   tap<C>           of a texel, or of the border in lanes that are not `in`
//   blend            a + s (b - a) by a weight that does not depend on the point
//   blend_s, blend_t the same along u with ds/du = rate, along v with dt/dv = rate
//   blend_by         the same with rates in u and v
//   replace          b in some lanes, a in the others
//   store<C>         finishes and writes; wanted: whether a channel is

#if defined(SHD_TEXTURE_BLEND_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_BLEND_INL_H_
#undef SHD_TEXTURE_BLEND_INL_H_
#else
#define SHD_TEXTURE_BLEND_INL_H_
#endif

#include <cstring>

#include <hwy/highway.h>

#include "texture/store/wrap-inl.h"
#include "texture/stream.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// a + s (b - a) for values whose difference cannot overflow: a itself where a == b or s == 0.
template <class D, class V>
HWY_INLINE V Lerp(D, V a, V b, V s) {
  return a + s * (b - a);
}

/// Lerp for any floats: a value of weight 0 never counts, infinities and NaN of other weights do, and finite values
/// stay finite, as (1 - s) a + s b takes over where b - a overflows.
template <class D, class V>
HWY_INLINE V Mix(D d, V a, V b, V s) {
  const V difference = b - a;
  const auto finite = hn::Eq(difference - difference, hn::Zero(d));
  V mixed = a + s * difference;
  if (HWY_UNLIKELY(!hn::AllTrue(d, finite))) {
    const V weighted = (hn::Set(d, 1.0f) - s) * a + s * b;
    mixed = hn::IfThenElse(finite, mixed, weighted);
  }
  return hn::IfThenElse(hn::Eq(s, hn::Zero(d)), a, mixed);
}

/// Writes up to `count` lanes.
template <class D>
HWY_INLINE void StoreFirst(D d, hn::Vec<D> value, size_t count, float* to) {
  if (HWY_LIKELY(count >= hn::Lanes(d))) return hn::StoreU(value, d, to);
  alignas(64) float lanes[hn::MaxLanes(D())];
  hn::Store(value, d, lanes);
  std::memcpy(to, lanes, count * sizeof(float));
}

/// Values of format F. With a border, they leave the lerp domain of the format before they meet the border colour,
/// which may be any finite float.
template <class F, bool kBorder>
struct Blend {
  template <class D>
  using Value = hn::Vec<D>;

  const Sampler& sampler;

  explicit Blend(const Consumption& consumption) : sampler(consumption.sampler) {}

  template <size_t C, class D>
  HWY_INLINE Value<D> tap(D d, const typename F::template Texel<D>& texel, MaskOf<D> in) const {
    const hn::Vec<D> value = F::template decode<C>(d, texel);
    if constexpr (!kBorder) return value;
    return hn::IfThenElse(in, F::template finish<C>(d, value), hn::Set(d, sampler.border[C]));
  }

  /// s is in [0, 1], except in the lobes of cubic kernels.
  template <class D>
  HWY_INLINE Value<D> blend(D d, Value<D> a, Value<D> b, hn::Vec<D> s) const {
    if constexpr (kBorder || F::kFloat) return Mix(d, a, b, s);
    return Lerp(d, a, b, s);
  }
  template <class D>
  HWY_INLINE Value<D> blend_s(D d, Value<D> a, Value<D> b, hn::Vec<D> s, const float*) const {
    return blend(d, a, b, s);
  }
  template <class D>
  HWY_INLINE Value<D> blend_t(D d, Value<D> a, Value<D> b, hn::Vec<D> t, const float*) const {
    return blend(d, a, b, t);
  }
  template <class D>
  HWY_INLINE Value<D> blend_by(D d, Value<D> a, Value<D> b, hn::Vec<D> s, const float*, const float*) const {
    return blend(d, a, b, s);
  }
  template <class D>
  HWY_INLINE Value<D> replace(D, MaskOf<D> lanes, Value<D> a, Value<D> b) const {
    return hn::IfThenElse(lanes, b, a);
  }

  /// The result; one NaN for all, whatever the target makes of several.
  template <size_t C, class D>
  static HWY_INLINE hn::Vec<D> finish(D d, Value<D> value) {
    if constexpr (F::kFloat) return hn::IfThenElse(hn::Eq(value, value), value, hn::Set(d, __builtin_nanf("")));
    if constexpr (kBorder) return value;
    return F::template finish<C>(d, value);
  }
  template <size_t C, class D>
  HWY_INLINE void store(D d, Value<D> value, size_t i, const Consumption& to) const {
    StoreFirst(d, finish<C>(d, value), to.count - i, to.out.channel[C] + i);
  }
  static HWY_INLINE bool wanted(const Texels& out, size_t channel) { return out.channel[channel] != nullptr; }
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_BLEND_INL_H_
