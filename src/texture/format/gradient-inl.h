// SPDX-License-Identifier: MIT
// Derivatives in u and v, or in w, by forward differentiation: the tree of blends is that of the values, and each value
// carries its derivatives. The footprint is constant, so weights that depend on it alone have no derivative. At a texel
// centre the result is the derivative to the right.

#if defined(SHD_TEXTURE_GRADIENT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_GRADIENT_INL_H_
#undef SHD_TEXTURE_GRADIENT_INL_H_
#else
#define SHD_TEXTURE_GRADIENT_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/format/unpacked-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Returns rate (b - a). A rate of 0 gives 0 even if the values are infinite or NaN.
template <class D, class V>
HWY_INLINE V Slope(D d, V a, V b, V rate) {
  return hn::IfThenZeroElse(hn::Eq(rate, hn::Zero(d)), rate * (b - a));
}

/// Returns mixed + rate (b - a). Where finite arguments overflow, the product and the sum become the largest float of
/// their sign.
template <class D, class V>
HWY_NOINLINE V SlopeOverflowed(D d, V mixed, V a, V b, V rate) {
  const V sum = mixed + Slope(d, a, b, rate);
  const V half = hn::Set(d, 0.5f), halved = Slope(d, half * a, half * b, rate);
  const auto clamped = hn::And(IsFinite(d, mixed), hn::And(IsFinite(d, a), IsFinite(d, b)));
  const V safe = ClampWhere(d, clamped, mixed + ClampWhere(d, clamped, halved + halved));
  return hn::IfThenElse(hn::Or(IsFinite(d, sum), hn::Not(clamped)), sum, safe);
}

/// Returns the derivative of a + s (b - a) from those of a and b and the rate of s. Finite floats give finite results.
template <class D, class V>
HWY_INLINE V MixSlopes(D d, V a_slope, V b_slope, V s, V a, V b, V rate) {
  const V mixed = hn::IfThenElse(hn::Eq(s, hn::Zero(d)), a_slope, a_slope + s * (b_slope - a_slope));
  const V sum = mixed + Slope(d, a, b, rate);
  if (HWY_LIKELY(hn::AllTrue(d, IsFinite(d, sum)))) return sum;
  return SlopeOverflowed(d, Mix(d, a_slope, b_slope, s), a, b, rate);
}

struct GradientBlend {
  using Values = Blend<Unpacked, true>;

  template <class D>
  struct Value {
    hn::Vec<D> value, du, dv;
  };

  Values values;

  explicit GradientBlend(const Consumption& consumption) : values(consumption) {}

  template <size_t C, class D>
  HWY_INLINE Value<D> tap(D d, const Unpacked::Texel<D>& texel, MaskOf<D> in) const {
    return {values.tap<C>(d, texel, in), hn::Zero(d), hn::Zero(d)};
  }
  template <class D>
  HWY_INLINE Value<D> blend(D d, const Value<D>& a, const Value<D>& b, hn::Vec<D> s) const {
    return {Mix(d, a.value, b.value, s), Mix(d, a.du, b.du, s), Mix(d, a.dv, b.dv, s)};
  }
  template <class D>
  HWY_INLINE Value<D> blend_s(D d, const Value<D>& a, const Value<D>& b, hn::Vec<D> s, const float* rate) const {
    return {Mix(d, a.value, b.value, s), MixSlopes(d, a.du, b.du, s, a.value, b.value, hn::Load(d, rate)),
            Mix(d, a.dv, b.dv, s)};
  }
  template <class D>
  HWY_INLINE Value<D> blend_t(D d, const Value<D>& a, const Value<D>& b, hn::Vec<D> t, const float* rate) const {
    return {Mix(d, a.value, b.value, t), Mix(d, a.du, b.du, t),
            MixSlopes(d, a.dv, b.dv, t, a.value, b.value, hn::Load(d, rate))};
  }
  template <class D>
  HWY_INLINE Value<D> blend_by(D d, const Value<D>& a, const Value<D>& b, hn::Vec<D> s, const float* rate_u,
                               const float* rate_v) const {
    return {Mix(d, a.value, b.value, s), MixSlopes(d, a.du, b.du, s, a.value, b.value, hn::Load(d, rate_u)),
            MixSlopes(d, a.dv, b.dv, s, a.value, b.value, hn::Load(d, rate_v))};
  }
  template <class D>
  HWY_INLINE Value<D> replace(D, MaskOf<D> lanes, const Value<D>& a, const Value<D>& b) const {
    return {hn::IfThenElse(lanes, b.value, a.value), hn::IfThenElse(lanes, b.du, a.du),
            hn::IfThenElse(lanes, b.dv, a.dv)};
  }

  static constexpr uint32_t kRates = kRated;
  static constexpr size_t kResults = 2, kFirstColumn = 4;

  /// Returns the derivative in u (k = 0) or v (k = 1).
  template <size_t C, class D>
  HWY_INLINE hn::Vec<D> finish(D d, const Value<D>& value, size_t k) const {
    return Values::finish<C>(d, k == 0 ? value.du : value.dv);
  }
  static HWY_INLINE bool wanted(const Texels& out, size_t channel) { return out.du[channel] || out.dv[channel]; }
};

/// Values with their derivatives in w. Only shares of slices depend on w.
struct DeepBlend {
  using Values = Blend<Unpacked, true>;

  template <class D>
  struct Value {
    hn::Vec<D> value, dw;
  };

  Values values;

  explicit DeepBlend(const Consumption& consumption) : values(consumption) {}

  template <size_t C, class D>
  HWY_INLINE Value<D> tap(D d, const Unpacked::Texel<D>& texel, MaskOf<D> in) const {
    return {values.tap<C>(d, texel, in), hn::Zero(d)};
  }
  template <class D>
  HWY_INLINE Value<D> blend(D d, const Value<D>& a, const Value<D>& b, hn::Vec<D> s) const {
    return {Mix(d, a.value, b.value, s), Mix(d, a.dw, b.dw, s)};
  }
  template <class D>
  HWY_INLINE Value<D> blend_s(D d, const Value<D>& a, const Value<D>& b, hn::Vec<D> s, const float*) const {
    return {Mix(d, a.value, b.value, s), hn::Zero(d)};  // within a slice
  }
  template <class D>
  HWY_INLINE Value<D> blend_t(D d, const Value<D>& a, const Value<D>& b, hn::Vec<D> t, const float*) const {
    return {Mix(d, a.value, b.value, t), hn::Zero(d)};
  }
  template <class D>
  HWY_INLINE Value<D> blend_by(D d, const Value<D>& a, const Value<D>& b, hn::Vec<D> s, const float* rate,
                               const float*) const {
    return {Mix(d, a.value, b.value, s), MixSlopes(d, a.dw, b.dw, s, a.value, b.value, hn::Load(d, rate))};
  }
  template <class D>
  HWY_INLINE Value<D> replace(D, MaskOf<D> lanes, const Value<D>& a, const Value<D>& b) const {
    return {hn::IfThenElse(lanes, b.value, a.value), hn::IfThenElse(lanes, b.dw, a.dw)};
  }

  static constexpr uint32_t kRates = kDeep;
  static constexpr size_t kResults = 1, kFirstColumn = 12;

  template <size_t C, class D>
  HWY_INLINE hn::Vec<D> finish(D d, const Value<D>& value, size_t) const {
    return Values::finish<C>(d, value.dw);
  }
  static HWY_INLINE bool wanted(const Texels& out, size_t channel) { return out.dw[channel] != nullptr; }
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_GRADIENT_INL_H_
