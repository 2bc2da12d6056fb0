// SPDX-License-Identifier: MIT
// The fold of MIRROR_BALL and ANGULAR: beyond the rim, at a distance r > 1 from the centre, the image goes on at 2 - r
// on the other side.

#if defined(SHD_TEXTURE_FOLDS_DISC_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_FOLDS_DISC_INL_H_
#undef SHD_TEXTURE_FOLDS_DISC_INL_H_
#else
#define SHD_TEXTURE_FOLDS_DISC_INL_H_
#endif

#include <hwy/highway.h>

#include "simd/kernel_part.h"
#include "simd/round-inl.h"
#include "texture/domain/folds/folded-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::RoundDown;

struct DiscFold : FoldBase<DiscFold> {
  static constexpr bool kIsDisc = true;

  /// The nearest texel to the point at 2 - r, whose centre lies in the disc.
  template <class D>
  static HWY_INLINE FoldedTexel<D> texel(D d, const Level<D>& level, hn::Vec<D> x, hn::Vec<D> y, Ints<D> face) {
    using V = hn::Vec<D>;
    const V size = level.across.real;
    const V one = hn::Set(d, 1.0f), two = hn::Set(d, 2.0f), zero = hn::Zero(d), last = size - one;
    const V p = (x + x) - last, q = (y + y) - last;  // the radius of the disc is `size`
    const V squared = p * p + q * q;
    const auto outside = hn::Gt(squared, size * size);
    const V r = hn::Sqrt(squared);
    const V inner = hn::Max(hn::Min(two * size - r, size - hn::Set(d, 1.4142136f)), zero);
    const V scale = hn::IfThenElseZero(outside, inner / r);
    const V half = hn::Set(d, 0.5f);
    const V far_x = RoundDown((size - p * scale) * half), far_y = RoundDown((size - q * scale) * half);
    return {hn::IfThenElse(outside, hn::Min(hn::Max(far_x, zero), last), x),
            hn::IfThenElse(outside, hn::Min(hn::Max(far_y, zero), last), y), face};
  }

  template <class D>
  static HWY_INLINE FoldedPoint<D> point(D d, hn::Vec<D> u, hn::Vec<D> v, Ints<D> face) {
    using V = hn::Vec<D>;
    const V zero = hn::Zero(d), half = hn::Set(d, 0.5f), one = hn::Set(d, 1.0f), two = hn::Set(d, 2.0f);
    u = WithinOneImage(d, u), v = WithinOneImage(d, v);
    const V p = (u + u) - one, q = (v + v) - one, squared = p * p + q * q;
    const auto outside = hn::Gt(squared, one);
    const V r = hn::Sqrt(squared);
    const V scale = hn::Min(r - two, zero) / hn::Max(r, one);
    return {hn::IfThenElse(outside, half + half * (p * scale), u),
            hn::IfThenElse(outside, half + half * (q * scale), v), face};
  }

  template <class D>
  static HWY_INLINE PointRates<D> rates(D d, hn::Vec<D> u, hn::Vec<D> v, Ints<D>) {
    using V = hn::Vec<D>;
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0f), two = hn::Set(d, 2.0f);
    const V s = (u + u) - one, t = (v + v) - one;
    // (p, q) becomes (1 - 2 / r) (p, q).
    const auto cut = [&](V x) SHD_INLINE_LAMBDA { return hn::Min(hn::Max(x, hn::Set(d, -3.0f)), hn::Set(d, 3.0f)); };
    const V p = cut(s), q = cut(t), squared = p * p + q * q, r = hn::Sqrt(squared);
    const auto outside = hn::Gt(squared, one), beyond = hn::Gt(r, two);
    const V scale = hn::Min(r - two, zero) / hn::Max(r, one);
    const V turn = hn::IfThenZeroElse(beyond, two / hn::Max(squared * r, one));
    const V u_u = hn::IfThenElse(outside, scale + turn * p * p, one),
            v_v = hn::IfThenElse(outside, scale + turn * q * q, one);
    const V cross = hn::IfThenElseZero(outside, turn * p * q);
    const auto free_p = hn::Eq(p, s), free_q = hn::Eq(q, t);
    return {hn::IfThenElseZero(free_p, u_u), hn::IfThenElseZero(free_q, cross), hn::IfThenElseZero(free_p, cross),
            hn::IfThenElseZero(free_q, v_v)};
  }
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_FOLDS_DISC_INL_H_
