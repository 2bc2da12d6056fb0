// SPDX-License-Identifier: MIT
// The sink of filters on textures of directions. Texels inside the image pass through; quads at its edges are folded.

#if defined(SHD_TEXTURE_DIRECTION_SINK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_DIRECTION_SINK_INL_H_
#undef SHD_TEXTURE_DIRECTION_SINK_INL_H_
#else
#define SHD_TEXTURE_DIRECTION_SINK_INL_H_
#endif

#include <hwy/highway.h>

#include "simd/round-inl.h"
#include "texture/domain/direction.h"
#include "texture/domain/fold-inl.h"
#include "texture/domain/project-inl.h"
#include "texture/filter/edge_weights-inl.h"
#include "texture/filter/random-inl.h"
#include "texture/filter/runner-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::RoundDown;
using simd::HWY_NAMESPACE::RoundUp;

/// Stream: the sink of the elements, a StreamSink or a PickSink.
template <class Stream = StreamSink>
class DirectionSink {
 public:
  static constexpr bool kTakesLines = false;
  using D = BatchTag;
  using V = hn::Vec<D>;
  using VI = Ints<D>;

  explicit DirectionSink(const FilterCall& call)
      : stream_(call),
        projection_(call.texture.projection),
        layer_units_(static_cast<int32_t>(call.texture.layout.layer_units)),
        traits_(TraitsOf(projection_)),
        smooth_(call.sampler.weights == Weights::kHermite) {}

  HWY_INLINE const Sampler& sampler() const { return stream_.sampler(); }
  /// Calls with rates compute no values: their elements at edges differ.
  HWY_INLINE bool has_rates() const { return stream_.has_rates(); }
  static constexpr bool bordered() { return false; }

  void begin(size_t first, bool scattered) { stream_.begin(first, scattered); }
  void flush() { stream_.flush(); }
  HWY_INLINE void finish() { stream_.finish(); }

  /// Begins a vector of lookups that picks with random bits.
  HWY_INLINE void start(D d, Bits<D> random) { stream_.start(d, random); }

  /// Begins a vector of lookups. `blur`: part of a texel's stretch that the lookups average, 0..1. `most`: the largest
  /// number of quads in place of one.
  HWY_INLINE void place(D d, const ProjectedBlock& points, size_t i, V blur, V most) {
    most_ = most;
    face_ = hn::BitCast(hn::RebindToSigned<D>(), hn::Load(hn::RebindToUnsigned<D>(), points.face + i));
    stretch_ = (hn::Load(d, points.stretch + i) - hn::Set(d, 1.0f)) * blur;
    stretched_ = !hn::AllTrue(d, hn::Le(stretch_, hn::Set(d, kParallelStep - 1.0f)));
  }

  template <class... AnyShare>
  HWY_INLINE void texel(D d, uint32_t op, const Level<D>& level, const TexelPlace<D>& texel, MaskOf<D> in,
                        const AnyShare&... share) {
    stream_.texel(d, op, level, texel, in, share...);
  }
  HWY_INLINE void texel(D d, uint32_t op, const Level<D>& level, VI x, VI y, MaskOf<D> in) {
    stream_.texel(d, op, level, x, y, in);
  }
  HWY_INLINE void merge(D d, V share) { stream_.merge(d, share); }

  HWY_INLINE void quad(D d, uint32_t op, const Level<D>& level, V u, V v) {
    quad(d, op, level, u, v, hn::Set(d, 1.0f));
  }
  HWY_INLINE void quad(D d, uint32_t op, const Level<D>& level, V u, V v, V share) {
    if (HWY_UNLIKELY(stretched_)) return along_parallel(d, op, level, u, v, share);
    one_quad(d, op, level, u, v, share);
  }

  /// Emits a row of bicubic: four texels of row y, of which the second one has column x. They may lie beyond edges.
  template <class AnyShare>
  HWY_INLINE void cubic_row(D d, uint32_t op, const Level<D>& level, V x, V y, const RowShares<D>& shares,
                            const AnyShare& share) {
    const V one = hn::Set(d, 1.0f), two = hn::Set(d, 2.0f), zero = hn::Zero(d);
    const auto across = hn::And(hn::Ge(x, one), hn::Lt(x + two, level.across.real));
    auto inside = hn::And(across, hn::And(hn::Ge(y, zero), hn::Lt(y, level.down.real)));
    if (traits_.is_disc) {
      const V last = level.across.real - one, q = y + y - last;
      const V p = hn::Max(last - (x + x) + two, (x + x) + two + two - last);
      inside = hn::And(inside, hn::Le(p * p + q * q, level.across.real * level.across.real));
    }
    if (HWY_UNLIKELY(!hn::AllTrue(d, inside))) {
      TexelPlace<D> texel[4];
      fold_row(d, level, x, y, texel);
      return stream_.row_of(d, op, level, texel, shares, share);
    }
    const hn::RebindToSigned<D> di;
    const VI second = ToInt(x), next = hn::Set(di, 1);
    Row<D> row;
    for (size_t k = 0; k < 3; ++k) row.share[k] = shares.share[k], row.rate[k] = shares.rate[k];
    row.column[0] = second, row.column[1] = second + next, row.column[2] = second - next;
    row.column[3] = second + next + next;
    row.y = ToInt(y);
    row.in[0] = row.in[1] = row.in[2] = row.in[3] = inside;
    row.neighbours = true;
    stream_.row(d, op, level, row, share);
  }

  /// The texel whose direction is that of the centre of texel (x, y), which may lie outside the image.
  HWY_INLINE TexelPlace<D> folded(D d, const Level<D>& level, V x, V y) const {
    const V zero = hn::Zero(d);
    auto inside = hn::And(hn::And(hn::Ge(x, zero), hn::Lt(x, level.across.real)),
                          hn::And(hn::Ge(y, zero), hn::Lt(y, level.down.real)));
    if (traits_.is_disc) {
      const V last = level.across.real - hn::Set(d, 1.0f), p = x + x - last, q = y + y - last;
      inside = hn::And(inside, hn::Le(p * p + q * q, level.across.real * level.across.real));
    }
    if (HWY_LIKELY(hn::AllTrue(d, inside))) return place_of(d, level, {x, y, face_});
    return folded_at_edge(d, level, x, y, inside);
  }

 private:
  /// Points of a level before the fold.
  struct Taps {
    V x, y;  // first column and first row, whole numbers
    V s, t;
    V rate_s, rate_t;  // ds/du and dt/dv
    VI face;
  };

  HWY_INLINE Taps TapsAt(D d, const Level<D>& level, V u, V v, VI face) const {
    const V half = hn::Set(d, 0.5f), below_one = hn::Set(d, 0x1.fffffep-1f);
    const V x = u * level.across.real - half, y = v * level.down.real - half;
    const V left = RoundDown(x), top = RoundDown(y);
    const V s = hn::Min(x - left, below_one), t = hn::Min(y - top, below_one);
    if (HWY_UNLIKELY(smooth_)) return SmoothTaps(d, level, {left, top, s, t, s, t, face});
    return {left, top, s, t, level.across.real, level.down.real, face};
  }

  /// Makes the weights of linear taps smooth.
  HWY_NOINLINE static Taps SmoothTaps(D d, const Level<D>& level, const Taps& taps) {
    LinearTaps<D> x = {}, y = {};
    x.s = taps.s, x.rate = level.across.real;
    y.s = taps.t, y.rate = level.down.real;
    SmoothWeights(d, &x);
    SmoothWeights(d, &y);
    return {taps.x, taps.y, x.s, y.s, x.rate, y.rate, taps.face};
  }

  /// Lanes whose four texels lie inside the image.
  HWY_INLINE MaskOf<D> are_inside(D d, const Level<D>& level, const Taps& taps) const {
    const V two = hn::Set(d, 2.0f), zero = hn::Zero(d);
    const auto across = hn::And(hn::Ge(taps.x, zero), hn::Le(taps.x, level.across.real - two));
    const auto down = hn::And(hn::Ge(taps.y, zero), hn::Le(taps.y, level.down.real - two));
    const auto inside = hn::And(across, down);
    if (HWY_LIKELY(!traits_.is_disc)) return inside;
    // The texel farthest from the centre lies in the disc.
    const V last = level.across.real - hn::Set(d, 1.0f);
    const V p = hn::Max(last - (taps.x + taps.x), (taps.x + taps.x) + two - last);
    const V q = hn::Max(last - (taps.y + taps.y), (taps.y + taps.y) + two - last);
    return hn::And(inside, hn::Le(p * p + q * q, level.across.real * level.across.real));
  }

  HWY_INLINE TexelPlace<D> place_of(D, const Level<D>& level, const FoldedTexel<D>& texel) const {
    const hn::RebindToSigned<D> di;
    return {ToInt(texel.x), ToInt(texel.y), (texel.face - face_) * hn::Set(di, layer_units_) + level.offset};
  }

  HWY_INLINE void one_quad(D d, uint32_t op, const Level<D>& level, V u, V v, V share) {
    const Taps taps = TapsAt(d, level, u, v, face_);
    if (HWY_UNLIKELY(!hn::AllTrue(d, are_inside(d, level, taps)))) return at_edge(d, op, level, u, v, share);
    const hn::RebindToSigned<D> di;
    const auto in = hn::Eq(u, u);
    const VI x = ToInt(taps.x), y = ToInt(taps.y), one = hn::Set(di, 1);
    const LinearTaps<D> across = {taps.s, taps.rate_s, x, x + one, in, in};
    const LinearTaps<D> down = {taps.t, taps.rate_t, y, y + one, in, in};
    stream_.quad(d, op, level, across, down, share);
  }

  HWY_NOINLINE TexelPlace<D> folded_at_edge(D d, const Level<D>& level, V x, V y, MaskOf<D> inside) const {
    const V zero = hn::Zero(d), half = hn::Set(d, 0.5f), one = hn::Set(d, 1.0f);
    const V width = level.across.real, height = level.down.real;
    const FoldedPoint<D> point = FoldPoint(d, projection_, (x + half) / width, (y + half) / height, face_);
    FoldedTexel<D> texel = {hn::Min(RoundDown(point.u * width), width - one),
                            hn::Min(RoundDown(point.v * height), height - one), point.face};
    if (traits_.is_disc) texel = DiscFold::texel(d, level, x, y, face_);
    return place_of(
        d, level,
        {hn::IfThenElse(inside, x, hn::Max(texel.x, zero)), hn::IfThenElse(inside, y, hn::Max(texel.y, zero)),
         hn::IfThenElse(hn::RebindMask(hn::RebindToSigned<D>(), inside), face_, texel.face)});
  }

  /// The quad of lookups that may touch an edge, in any lane.
  HWY_NOINLINE void at_edge(D d, uint32_t op, const Level<D>& level, V u, V v, V share) {
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
    FoldedPoint<D> at = {u, v, face_};
    const auto beside = hn::Or(hn::Or(hn::Lt(u, zero), hn::Gt(u, one)), hn::Or(hn::Lt(v, zero), hn::Gt(v, one)));
    const auto outside = traits_.is_disc ? hn::Eq(u, u) : beside;  // FoldPoint() keeps points inside the disc
    if (!hn::AllFalse(d, outside)) {
      const FoldedPoint<D> inner = FoldPoint(d, projection_, u, v, face_);
      at = {hn::IfThenElse(outside, inner.u, u), hn::IfThenElse(outside, inner.v, v),
            hn::IfThenElse(hn::RebindMask(hn::RebindToSigned<D>(), outside), inner.face, face_)};
    }
    const Taps taps = TapsAt(d, level, at.u, at.v, at.face);
    if (HWY_UNLIKELY(has_rates())) {
      const auto inside = are_inside(d, level, TapsAt(d, level, u, v, face_));
      return rated_at_edge(d, op, level, at.u, taps, rates_at(d, u, v, outside), inside, share);
    }
    TexelPlace<D> quad[4];
    const bool is_plain = WithFold(projection_, [&](auto fold) SHD_INLINE_LAMBDA {
      using F = decltype(fold);
      fold_quad(d, fold, level, taps, quad);
      if constexpr (F::kTurnsAtPoles) at_pole(d, fold, op, level, at.u, taps, quad, share);
      if constexpr (F::kLacksCorners) at_corner(d, fold, op, level, taps, quad, share);
      return !F::kTurnsAtPoles && !F::kLacksCorners;
    });
    if (is_plain) stream_.quad_of(d, op, level, quad, taps.s, taps.t, share);
  }

  /// Derivatives of the point of a quad after the fold.
  HWY_INLINE PointRates<D> rates_at(D d, V u, V v, MaskOf<D> outside) const {
    const V one = hn::Set(d, 1.0f), zero = hn::Zero(d);
    if (hn::AllFalse(d, outside)) return {one, zero, zero, one};
    const PointRates<D> folded = FoldRates(d, projection_, u, v, face_);
    return {hn::IfThenElse(outside, folded.u_u, one), hn::IfThenElse(outside, folded.u_v, zero),
            hn::IfThenElse(outside, folded.v_u, zero), hn::IfThenElse(outside, folded.v_v, one)};
  }

  /// at_edge() with derivatives: the same texels and weights as at_pole(), at_corner() or a quad. Lanes whose quad lies
  /// `inside` have that quad, so that results do not depend on the other lanes.
  HWY_NOINLINE void rated_at_edge(D d, uint32_t op, const Level<D>& level, V u, const Taps& taps,
                                  const PointRates<D>& rates, MaskOf<D> inside, V share) {
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
    const QuadFractions<D> at(rates, taps);
    const Share<D> all = {one, zero, zero}, none = {zero, zero, zero};
    const bool starts = (op & kHow) == kStart;
    const V last_x = level.across.real - one, last_y = level.down.real - one;
    const VI x = ToInt(hn::Min(hn::Max(taps.x, zero), last_x)), y = ToInt(hn::Min(hn::Max(taps.y, zero), last_y));
    const VI next_x = ToInt(hn::Min(taps.x + one, last_x)), next_y = ToInt(hn::Min(taps.y + one, last_y));
    const LinearTaps<D> across = {taps.s, taps.rate_s, x, next_x, inside, inside};
    const LinearTaps<D> down = {taps.t, taps.rate_t, y, next_y, inside, inside};
    stream_.quad(d, op, level, across, down, starts ? share : hn::IfThenElseZero(inside, share));
    TexelPlace<D> quad[4];
    WeightedTexels<D> texels;
    const auto top = hn::Lt(taps.y, zero), bottom = hn::Ge(taps.y, last_y);
    WithFold(projection_, [&](auto fold) SHD_INLINE_LAMBDA {
      fold_quad(d, fold, level, taps, quad);
      if constexpr (decltype(fold)::kTurnsAtPoles) {
        const Share<D> beyond = SelectShare<D>(top, Complement(d, at.t), SelectShare<D>(bottom, at.t, none));
        texels.add(d, quad, at.s, at.t, Complement(d, beyond));
        const Taps other = opposite_of(d, level, u, taps);
        fold_quad(d, fold, level, other, quad);
        texels.add(d, quad, QuadFractions<D>(rates, other).s, at.t, beyond);
      }
    });
    if (!traits_.turns_at_poles) texels.add(d, quad, at.s, at.t, all);
    if (traits_.lacks_corners) {
      const auto left = hn::Lt(taps.x, zero), right = hn::Ge(taps.x, level.across.real - one);
      const MaskOf<D> corner[4] = {hn::And(left, top), hn::And(right, top), hn::And(left, bottom),
                                   hn::And(right, bottom)};
      WithFold(projection_, [&](auto fold) SHD_INLINE_LAMBDA {
        const auto lacks = fold.lacks_corner(d, taps.face, left, top);
        for (size_t k = 0; k < 4; ++k) texels.share_out(d, k, hn::And(corner[k], lacks));
      });
    }
    const V replaced = starts ? hn::Set(d, kWhole) : share;
    texels.emit(d, op & kSecond, level, hn::IfThenZeroElse(inside, replaced), stream_);
  }

  HWY_NOINLINE void fold_row(D d, const Level<D>& level, V x, V y, TexelPlace<D> (&row)[4]) const {
    constexpr float kOrder[4] = {0, 1, -1, 2};
    WithFold(projection_, [&](auto fold) SHD_INLINE_LAMBDA {
      for (int k = 0; k < 4; ++k) {
        row[k] = place_of(d, level, fold.far_texel(d, level, x + hn::Set(d, kOrder[k]), y, face_));
      }
    });
  }

  /// The texels of a quad by the fold F.
  template <class F>
  HWY_INLINE void fold_quad(D d, const F& fold, const Level<D>& level, const Taps& taps,
                            TexelPlace<D> (&quad)[4]) const {
    const V one = hn::Set(d, 1.0f);
    for (int k = 0; k < 4; ++k) {
      const V x = k % 2 ? taps.x + one : taps.x, y = k / 2 ? taps.y + one : taps.y;
      quad[k] = place_of(d, level, fold.texel(d, level, x, y, taps.face));
    }
  }

  /// A share without the mark of kReplace.
  HWY_INLINE static V Plain(D d, V share) { return hn::Min(share, hn::Set(d, 1.0f)); }

  /// The quad of a row at u + 1/2.
  HWY_INLINE Taps opposite_of(D d, const Level<D>& level, V u, const Taps& taps) const {
    const V half = hn::Set(d, 0.5f), turned = u + half;
    Taps other = TapsAt(d, level, turned - RoundDown(turned), half, taps.face);
    other.y = taps.y;
    return other;
  }

  /// A row beyond a pole is the row beside it at u + 1/2. It is a quad of its own: if the width is odd, its columns lie
  /// between those of the row. `quad`: the folded texels.
  template <class F>
  HWY_INLINE void at_pole(D d, const F& fold, uint32_t op, const Level<D>& level, V u, const Taps& taps,
                          TexelPlace<D> (&quad)[4], V share) {
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0f), last = level.down.real - one;
    const auto north = hn::Lt(taps.y, zero), pole = hn::Or(north, hn::Ge(taps.y, last));
    if (hn::AllFalse(d, pole)) return stream_.quad_of(d, op, level, quad, taps.s, taps.t, share);
    // Both rows of the quad are the row beside the pole: first with this meridian, then with the opposite one.
    const V opposite = hn::IfThenElseZero(pole, hn::IfThenElse(north, one - taps.t, taps.t));
    const V plain = (op & kHow) == kStart ? one : Plain(d, share);
    const auto whole = hn::Gt(share, one);
    const V first = plain * (one - opposite) / (one - plain * opposite);
    stream_.quad_of(d, op, level, quad, taps.s, taps.t, hn::IfThenElse(whole, share, first));
    const Taps other = opposite_of(d, level, u, taps);
    fold_quad(d, fold, level, other, quad);
    stream_.quad_of(d, kBlend | (op & kSecond), level, quad, other.s, taps.t, plain * opposite);
  }

  /// The weight of the texel that is missing at a corner goes to the other three in equal parts (Direct3D 11.3
  /// functional specification, 7.18.12): the average of the three is a row in place of the quad. `quad`: the folded
  /// texels.
  template <class F>
  HWY_INLINE void at_corner(D d, const F& fold, uint32_t op, const Level<D>& level, const Taps& taps,
                            const TexelPlace<D> (&quad)[4], V share) {
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0f), last = level.across.real - one;
    const auto left = hn::Lt(taps.x, zero), right = hn::Ge(taps.x, last);
    const auto top = hn::Lt(taps.y, zero), bottom = hn::Ge(taps.y, last);
    const auto any = hn::And(hn::Or(left, right), hn::Or(top, bottom));
    const auto corner = hn::And(any, fold.lacks_corner(d, taps.face, left, top));
    if (HWY_LIKELY(hn::AllFalse(d, corner))) return stream_.quad_of(d, op, level, quad, taps.s, taps.t, share);
    const uint32_t how = op & kHow;
    stream_.quad_of(d, op, level, quad, taps.s, taps.t, how == kStart ? share : hn::IfThenZeroElse(corner, share));
    // Texels and weights in the order: on the face, beside it across, beside it down. The fourth is missing. A face of
    // one texel is beside itself on both sides; its left and top neighbours then count.
    const hn::RebindToSigned<D> di;
    const auto swap_x = hn::RebindMask(di, left), swap_y = hn::RebindMask(di, top);
    const auto pick_of = [&](VI a, VI b, VI c, VI e) SHD_INLINE_LAMBDA {
      return hn::IfThenElse(swap_y, hn::IfThenElse(swap_x, e, c), hn::IfThenElse(swap_x, b, a));
    };
    const auto pick = [&](size_t a, size_t b, size_t c, size_t e) SHD_INLINE_LAMBDA {
      return TexelPlace<D>{pick_of(quad[a].x, quad[b].x, quad[c].x, quad[e].x),
                           pick_of(quad[a].y, quad[b].y, quad[c].y, quad[e].y),
                           pick_of(quad[a].first, quad[b].first, quad[c].first, quad[e].first)};
    };
    const V s = hn::IfThenElse(left, one - taps.s, taps.s), t = hn::IfThenElse(top, one - taps.t, taps.t);
    const V third = s * t * hn::Set(d, 1.0f / 3.0f);
    const V own = (one - s) * (one - t) + third, across = s * (one - t) + third, down = (one - s) * t + third;
    const TexelPlace<D> own_texel = pick(0, 1, 2, 3);
    const TexelPlace<D> row[4] = {own_texel, pick(1, 0, 3, 2), pick(2, 3, 0, 1), own_texel};
    const RowShares<D> shares = {{across / (own + across), down, zero}, {zero, zero, zero}};
    const V replaced = how == kStart ? hn::Set(d, kWhole) : share;
    stream_.row_of(d, (how == kStart ? uint32_t{kReplace} : how) | (op & kSecond), level, row, shares,
                   hn::IfThenElseZero(corner, replaced));
  }

  /// LAT_LONG near a pole: texels are narrower than they are high. Quads along the parallel together are as wide as a
  /// texel on the equator.
  HWY_NOINLINE void along_parallel(D d, uint32_t op, const Level<D>& level, V u, V v, V share) {
    const V one = hn::Set(d, 1.0f), half = hn::Set(d, 0.5f);
    const V extent = hn::Min(stretch_, level.across.real);  // [texels]
    const V count = hn::Max(hn::Min(RoundUp((extent + one) * hn::Set(d, 1.0f / kParallelStep)), most_), one);
    const auto single = hn::Eq(count, one);
    const V width = extent / level.across.real, step = width / count, begin = u - half * width;
    const float steps = hn::GetLane(hn::MaxOfLanes(d, count));
    const V plain = (op & kHow) == kStart ? one : Plain(d, share);
    for (float k = 0.0f; k < steps; k += 1.0f) {
      const V place = begin + (hn::Set(d, k) + half) * step, fraction = place - RoundDown(place);
      const V part = plain / (count * (one - plain) + plain * hn::Set(d, k + 1.0f));
      const V first = hn::IfThenElse(hn::Or(single, hn::Gt(share, one)), share, part);
      const V later = hn::IfThenElseZero(hn::Lt(hn::Set(d, k), count), part);
      one_quad(d, k == 0.0f ? op : kBlend | (op & kSecond), level, hn::IfThenElse(single, u, fraction), v,
               k == 0.0f ? first : later);
    }
  }

  Stream stream_;
  const shd_projection projection_;
  const int32_t layer_units_;
  const FoldTraits traits_;
  const bool smooth_;  // weights are those of SHD_FILTER_HERMITE
  bool stretched_ = false;
  VI face_ = hn::Zero(hn::RebindToSigned<D>());
  V stretch_ = hn::Zero(D()), most_ = hn::Zero(D());
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_DIRECTION_SINK_INL_H_
