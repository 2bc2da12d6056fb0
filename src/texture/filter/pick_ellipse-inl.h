// SPDX-License-Identifier: MIT
// Random choice of one texel of an ellipse by the weights of the elliptical weighted average.

#if defined(SHD_TEXTURE_PICK_ELLIPSE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_PICK_ELLIPSE_INL_H_
#undef SHD_TEXTURE_PICK_ELLIPSE_INL_H_
#else
#define SHD_TEXTURE_PICK_ELLIPSE_INL_H_
#endif

#include <hwy/highway.h>

#include "simd/round-inl.h"
#include "texture/filter/ellipse-inl.h"
#include "texture/filter/pick-inl.h"
#include "texture/filter/random-inl.h"
#include "texture/filter/walk-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::RoundDown;
using simd::HWY_NAMESPACE::RoundUp;

/// The texels of an ellipse as lines. Lines are perpendicular to the axis, u or v, along which the ellipse is longer,
/// so an ellipse of any angle has many short lines. Lanes in step then visit few texels more than a single lane would.
/// With the shorter half axis b < 1.96 a line has at most 2 sqrt(2) b + 1 texels: six.
template <class D>
class EllipseLines {
 public:
  using V = hn::Vec<D>;

  /// Finds the lines of ellipses with the centre (x, y), in texels whose centres have integer coordinates. `least` is
  /// the least r^2 of their texels: 0, or that of a slice of an ellipsoid.
  HWY_INLINE EllipseLines(D d, V x, V y, V shear, V height2, V width2, V least) : least_(least) {
    const V one = hn::Set(d, 1.0f), two = hn::Set(d, 2.0f);
    const V across = width2 + shear * shear * height2;  // square of half the width of the ellipse
    by_column_ = hn::Gt(across, height2);
    const V turn = hn::IfThenElse(by_column_, height2 / across, one);
    along_ = hn::IfThenElse(by_column_, x, y);
    across_ = hn::IfThenElse(by_column_, y, x);
    shear_ = shear * turn;
    const V long_square = hn::IfThenElse(by_column_, across, height2), short_square = width2 * turn;
    per_long_ = one / long_square;
    per_short_ = one / short_square;
    const V half_length = hn::Sqrt(long_square);
    half_width_ = hn::Sqrt(short_square);
    first_ = RoundUp(along_ - half_length);
    lines_ = RoundDown(half_length * two) + one;
    texels_ = RoundDown(half_width_ * two) + one;
  }

  /// Returns the maximum number of lines of a lane.
  HWY_INLINE size_t lines(D d) const { return static_cast<size_t>(hn::GetLane(hn::MaxOfLanes(d, lines_))); }
  /// Returns the maximum number of texels of a line.
  HWY_INLINE float texels(D d) const { return hn::GetLane(hn::MaxOfLanes(d, texels_)); }

  struct Line {
    V square;  // part of r^2 from the distance between line and centre; 1 for lines beyond the last one
    V start;   // first texel of the line
    V offset;  // distance of the first texel from the middle of the line
  };
  HWY_INLINE Line line(D d, V k) const {
    const V one = hn::Set(d, 1.0f);
    const V distance = first_ + k - along_;
    const V middle = across_ + shear_ * distance;
    Line line;
    line.square = hn::IfThenElse(hn::Lt(k, lines_), least_ + distance * distance * per_long_, one);
    line.start = RoundUp(middle - half_width_);
    line.offset = line.start - middle;
    return line;
  }
  /// Returns the weight of texel k of a line. It is 0 beyond the last texel and outside the ellipse.
  HWY_INLINE V weight(D d, const Line& line, float k) const {
    const V one = hn::Set(d, 1.0f), at = hn::Set(d, k);
    const V offset = line.offset + at;
    const V square = line.square + offset * offset * per_short_;
    return WeightAt(d, hn::IfThenElse(hn::Lt(at, texels_), hn::Min(square, one), one));
  }
  /// Returns the coordinates of texel `texel` of line k.
  HWY_INLINE void locate(D d, V k, V texel, V* x, V* y) const {
    const V place = first_ + k, start = line(d, k).start + texel;
    *x = hn::IfThenElse(by_column_, place, start);
    *y = hn::IfThenElse(by_column_, start, place);
  }

 private:
  MaskOf<D> by_column_;
  V along_, across_, shear_, per_long_, per_short_, half_width_, first_, lines_, texels_, least_;
};

/// Number of groups of lines whose running sums are kept, so that the texel is found without a second walk over all
/// lines. The largest ellipse has 216 lines; so many sums would take too much stack.
constexpr size_t kGroups = 56;

/// Picks the first texel whose running sum of weights is above random times the sum of all weights. Such a texel always
/// exists, because random is below 1, and its weight is not 0.
template <class D>
HWY_INLINE void PickInEllipse(D d, const EllipseLines<D>& lines, hn::Vec<D> random, hn::Vec<D>* x, hn::Vec<D>* y) {
  using V = hn::Vec<D>;
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  const size_t lanes = hn::Lanes(d), count = lines.lines(d), in_group = (count + kGroups - 1) / kGroups;
  const float texels = lines.texels(d);
  alignas(64) float sums[kGroups * hn::MaxLanes(D())];
  V total = zero, k = zero;
  size_t groups = 0;
  for (size_t n = 0; n < count; n += in_group) {
    for (size_t i = 0; i < in_group; ++i) {
      const auto line = lines.line(d, k);
      for (float t = 0.0f; t < texels; t += 1.0f) total = total + lines.weight(d, line, t);
      k = k + one;
    }
    hn::Store(total, d, sums + lanes * groups++);
  }

  const V wanted = random * total, group = hn::Set(d, static_cast<float>(in_group));
  V sum = zero, texel = zero;
  k = zero;
  for (size_t n = 0; n < groups; ++n) {
    const V end = hn::Load(d, sums + lanes * n);
    const auto passed = hn::Ge(wanted, end);
    sum = hn::IfThenElse(passed, end, sum);
    k = k + hn::IfThenElseZero(passed, group);
  }
  for (size_t i = 0; i < in_group; ++i) {
    const auto line = lines.line(d, k);
    for (float t = 0.0f; t < texels; t += 1.0f) {
      sum = sum + lines.weight(d, line, t);
      texel = texel + hn::IfThenElseZero(hn::Ge(wanted, sum), one);
    }
    const auto passed = hn::Ge(wanted, sum);
    k = k + hn::IfThenElseZero(passed, one);
    texel = hn::IfThenZeroElse(passed, texel);
  }
  lines.locate(d, k, texel, x, y);
}

/// Picks the column and the row of one tap of an elliptical weighted average. The share of bilinear is the probability
/// of a bilinear tap; other taps are texels of the ellipse.
template <class D>
HWY_INLINE void PickEwa(D d, const Sampler& sampler, const Ellipse<D>& e, Rng<D>* rng, Pick<D>* x, Pick<D>* y) {
  using V = hn::Vec<D>;
  const hn::RebindToSigned<D> di;
  const auto bilinear = hn::Lt(rng->next(d), e.bilinear);
  const V first = rng->next(d), second = rng->next(d);
  *x = PickLinear(d, sampler.wrap_u, e.u, e.level.across, first);
  *y = PickLinear(d, sampler.wrap_v, e.v, e.level.down, second);
  if (hn::AllTrue(d, bilinear)) return;
  const V one = hn::Set(d, 1.0f);
  const EllipseLines<D> lines(d, e.x.x, e.y.x, hn::IfThenZeroElse(bilinear, e.shear),
                              hn::IfThenElse(bilinear, one, e.height2), hn::IfThenElse(bilinear, one, e.width2),
                              hn::Zero(d));
  V column, row;
  PickInEllipse(d, lines, first, &column, &row);
  MaskOf<D> in_x, in_y;
  const auto i = Walk<D>(d, sampler.wrap_u, column, e.level.across).index(d, &in_x);
  const auto j = Walk<D>(d, sampler.wrap_v, row, e.level.down).index(d, &in_y);
  const auto keeps = hn::RebindMask(di, bilinear);
  *x = {hn::IfThenElse(keeps, x->index, i), hn::Or(hn::And(bilinear, x->in), hn::AndNot(bilinear, in_x))};
  *y = {hn::IfThenElse(keeps, y->index, j), hn::Or(hn::And(bilinear, y->in), hn::AndNot(bilinear, in_y))};
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_PICK_ELLIPSE_INL_H_
