// SPDX-License-Identifier: MIT
#include "texture/stream.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/filter/bicubic.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/filter/bases-inl.h"
#include "texture/filter/cubic-inl.h"
#include "texture/filter/filters-inl.h"
#include "texture/filter/runner-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

struct Bicubic : OnBaseLevel {
  using OnBaseLevel::OnBaseLevel;

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const PointBlock& block, size_t i, Sink& sink) const {
    constexpr int kOrder[4] = {1, 2, 0, 3};  // the middle taps first, so that sums of weights stay positive
    const Level<D> base = level(d, block, i);
    const CubicTaps<D> x = WrapCubic(d, sampler.wrap_u, hn::Load(d, block.u + i), base.across);
    const CubicTaps<D> y = WrapCubic(d, sampler.wrap_v, hn::Load(d, block.v + i), base.down);
    const CubicSteps<D> across = StepsOf(d, sampler.cubic, x.s, x.rate), down = StepsOf(d, sampler.cubic, y.s, y.rate);
    for (int r = 0; r < 4; ++r) {
      const int row = kOrder[r];
      const uint32_t average = r == 0 ? 0 : kSecond;
      const auto first = RowIndex(d, base, y.index[row]);
      for (int c = 0; c < 4; ++c) {
        const int column = kOrder[c];
        const auto in = hn::And(x.in[column], y.in[row]);
        if (c == 0) {
          sink.texel(d, average | kStart | kNewLine, first + x.index[column], in);
        } else {
          sink.texel(d, average | kBlend, first + x.index[column], in,
                     Share<D>{across.step[c - 1], across.rate[c - 1], hn::Zero(d)});
        }
      }
      if (r > 0) sink.merge(d, Share<D>{down.step[r - 1], hn::Zero(d), down.rate[r - 1]});
    }
    sink.finish();
  }
};

}  // namespace

size_t RunBicubic(const FilterCall& call) {
  return Run<Bicubic>(call);
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
