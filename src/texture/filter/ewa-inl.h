// SPDX-License-Identifier: MIT
// Elliptical weighted average (EWA): the average of the texels inside the ellipse of the footprint on one level, with
// Gaussian weights (Greene and Heckbert, "Creating Raster Omnimax Images from Multiple Perspective Views Using the
// Elliptical Weighted Average Filter", 1986; Heckbert, "Fundamentals of Texture Mapping and Image Warping", 1989, 3.5).

#if defined(SHD_TEXTURE_EWA_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_EWA_INL_H_
#undef SHD_TEXTURE_EWA_INL_H_
#else
#define SHD_TEXTURE_EWA_INL_H_
#endif

#include <type_traits>

#include <hwy/highway.h>

#include "simd/round-inl.h"
#include "texture/filter/ellipse-inl.h"
#include "texture/filter/runner-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::RoundDown;
using simd::HWY_NAMESPACE::RoundUp;

/// The slice of an EllipseWalk in 2D: the whole ellipse.
struct WholeEllipse {
  static constexpr bool kSolid = false;
};

/// Visits the texels in one vector of ellipses, and sums their weights. An axis without kFolds wraps its positions. The
/// sink folds the positions of others, and may skip columns: it reads every stride-th one. A slice with kSolid is one
/// of an ellipsoid, whose texels in all slices form one average.
template <class D, class Axis = Walk<D>, class Slice = WholeEllipse>
struct EllipseWalk {
  using V = hn::Vec<D>;

  /// The texels of one row that lie inside: columns left..left + last. `dx` is the distance of `left` from the middle
  /// of the row, `dy` is the distance of the row from the centre, and `height` is the part of r^2 that comes from dy.
  struct Row {
    V dy, height, left, dx, last;
  };

  const Sampler& sampler;
  Ellipse<D> ellipse;
  V per_height2, per_width2;
  V top, last;                // rows top..top + last; last = -1: no row
  V total, total_u, total_v;  // sum of the weights, and its derivatives
  V stride;                   // columns from one texel to the next, with kFolds
  bool any = false;           // an element was emitted
  Slice slice;

  HWY_INLINE EllipseWalk(D d, const Texture& texture, const Sampler& of_sampler, const EllipseBlock& block, size_t i)
      : sampler(of_sampler), ellipse(d, texture, of_sampler, block, i) {
    const V one = hn::Set(d, 1.0f);
    per_height2 = one / ellipse.height2;
    per_width2 = one / ellipse.width2;
    total = total_u = total_v = hn::Zero(d);
    stride = one;
    set_rows(d, hn::Sqrt(ellipse.height2), ellipse.is_quad);
  }

  /// Sets the rows. `empty` lanes have no rows.
  HWY_INLINE void set_rows(D d, V half_height, MaskOf<D> empty) {
    top = RoundUp(ellipse.y.x - half_height);
    const V bottom = RoundDown(ellipse.y.x + half_height);
    last = hn::IfThenElse(empty, hn::Set(d, -1.0f), bottom - top);
  }

  /// Returns whether the ellipses differ: the rectangle of the greatest height and the greatest row width of all lanes
  /// is more than twice as large as that of any single lane.
  HWY_INLINE bool are_unlike(D d) const {
    const float height2 = hn::GetLane(hn::MaxOfLanes(d, ellipse.height2));
    const float width2 = hn::GetLane(hn::MaxOfLanes(d, ellipse.width2));
    return height2 * width2 > 4.0f * hn::GetLane(hn::MaxOfLanes(d, ellipse.height2 * ellipse.width2));
  }

  /// Returns row r of every lane. Rows beyond the last row of a lane are empty.
  HWY_INLINE Row row_at(D d, V r) const {
    Row row;
    row.dy = top + r - ellipse.y.x;
    row.height = row.dy * row.dy * per_height2;
    if constexpr (Slice::kSolid) row.height = row.height + slice.height;
    const V middle = ellipse.x.x + ellipse.shear * row.dy;
    const V rest = hn::Max(hn::Set(d, 1.0f) - row.height, hn::Zero(d));
    const V half_width = hn::Sqrt(rest * ellipse.width2);
    row.left = RoundUp(middle - half_width);
    const V right = RoundDown(middle + half_width);
    V columns = right - row.left;
    if constexpr (Axis::kFolds) {
      const V steps = RoundDown(columns / stride), spare = columns - steps * stride;
      row.left = row.left + RoundDown(hn::Max(spare, hn::Zero(d)) * hn::Set(d, 0.5f));
      columns = steps;
    }
    row.dx = row.left - middle;
    row.last = hn::IfThenElse(hn::Ge(last, r), columns, hn::Set(d, -1.0f));
    return row;
  }

  /// Emits the texels; `unlike`: are_unlike().
  template <class Sink>
  HWY_INLINE void emit(D d, bool unlike, Sink& sink) {
    if (unlike && !sink.has_rates()) {
      emit_apart(d, sink);
    } else {
      emit_together(d, sink);
    }
  }

  /// Emits the texels row by row, with all lanes in step. This takes the fewest steps for similar ellipses.
  template <class Sink>
  HWY_INLINE void emit_together(D d, Sink& sink) {
    const float max_row = hn::GetLane(hn::MaxOfLanes(d, last));
    Axis down(d, sampler.wrap_v, top, ellipse.level.down);
    for (float r = 0.0f; r <= max_row; r += 1.0f) {
      const Row row = row_at(d, hn::Set(d, r));
      const float max_column = hn::GetLane(hn::MaxOfLanes(d, row.last));
      Axis across(d, sampler.wrap_u, row.left, ellipse.level.across);
      uint32_t flags = kNewLine;
      for (float c = 0.0f; c <= max_column; c += 1.0f) {
        if (emit_texel(d, row, hn::Set(d, c), down, across, flags, sink)) flags = 0;
        step_across(d, &across);
      }
      down.step(d);
    }
  }

  /// Emits the texels with each lane at its own row and column, for ellipses of different orientation.
  template <class Sink>
  HWY_INLINE void emit_apart(D d, Sink& sink) {
    const V one = hn::Set(d, 1.0f);
    V r = hn::Neg(one), column = hn::Neg(one);
    Axis down(d, sampler.wrap_v, top - one, ellipse.level.down);
    Axis across(d, sampler.wrap_u, ellipse.x.x, ellipse.level.across);
    Row row = row_at(d, r);
    row.last = r;
    for (;;) {
      column = column + one;
      step_across(d, &across);
      uint32_t flags = 0;
      const auto done = hn::Gt(column, row.last);
      if (!hn::AllFalse(d, done)) {
        if (hn::AllTrue(d, hn::And(done, hn::Ge(r, last)))) return;
        r = r + hn::IfThenElseZero(done, one);
        row = row_at(d, r);
        down.step_if(d, done);
        across.restart_if(d, done, row.left);
        column = hn::IfThenZeroElse(done, column);
        flags = kNewLine;
      }
      emit_texel(d, row, column, down, across, flags, sink);
    }
  }

  /// Emits the first texel of every row, for a sink that prefetches.
  template <class Sink>
  HWY_INLINE void emit_rows(D d, Sink& sink) {
    const float max_row = hn::GetLane(hn::MaxOfLanes(d, last));
    Walk<D> down(d, sampler.wrap_v, top, ellipse.level.down);
    for (float r = 0.0f; r <= max_row; r += 1.0f) {
      const Row row = row_at(d, hn::Set(d, r));
      const Walk<D> across(d, sampler.wrap_u, row.left, ellipse.level.across);
      MaskOf<D> in_x, in_y;
      const auto y = down.index(d, &in_y), x = across.index(d, &in_x);
      sink.texel(d, kNewLine, ellipse.level, x, y, hn::And(in_x, in_y));
      down.step(d);
    }
  }

  /// Emits texel `column` of a row. Returns whether it lies in the ellipse of any lane.
  template <class Sink>
  HWY_INLINE bool emit_texel(D d, const Row& row, V column, const Axis& down, const Axis& across, uint32_t flags,
                             Sink& sink) {
    V dx = row.dx + column;
    if constexpr (Axis::kFolds) dx = row.dx + column * stride;
    const V x = row.height + dx * dx * per_width2;
    const auto active = hn::And(hn::Ge(row.last, column), hn::Lt(x, hn::Set(d, 1.0f)));
    if (hn::AllFalse(d, active)) return false;
    const V weight = hn::IfThenElseZero(active, WeightAt(d, x));
    const auto first = hn::And(active, hn::Eq(total, hn::Zero(d)));
    Share<D> share = sink.has_rates() ? rated_share(d, row, dx, weight, active, sink) : plain_share(d, weight, active);
    share.value = hn::IfThenElse(first, hn::Set(d, kWhole), share.value);
    const bool starts = !hn::AllFalse(d, first);
    if constexpr (Axis::kFolds) {
      sink.texel(d, how(starts) | flags, ellipse.level, sink.folded(d, ellipse.level, across.at, down.at), active,
                 share);
    } else {
      MaskOf<D> in_x, in_y;
      const auto row_y = down.index(d, &in_y), column_x = across.index(d, &in_x);
      auto in = hn::And(in_x, in_y);
      if constexpr (Slice::kSolid) in = hn::And(in, slice.in);
      sink.texel(d, how(starts) | flags, ellipse.level, column_x, row_y, in, share);
    }
    return true;
  }

  HWY_INLINE void step_across(D d, Axis* across) const {
    if constexpr (Axis::kFolds)
      return across->step(d, stride);
    else
      return across->step(d);
  }

  /// Emits the bilinear lookup with its share.
  template <class Sink>
  HWY_INLINE void emit_quad(D d, Sink& sink) {
    const V share = hn::IfThenElse(ellipse.is_quad, hn::Set(d, kWhole), ellipse.bilinear);
    sink.quad(d, how(true), ellipse.level, ellipse.u, ellipse.v, share);
  }

  /// Returns the operation of the next element. `starts`: the average of some lane starts with this element.
  HWY_INLINE uint32_t how(bool starts) {
    const uint32_t how = !any ? kStart : starts ? kReplace : kBlend;
    any = true;
    return how;
  }

  HWY_INLINE Share<D> plain_share(D d, V weight, MaskOf<D> active) {
    total = total + weight;
    return {hn::IfThenElseZero(active, weight / total), hn::Zero(d), hn::Zero(d)};
  }

  /// Returns the share with its derivatives (w' - share total') / total, where w' = -2 (w + exp(-2)) (r^2)'.
  template <class Sink>
  HWY_INLINE Share<D> rated_share(D d, const Row& row, V dx, V weight, MaskOf<D> active, const Sink& sink) {
    Share<D> share = plain_share(d, weight, active);
    const V slope = hn::IfThenElseZero(active, hn::Set(d, 4.0f)) * (weight + hn::Set(d, 0.135335283f));
    const V along_x = dx * per_width2;
    const V along_y = row.dy * per_height2 - ellipse.shear * along_x;
    V weight_u = slope * along_x * ellipse.x.rate, weight_v = slope * along_y * ellipse.y.rate;
    if constexpr (Slice::kSolid) {
      if (sink.rates_in_w()) {
        weight_u = slope * slice.along(along_x, along_y);
        share.rates = kDeep;
      }
    }
    total_u = total_u + weight_u;
    total_v = total_v + weight_v;
    share.rate_u = hn::IfThenElseZero(active, (weight_u - share.value * total_u) / total);
    share.rate_v = hn::IfThenElseZero(active, (weight_v - share.value * total_v) / total);
    return share;
  }
};

struct Ewa {
  using Block = EllipseBlock;

  const Texture& texture;
  const Sampler& sampler;

  Ewa(const Texture& of_texture, const Sampler& of_sampler) : texture(of_texture), sampler(of_sampler) {}

  static bool is_scattered(const Texture& texture, const EllipseBlock& block) {
    return texture::is_scattered(texture, block, block.level);
  }

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const EllipseBlock& block, size_t i, Sink& sink) const {
    EllipseWalk<D> walk(d, texture, sampler, block, i);
    if constexpr (std::is_same_v<Sink, PrefetchSink>) return walk.emit_rows(d, sink);
    if (!hn::AllTrue(d, walk.ellipse.is_quad)) walk.emit(d, walk.are_unlike(d), sink);
    if (!hn::AllTrue(d, hn::Eq(walk.ellipse.bilinear, hn::Zero(d)))) walk.emit_quad(d, sink);
    sink.finish();
  }
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_EWA_INL_H_
