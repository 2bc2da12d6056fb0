// SPDX-License-Identifier: MIT
// Derivatives in u and v by forward differentiation: the tree of blends is that of the values, and each value carries
// its derivatives. The footprint is constant, so weights that depend on it alone have no derivative. At a texel centre
// the result is the derivative to the right.

#if defined(SHD_TEXTURE_GRADIENT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_GRADIENT_INL_H_
#undef SHD_TEXTURE_GRADIENT_INL_H_
#else
#define SHD_TEXTURE_GRADIENT_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/format/consume-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class F>
struct GradientBlend {
  using Values = Blend<F, true>;

  template <class D>
  struct Value {
    hn::Vec<D> value, du, dv;
  };

  Values values;

  explicit GradientBlend(const Consumption& consumption) : values(consumption) {}

  template <size_t C, class D>
  HWY_INLINE Value<D> tap(D d, const typename F::template Texel<D>& texel, MaskOf<D> in) const {
    return {values.template tap<C>(d, texel, in), hn::Zero(d), hn::Zero(d)};
  }
  template <class D>
  HWY_INLINE Value<D> blend(D d, const Value<D>& a, const Value<D>& b, hn::Vec<D> s) const {
    return {Mix(d, a.value, b.value, s), Mix(d, a.du, b.du, s), Mix(d, a.dv, b.dv, s)};
  }
  template <class D>
  HWY_INLINE Value<D> blend_s(D d, const Value<D>& a, const Value<D>& b, hn::Vec<D> s, const float* rate) const {
    Value<D> blended = blend(d, a, b, s);
    blended.du = blended.du + Slope(d, a.value, b.value, hn::Load(d, rate));
    return blended;
  }
  template <class D>
  HWY_INLINE Value<D> blend_t(D d, const Value<D>& a, const Value<D>& b, hn::Vec<D> t, const float* rate) const {
    Value<D> blended = blend(d, a, b, t);
    blended.dv = blended.dv + Slope(d, a.value, b.value, hn::Load(d, rate));
    return blended;
  }
  template <class D>
  HWY_INLINE Value<D> blend_by(D d, const Value<D>& a, const Value<D>& b, hn::Vec<D> s, const float* rate_u,
                               const float* rate_v) const {
    return blend_t(d, a, b, s, rate_v, blend_s(d, a, b, s, rate_u));
  }
  template <class D>
  HWY_INLINE Value<D> replace(D, MaskOf<D> lanes, const Value<D>& a, const Value<D>& b) const {
    return {hn::IfThenElse(lanes, b.value, a.value), hn::IfThenElse(lanes, b.du, a.du),
            hn::IfThenElse(lanes, b.dv, a.dv)};
  }

  static constexpr size_t kResults = 2, kFirstColumn = 4;

  /// Returns the derivative in u (k = 0) or v (k = 1).
  template <size_t C, class D>
  HWY_INLINE hn::Vec<D> finish(D d, const Value<D>& value, size_t k) const {
    return Values::template finish<C>(d, k == 0 ? value.du : value.dv);
  }
  static HWY_INLINE bool wanted(const Texels& out, size_t channel) { return out.du[channel] || out.dv[channel]; }

 private:
  /// Adds the derivative of the weight in v to a blend that has its derivative in u.
  template <class D>
  HWY_INLINE Value<D> blend_t(D d, const Value<D>& a, const Value<D>& b, hn::Vec<D>, const float* rate,
                              Value<D> blended) const {
    blended.dv = blended.dv + Slope(d, a.value, b.value, hn::Load(d, rate));
    return blended;
  }
  /// Returns rate (b - a). A rate of 0 gives 0 even if the values are infinite or NaN.
  template <class D, class V>
  static HWY_INLINE V Slope(D d, V a, V b, V rate) {
    return hn::IfThenZeroElse(hn::Eq(rate, hn::Zero(d)), rate * (b - a));
  }
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_GRADIENT_INL_H_
