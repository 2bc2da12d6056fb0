// SPDX-License-Identifier: MIT
#if defined(SHD_TEXTURE_BICUBIC_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_BICUBIC_INL_H_
#undef SHD_TEXTURE_BICUBIC_INL_H_
#else
#define SHD_TEXTURE_BICUBIC_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/filter/bases-inl.h"
#include "texture/filter/cubic-inl.h"
#include "texture/filter/runner-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Order of taps: inner ones first, so that sums of weights stay positive.
constexpr int kCubicOrder[4] = {1, 2, 0, 3};

/// The 4 x 4 texels of levels of equal size around reduced coordinates.
template <class D>
struct CubicGrid {
  CubicTaps<D> x, y;
  CubicSteps<D> across, down;
  bool neighbours;  // columns are adjacent

  HWY_INLINE CubicGrid(D d, const Sampler& sampler, const Level<D>& level, hn::Vec<D> u, hn::Vec<D> v, bool has_rates)
      : x(WrapCubic(d, sampler.wrap_u, u, level.across)),
        y(WrapCubic(d, sampler.wrap_v, v, level.down)),
        across(StepsOf(d, sampler.cubic, x.s, x.rate, has_rates)),
        down(StepsOf(d, sampler.cubic, y.s, y.rate, has_rates)) {
    const hn::RebindToSigned<D> di;
    const auto right =
        hn::And(hn::Eq(x.index[1], x.index[0] + hn::Set(di, 1)), hn::Eq(x.index[3], x.index[0] + hn::Set(di, 3)));
    neighbours = hn::AllTrue(di, hn::And(right, hn::Eq(x.index[2], x.index[1] + hn::Set(di, 1))));
  }

  /// Emits the rows of a level as an average, the first one or with kSecond the second one. The texels of a level
  /// outside `in`, if given, are the border.
  template <class Sink, class... In>
  HWY_INLINE void emit(D d, uint32_t second, const Level<D>& level, Sink& sink, const In&... in) const {
    for (int k = 0; k < 4; ++k) {
      Row<D> row;
      row.y = y.index[kCubicOrder[k]];
      row.neighbours = neighbours;
      for (int c = 0; c < 4; ++c) {
        row.column[c] = x.index[kCubicOrder[c]];
        row.in[c] = hn::And(x.in[kCubicOrder[c]], y.in[kCubicOrder[k]]);
        ((row.in[c] = hn::And(row.in[c], in)), ...);
      }
      for (int c = 0; c < 3; ++c) {
        row.share[c] = across.step[c];
        row.rate[c] = across.rate[c];
      }
      const int step = k == 0 ? 0 : k - 1;
      sink.row(d, (k == 0 ? kStart : kBlend) | second, level, row,
               Share<D>{down.step[step], hn::Zero(d), down.rate[step]});
    }
  }
};

struct Bicubic : OnBaseLevel {
  using OnBaseLevel::OnBaseLevel;

  /// Never prefetches with 16 lanes: the gathers of a vector then keep memory as busy as prefetches would (13 % faster
  /// without prefetches on random places).
  static bool is_scattered(const Texture& texture, const PointBlock& block) {
    return hn::Lanes(BatchTag()) < 16 && OnBaseLevel::is_scattered(texture, block);
  }

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const PointBlock& block, size_t i, Sink& sink) const {
    const Level<D> base = level(d, block, i);
    const auto u = hn::Load(d, block.u + i), v = hn::Load(d, block.v + i);
    CubicGrid<D>(d, sampler, base, u, v, sink.has_rates()).emit(d, 0, base, sink);
    sink.finish();
  }
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_BICUBIC_INL_H_
