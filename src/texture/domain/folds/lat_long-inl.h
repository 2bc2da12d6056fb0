// SPDX-License-Identifier: MIT
// The fold of LAT_LONG: u repeats, and beyond a pole the rows go on along the opposite meridian.

#if defined(SHD_TEXTURE_FOLDS_LAT_LONG_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_FOLDS_LAT_LONG_INL_H_
#undef SHD_TEXTURE_FOLDS_LAT_LONG_INL_H_
#else
#define SHD_TEXTURE_FOLDS_LAT_LONG_INL_H_
#endif

#include <hwy/highway.h>

#include "simd/round-inl.h"
#include "texture/domain/folds/folded-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::RoundDown;

struct LatLongFold : FoldBase<LatLongFold> {
  static constexpr bool kRepeatsAcross = true;
  static constexpr bool kTurnsAtPoles = true;
  static constexpr bool kIsPeriodic = true;

  /// Rows beyond a pole are the row beside it; the caller turns the column by half a circle. Columns repeat.
  template <class D>
  static HWY_INLINE FoldedTexel<D> texel(D d, const Level<D>& level, hn::Vec<D> x, hn::Vec<D> y, Ints<D> face) {
    using V = hn::Vec<D>;
    const V zero = hn::Zero(d), width = level.across.real;
    const V last = level.down.real - hn::Set(d, 1.0f);
    const V left = x + hn::IfThenElseZero(hn::Lt(x, zero), width);
    const V column = left - hn::IfThenElseZero(hn::Ge(left, width), width);
    return {column, hn::Min(hn::Max(y, zero), last), face};
  }

  /// The texel that contains the direction of the centre of (x, y). Beyond a pole of an image of odd width the centre
  /// lies between two texels; the result is the right one.
  template <class D>
  static HWY_INLINE FoldedTexel<D> far_texel(D d, const Level<D>& level, hn::Vec<D> x, hn::Vec<D> y, Ints<D> face) {
    using V = hn::Vec<D>;
    const V one = hn::Set(d, 1.0f), half = hn::Set(d, 0.5f), width = level.across.real;
    const V rows = level.down.real + level.down.real;
    const V row = y - rows * RoundDown(y / rows);
    const auto beyond = hn::Ge(row, level.down.real);
    const V column = x + hn::IfThenElseZero(beyond, RoundDown(width * half + half));
    return {column - width * RoundDown(column / width), hn::IfThenElse(beyond, rows - one - row, row), face};
  }

  template <class D>
  static HWY_INLINE FoldedPoint<D> point(D d, hn::Vec<D> u, hn::Vec<D> v, Ints<D> face) {
    using V = hn::Vec<D>;
    const V half = hn::Set(d, 0.5f), one = hn::Set(d, 1.0f), two = hn::Set(d, 2.0f);
    const V period = v - two * RoundDown(v * half);  // 0..2
    const auto beyond = hn::Gt(period, one);
    const V around = u + hn::IfThenElseZero(beyond, half);
    return {around - RoundDown(around), hn::IfThenElse(beyond, two - period, period), face};
  }

  template <class D>
  static HWY_INLINE PointRates<D> rates(D d, hn::Vec<D>, hn::Vec<D> v, Ints<D>) {
    using V = hn::Vec<D>;
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0f), two = hn::Set(d, 2.0f);
    const auto beyond = hn::Gt(v - two * RoundDown(v * hn::Set(d, 0.5f)), one);
    return {one, zero, zero, hn::IfThenElse(beyond, hn::Neg(one), one)};
  }
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_FOLDS_LAT_LONG_INL_H_
