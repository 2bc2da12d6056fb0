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

struct Bicubic : OnBaseLevel {
  using OnBaseLevel::OnBaseLevel;

  /// Never prefetches with 16 lanes: the gathers of a vector then keep memory as busy as prefetches would (13 % faster
  /// without prefetches on random places).
  static bool is_scattered(const Texture& texture, const PointBlock& block) {
    return hn::Lanes(BatchTag()) < 16 && OnBaseLevel::is_scattered(texture, block);
  }

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const PointBlock& block, size_t i, Sink& sink) const {
    constexpr int kOrder[4] = {1, 2, 0, 3};  // inner taps first, so that sums of weights stay positive
    const Level<D> base = level(d, block, i);
    const CubicTaps<D> x = WrapCubic(d, sampler.wrap_u, hn::Load(d, block.u + i), base.across);
    const CubicTaps<D> y = WrapCubic(d, sampler.wrap_v, hn::Load(d, block.v + i), base.down);
    const CubicSteps<D> across = StepsOf(d, sampler.cubic, x.s, x.rate, sink.has_rates());
    const CubicSteps<D> down = StepsOf(d, sampler.cubic, y.s, y.rate, sink.has_rates());
    const hn::RebindToSigned<D> di;
    const auto right =
        hn::And(hn::Eq(x.index[1], x.index[0] + hn::Set(di, 1)), hn::Eq(x.index[3], x.index[0] + hn::Set(di, 3)));
    const bool neighbours = hn::AllTrue(di, hn::And(right, hn::Eq(x.index[2], x.index[1] + hn::Set(di, 1))));
    for (int k = 0; k < 4; ++k) {
      Row<D> row;
      row.y = y.index[kOrder[k]];
      row.neighbours = neighbours;
      for (int c = 0; c < 4; ++c) {
        row.column[c] = x.index[kOrder[c]];
        row.in[c] = hn::And(x.in[kOrder[c]], y.in[kOrder[k]]);
      }
      for (int c = 0; c < 3; ++c) {
        row.share[c] = across.step[c];
        row.rate[c] = across.rate[c];
      }
      const int step = k == 0 ? 0 : k - 1;
      sink.row(d, k == 0 ? kStart : kBlend, base, row, Share<D>{down.step[step], hn::Zero(d), down.rate[step]});
    }
    sink.finish();
  }
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_BICUBIC_INL_H_
