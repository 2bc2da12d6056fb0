// SPDX-License-Identifier: MIT
// The format class of a kernel that gives derivatives in u and v: the same tree of blends, whose values carry their
// derivatives along (forward differentiation). The footprint is held constant, so weights that depend on it alone
// have no derivative. At a texel centre the derivative is that to the right.

#if defined(SHD_TEXTURE_GRADIENT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_GRADIENT_INL_H_
#undef SHD_TEXTURE_GRADIENT_INL_H_
#else
#define SHD_TEXTURE_GRADIENT_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/filter-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class F>
struct Gradient : F {};

template <class F>
constexpr bool kIsGradient = false;
template <class F>
constexpr bool kIsGradient<Gradient<F>> = true;

template <class F, bool kBorder>
struct Blend<Gradient<F>, kBorder> {
  using Values = Blend<F, true>;

  template <class D>
  struct Value {
    hn::Vec<D> value, du, dv;
  };

  template <size_t C, class D>
  static HWY_INLINE Value<D> tap(D d, const typename F::template Texel<D>& texel, MaskOf<D> in,
                                 const Sampler& sampler) {
    return {Values::template tap<C>(d, texel, in, sampler), hn::Zero(d), hn::Zero(d)};
  }
  template <class D>
  static HWY_INLINE Value<D> blend(D d, const Value<D>& a, const Value<D>& b, hn::Vec<D> s) {
    return {Mix(d, a.value, b.value, s), Mix(d, a.du, b.du, s), Mix(d, a.dv, b.dv, s)};
  }
  template <class D>
  static HWY_INLINE Value<D> blend_u(D d, const Value<D>& a, const Value<D>& b, hn::Vec<D> s, hn::Vec<D> rate) {
    Value<D> blended = blend(d, a, b, s);
    blended.du = hn::Add(blended.du, Slope(d, a.value, b.value, rate));
    return blended;
  }
  template <class D>
  static HWY_INLINE Value<D> blend_v(D d, const Value<D>& a, const Value<D>& b, hn::Vec<D> s, hn::Vec<D> rate) {
    Value<D> blended = blend(d, a, b, s);
    blended.dv = hn::Add(blended.dv, Slope(d, a.value, b.value, rate));
    return blended;
  }

  template <class D>
  static HWY_INLINE Value<D> join(D d, MaskOf<D> first, const Value<D>& a, const Value<D>& b, hn::Vec<D> s,
                                  hn::Vec<D> rate_u, hn::Vec<D> rate_v) {
    const Value<D> blended = blend(d, a, b, s);
    const auto du = hn::Add(blended.du, Slope(d, a.value, b.value, rate_u));
    const auto dv = hn::Add(blended.dv, Slope(d, a.value, b.value, rate_v));
    return {hn::IfThenElse(first, b.value, blended.value), hn::IfThenElse(first, b.du, du),
            hn::IfThenElse(first, b.dv, dv)};
  }

  /// rate (b - a); 0 for a rate of 0, whatever the values.
  template <class D, class V>
  static HWY_INLINE V Slope(D d, V a, V b, V rate) {
    return hn::IfThenZeroElse(hn::Eq(rate, hn::Zero(d)), hn::Mul(rate, hn::Sub(b, a)));
  }

  template <size_t C, class D>
  static HWY_INLINE void store(D d, const Value<D>& value, const Texels& out, size_t i) {
    if (out.du[C]) hn::StoreU(Values::template finish<C>(d, value.du), d, out.du[C] + i);
    if (out.dv[C]) hn::StoreU(Values::template finish<C>(d, value.dv), d, out.dv[C] + i);
  }
  static HWY_INLINE bool wanted(const Texels& out, size_t channel) { return out.du[channel] || out.dv[channel]; }
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_GRADIENT_INL_H_
