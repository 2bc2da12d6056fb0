// SPDX-License-Identifier: MIT
// The fold of OCTAHEDRAL: an edge is folded in its middle. Beside it lies its own row or column, in reverse order.

#if defined(SHD_TEXTURE_FOLDS_OCTAHEDRAL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_FOLDS_OCTAHEDRAL_INL_H_
#undef SHD_TEXTURE_FOLDS_OCTAHEDRAL_INL_H_
#else
#define SHD_TEXTURE_FOLDS_OCTAHEDRAL_INL_H_
#endif

#include <hwy/highway.h>

#include "simd/kernel_part.h"
#include "texture/domain/folds/folded-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

struct OctahedralFold : FoldBase<OctahedralFold> {
  static constexpr bool kIsPeriodic = true;

  template <class D>
  static HWY_INLINE FoldedTexel<D> texel(D d, const Level<D>& level, hn::Vec<D> x, hn::Vec<D> y, Ints<D> face) {
    using V = hn::Vec<D>;
    const V size = level.across.real, zero = hn::Zero(d), last = size - hn::Set(d, 1.0f);
    const auto beside_x = is_beside(d, x, size), beside_y = is_beside(d, y, size);
    const auto mirrored = [&](V at) SHD_INLINE_LAMBDA {
      const V near = hn::Max(at, hn::Neg(at) - hn::Set(d, 1.0f));
      return hn::Max(hn::Min(near, last + size - near), zero);
    };
    const V in_x = hn::Min(mirrored(x), last), in_y = hn::Min(mirrored(y), last);
    return {hn::IfThenElse(beside_y, last - in_x, in_x), hn::IfThenElse(beside_x, last - in_y, in_y), face};
  }

  template <class D>
  static HWY_INLINE FoldedPoint<D> point(D d, hn::Vec<D> u, hn::Vec<D> v, Ints<D> face) {
    using V = hn::Vec<D>;
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0f), two = hn::Set(d, 2.0f);
    u = WithinOneImage(d, u), v = WithinOneImage(d, v);
    const auto beside_u = hn::Or(hn::Lt(u, zero), hn::Gt(u, one)), beside_v = hn::Or(hn::Lt(v, zero), hn::Gt(v, one));
    const V in_u = hn::IfThenElse(hn::Gt(u, one), two - u, hn::Abs(u));
    const V in_v = hn::IfThenElse(hn::Gt(v, one), two - v, hn::Abs(v));
    return {hn::IfThenElse(beside_v, one - in_u, in_u), hn::IfThenElse(beside_u, one - in_v, in_v), face};
  }

  template <class D>
  static HWY_INLINE PointRates<D> rates(D d, hn::Vec<D> u, hn::Vec<D> v, Ints<D>) {
    using V = hn::Vec<D>;
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
    const V s = (u + u) - one, t = (v + v) - one;
    const auto beside_u = hn::Gt(hn::Abs(s), one), beside_v = hn::Gt(hn::Abs(t), one);
    const auto slope = [&](V x) SHD_INLINE_LAMBDA {
      return hn::IfThenElseZero(hn::Le(hn::Abs(x), hn::Set(d, 3.0f)), one);  // point() cuts longer distances
    };
    // Each coordinate is mirrored at its own edges, and by the edges of the other one.
    const auto mirrored = hn::Xor(beside_u, beside_v);
    return {hn::IfThenElse(mirrored, hn::Neg(slope(s)), slope(s)), zero, zero,
            hn::IfThenElse(mirrored, hn::Neg(slope(t)), slope(t))};
  }

 private:
  template <class D, class V>
  static HWY_INLINE MaskOf<D> is_beside(D d, V x, V size) {
    return hn::Or(hn::Lt(x, hn::Zero(d)), hn::Ge(x, size));
  }
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_FOLDS_OCTAHEDRAL_INL_H_
