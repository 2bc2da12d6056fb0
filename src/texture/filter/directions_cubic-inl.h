// SPDX-License-Identifier: MIT
// Bicubic on textures of directions. Texels beyond an edge are those on which the directions continue.

#if defined(SHD_TEXTURE_DIRECTION_CUBIC_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_DIRECTION_CUBIC_INL_H_
#undef SHD_TEXTURE_DIRECTION_CUBIC_INL_H_
#else
#define SHD_TEXTURE_DIRECTION_CUBIC_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/filter/bases-inl.h"
#include "texture/filter/cubic-inl.h"
#include "texture/filter/emitter-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

struct CubicDirections : OnBaseLevel {
  using OnBaseLevel::OnBaseLevel;

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const PointBlock& block, size_t i, Sink& sink) const {
    constexpr float kOrder[4] = {0, 1, -1, 2};  // as in Bicubic
    const Level<D> base = level(d, block, i);
    // The sink folds the texels: the taps are those of a plane without end.
    const CubicPoint<D> x = LocateCubic(d, SHD_WRAP_REPEAT, hn::Load(d, block.u + i), base.across);
    const CubicPoint<D> y = LocateCubic(d, SHD_WRAP_REPEAT, hn::Load(d, block.v + i), base.down);
    const CubicSteps<D> across = StepsOf(d, sampler.cubic, x.s, x.rate, sink.has_rates());
    const CubicSteps<D> down = StepsOf(d, sampler.cubic, y.s, y.rate, sink.has_rates());
    RowShares<D> shares;
    for (int c = 0; c < 3; ++c) shares.share[c] = across.step[c], shares.rate[c] = across.rate[c];
    for (int k = 0; k < 4; ++k) {
      const int step = k == 0 ? 0 : k - 1;
      sink.cubic_row(d, k == 0 ? kStart : kBlend, base, x.second, y.second + hn::Set(d, kOrder[k]), shares,
                     Share<D>{down.step[step], hn::Zero(d), down.rate[step]});
    }
    sink.finish();
  }
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_DIRECTION_CUBIC_INL_H_
