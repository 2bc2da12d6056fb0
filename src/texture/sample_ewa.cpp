// SPDX-License-Identifier: MIT
// Elliptical weighted average: the texels inside the footprint's ellipse on one level, under a Gaussian (Greene and
// Heckbert, "Creating Raster Omnimax Images from Multiple Perspective Views Using the Elliptical Weighted Average
// Filter", 1986; Heckbert, "Fundamentals of Texture Mapping and Image Warping", 1989, 3.5).
#include "texture/sample.h"

#include "core/simd_target.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/sample_ewa.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/ellipse-inl.h"
#include "texture/filter-inl.h"
#include "texture/kernel-inl.h"
#include "texture/walk-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Scattered lookups ask for memory so many rows ahead.
constexpr float kAhead = 3.0f;
constexpr size_t kNear = size_t{1} << 20;

/// The lookups of a second pass: what the first wrote stands in the columns of derivatives.
template <class F, bool kBorder>
struct Ewa {
  const Texture& texture;
  const Sampler& sampler;
  using B = Blend<F, kBorder>;

  /// Running averages of the wanted channels, and the sum of the weights with its derivatives.
  template <class D>
  struct Average {
    using Value = typename B::template Value<D>;
    Value value[4];
    hn::Vec<D> total, total_u, total_v;

    template <size_t C>
    HWY_INLINE Value of() const {
      return value[C];
    }
  };

  /// A weight and its derivatives in u and v.
  template <class D>
  struct Weight {
    hn::Vec<D> value, u, v;
  };

  /// Where an ellipse lies on its level; `any` is false where bilinear takes over.
  template <class D>
  struct Place {
    const Level<D>& level;
    TexelPoint<D> x, y;
    hn::Vec<D> shift, high, wide, per_high, per_wide;
    MaskOf<D> any;
  };

  /// The texels of one row that lie inside: `last` + 1 of them from `left` on, the first `dx` from the row's middle.
  template <class D>
  struct Row {
    hn::Vec<D> dy, height, left, dx, last;
  };

  template <class D>
  HWY_INLINE void operator()(D d, const Points<D>& p, const Texels& out, size_t i) const {
    using V = hn::Vec<D>;
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
    const EllipsePoint<D> e(d, texture, sampler, p);
    const Level<D>& level = e.level;
    Average<D> average = {};
    average.total = average.total_u = average.total_v = zero;
    const auto only = hn::Eq(e.bilinear, one);
    if (!hn::AllTrue(d, only)) {
      const V high = hn::IfThenElse(only, one, e.high), wide = hn::IfThenElse(only, one, e.wide);
      add_rows(d,
               Place<D>{level, PointOf(d, sampler.wrap_u, e.u, level.across.real),
                        PointOf(d, sampler.wrap_v, e.v, level.down.real), e.shift, high, wide, hn::Div(one, high),
                        hn::Div(one, wide), hn::Not(only)},
               out, &average);
    }
    if (!hn::AllTrue(d, hn::Eq(e.bilinear, zero))) {
      const Quad<F, D> quad = FetchQuad<F>(d, texture, sampler, level, e.u, e.v);
      join<0>(d, out, only, QuadValue<F, kBorder, D>{quad, sampler}, Weight<D>{e.bilinear, zero, zero}, &average);
    }
    StoreChannels<F, kBorder>(d, average, out, i);
  }

  /// The rows from the lowest of each lane to its highest.
  template <class D>
  HWY_INLINE void add_rows(D d, const Place<D>& p, const Texels& out, Average<D>* average) const {
    using V = hn::Vec<D>;
    const V half_height = hn::Sqrt(p.high);
    const V top = hn::Ceil(hn::Sub(p.y.x, half_height));
    const V bottom = hn::Floor(hn::Add(p.y.x, half_height));
    const V last = hn::IfThenElse(p.any, hn::Sub(bottom, top), hn::Set(d, -1.0f));
    if constexpr (!kIsGradient<F> && !std::is_same<F, Recorded>::value) {
      if (are_unlike(d, p)) return add_apart(d, p, top, last, out, average);
    }
    add_together(d, p, top, last, out, average);
  }

  /// Whether the lanes' ellipses fill little of the rectangle around all of them.
  template <class D>
  HWY_INLINE bool are_unlike(D d, const Place<D>& p) const {
    const float high = hn::GetLane(hn::MaxOfLanes(d, p.high)), wide = hn::GetLane(hn::MaxOfLanes(d, p.wide));
    return high * wide > 4.0f * hn::GetLane(hn::MaxOfLanes(d, hn::Mul(p.high, p.wide)));
  }

  /// Row r of every lane; those beyond `last` are empty.
  template <class D>
  HWY_INLINE Row<D> row_at(D d, const Place<D>& p, hn::Vec<D> top, hn::Vec<D> last, hn::Vec<D> r) const {
    using V = hn::Vec<D>;
    Row<D> row;
    row.dy = hn::Sub(hn::Add(top, r), p.y.x);
    row.height = hn::Mul(hn::Mul(row.dy, row.dy), p.per_high);
    const V middle = hn::Add(p.x.x, hn::Mul(p.shift, row.dy));
    const V rest = hn::Max(hn::Sub(hn::Set(d, 1.0f), row.height), hn::Zero(d));
    const V half_width = hn::Sqrt(hn::Mul(rest, p.wide));
    row.left = hn::Ceil(hn::Sub(middle, half_width));
    row.dx = hn::Sub(row.left, middle);
    const V right = hn::Floor(hn::Add(middle, half_width));
    row.last = hn::IfThenElse(hn::Ge(last, r), hn::Sub(right, row.left), hn::Set(d, -1.0f));
    return row;
  }

  /// Lanes in step, row by row: the shortest way for ellipses that are alike.
  template <class D>
  HWY_INLINE void add_together(D d, const Place<D>& p, hn::Vec<D> top, hn::Vec<D> last, const Texels& out,
                               Average<D>* average) const {
    const float most_rows = hn::GetLane(hn::MaxOfLanes(d, last));
    Walk<D> down(d, sampler.wrap_v, top, p.level.down);
    Walk<D> ahead = down;
    const bool scattered = is_scattered_now(d, p, down);
    for (float r = -kAhead; r <= most_rows; r += 1.0f) {
      if (scattered && r + kAhead <= most_rows) {
        prefetch(d, p, row_at(d, p, top, last, hn::Set(d, r + kAhead)).left, ahead, p.any);
        ahead.step(d);
      }
      if (r < 0.0f) continue;
      const Row<D> row = row_at(d, p, top, last, hn::Set(d, r));
      const float most_columns = hn::GetLane(hn::MaxOfLanes(d, row.last));
      Walk<D> across(d, sampler.wrap_u, row.left, p.level.across);
      for (float c = 0.0f; c <= most_columns; c += 1.0f) {
        add_tap(d, p, row, hn::Set(d, c), down, across, out, average);
        across.step(d);
      }
      down.step(d);
    }
  }

  /// Every lane at its own pace, for ellipses that lie across each other.
  template <class D>
  HWY_INLINE void add_apart(D d, const Place<D>& p, hn::Vec<D> top, hn::Vec<D> last, const Texels& out,
                            Average<D>* average) const {
    using V = hn::Vec<D>;
    const V one = hn::Set(d, 1.0f);
    V r = hn::Neg(one), column = hn::Neg(one);
    Walk<D> down(d, sampler.wrap_v, hn::Sub(top, one), p.level.down), ahead(d, sampler.wrap_v, top, p.level.down);
    Walk<D> across(d, sampler.wrap_u, p.x.x, p.level.across);
    Row<D> row = row_at(d, p, top, last, r);
    row.last = r;
    for (size_t k = 0; k < static_cast<size_t>(kAhead); ++k) {
      prefetch(d, p, row_at(d, p, top, last, hn::Set(d, static_cast<float>(k))).left, ahead, p.any);
      ahead.step(d);
    }
    for (;;) {
      column = hn::Add(column, one);
      across.step(d);
      const auto done = hn::Gt(column, row.last);
      if (!hn::AllFalse(d, done)) {
        if (hn::AllTrue(d, hn::And(done, hn::Ge(r, last)))) return;
        r = hn::Add(r, hn::IfThenElseZero(done, one));
        row = row_at(d, p, top, last, r);
        down.step_if(d, done);
        across.restart_if(d, done, row.left);
        column = hn::IfThenZeroElse(done, column);
      }
      add_tap(d, p, row, column, down, across, out, average);
    }
  }

  template <class D>
  SHD_KERNEL_PART void add_tap(D d, const Place<D>& p, const Row<D>& row, hn::Vec<D> column, const Walk<D>& down,
                               const Walk<D>& across, const Texels& out, Average<D>* average) const {
    using V = hn::Vec<D>;
    const V dx = hn::Add(row.dx, column);
    const V x = hn::Add(row.height, hn::Mul(hn::Mul(dx, dx), p.per_wide));
    const auto active = hn::And(hn::Ge(row.last, column), hn::Lt(x, hn::Set(d, 1.0f)));
    if (hn::AllFalse(d, active)) return;
    const V weight = hn::IfThenElseZero(active, WeightAt(d, x));
    const auto first = hn::And(active, hn::Eq(average->total, hn::Zero(d)));
    const Weight<D> share = share_of(d, p, row, dx, weight, active, average);
    MaskOf<D> in_x, in_y;
    const auto y = down.index(d, &in_y);
    const auto texel = F::fetch(d, texture, hn::Add(RowIndex(d, p.level, y), across.index(d, &in_x)));
    join<0>(d, out, first, TapValue<F, kBorder, D>{texel, hn::And(in_x, in_y), sampler}, share, average);
  }

  /// Whether the lanes read memory so far apart that they wait for it.
  template <class D>
  HWY_INLINE bool is_scattered_now(D d, const Place<D>& p, const Walk<D>& down) const {
    if (texture.texels.size() <= kNear) return false;
    MaskOf<D> in;
    const auto row = hn::ConvertTo(d, RowIndex(d, p.level, down.index(d, &in)));
    const auto distance = hn::Abs(hn::Sub(row, hn::Set(d, hn::GetLane(row))));
    const auto far = hn::Gt(distance, hn::Mul(hn::Set(d, 64.0f), p.level.across.real));
    return 2 * hn::CountTrue(d, far) > hn::Lanes(d);
  }

  /// Asks for the lines of eight texels from `left` on in some lanes.
  template <class D>
  HWY_INLINE void prefetch(D d, const Place<D>& p, hn::Vec<D> left, const Walk<D>& down, MaskOf<D> lanes) const {
    const hn::RebindToSigned<D> di;
    MaskOf<D> in;
    alignas(64) int32_t index[kMaxLanes];
    const Walk<D> across(d, sampler.wrap_u, left, p.level.across);
    const auto at = hn::Add(RowIndex(d, p.level, down.index(d, &in)), across.index(d, &in));
    hn::Store(hn::IfThenElse(hn::RebindMask(di, lanes), at, hn::Set(di, -1)), di, index);
    const size_t size = texel_size(texture);
    const uint8_t* texels = texture.texels.data();
    for (size_t k = 0; k < hn::Lanes(d); ++k) {
      if (index[k] < 0) continue;
      __builtin_prefetch(texels + static_cast<uint32_t>(index[k]) * size);
      __builtin_prefetch(texels + static_cast<uint32_t>(index[k] + 7) * size);
    }
  }

  /// Adds a weight; its share in the sum. With w' = -2 (w + exp(-2)) r^2' the share has the derivative
  /// (w' - share total') / total.
  template <class D>
  HWY_INLINE Weight<D> share_of(D d, const Place<D>& p, const Row<D>& row, hn::Vec<D> dx, hn::Vec<D> weight,
                                MaskOf<D> active, Average<D>* average) const {
    using V = hn::Vec<D>;
    average->total = hn::Add(average->total, weight);
    Weight<D> share;
    share.value = hn::IfThenElseZero(active, hn::Div(weight, average->total));
    share.u = share.v = hn::Zero(d);
    if constexpr (kIsGradient<F>) {
      const V four = hn::IfThenElseZero(active, hn::Set(d, 4.0f));
      const V slope = hn::Mul(four, hn::Add(weight, hn::Set(d, 0.135335283f)));
      const V along_x = hn::Mul(dx, p.per_wide);
      const V along_y = hn::Sub(hn::Mul(row.dy, p.per_high), hn::Mul(p.shift, along_x));
      const V weight_u = hn::Mul(hn::Mul(slope, along_x), p.x.rate);
      const V weight_v = hn::Mul(hn::Mul(slope, along_y), p.y.rate);
      average->total_u = hn::Add(average->total_u, weight_u);
      average->total_v = hn::Add(average->total_v, weight_v);
      const V rest_u = hn::Sub(weight_u, hn::Mul(share.value, average->total_u));
      const V rest_v = hn::Sub(weight_v, hn::Mul(share.value, average->total_v));
      share.u = hn::IfThenElseZero(active, hn::Div(rest_u, average->total));
      share.v = hn::IfThenElseZero(active, hn::Div(rest_v, average->total));
    }
    return share;
  }

  /// Blends a tap into the wanted channels from C on.
  template <size_t C, class D, class Tap>
  HWY_INLINE void join(D d, const Texels& out, MaskOf<D> first, const Tap& tap, const Weight<D>& share,
                       Average<D>* average) const {
    if (B::wanted(out, C)) {
      average->value[C] = B::join(d, first, average->value[C], tap.template of<C>(), share.value, share.u, share.v);
    }
    if constexpr (C < 3) join<C + 1>(d, out, first, tap, share, average);
  }
};

struct EwaKernel {
  template <class F>
  static size_t run(const Texture& texture, const Sampler& sampler, const Lookups& in, const Texels& out) {
    return ForEachEllipseBlock(texture, sampler, in, out,
                               [&](const Sampler& plain, const Lookups& block, const Texels& to) {
                                 ForEachPoint<Ewa, F>(texture, plain, block, to);
                               });
  }
};

FilterKernels EwaKernels() {
  return KernelsOf<EwaKernel, true>();
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::texture {
namespace {
HWY_EXPORT(EwaKernels);
}  // namespace

FilterKernels ewa_kernels(const core::SimdTarget& simd) {
  return SHD_DISPATCH(EwaKernels, simd)();
}

}  // namespace shd::texture
#endif
