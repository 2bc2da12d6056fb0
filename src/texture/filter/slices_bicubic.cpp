// SPDX-License-Identifier: MIT
// BICUBIC in 3D textures: the tensor product of the cubic kernel on three axes, 64 texels. Each slice is bicubic, as in
// 2D; the slices form a running average with the shares of cubic-inl.h, in which each slice is a second average.
#include "texture/stream.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/filter/slices_bicubic.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/filter/bicubic-inl.h"
#include "texture/filter/filters-inl.h"
#include "texture/filter/slices-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

struct TricubicInSlices : OnBaseSlices<PlaceBlock> {
  using OnBaseSlices::OnBaseSlices;

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const PlaceBlock& block, size_t i, Sink& sink) const {
    const auto u = hn::Load(d, block.u + i), v = hn::Load(d, block.v + i), w = hn::Load(d, block.w + i);
    const CubicGrid<D> grid(d, sampler, base.level, u, v, sink.has_rates());
    const CubicTaps<D> z = WrapCubic(d, sampler.wrap_w, w, base.deep);
    const CubicSteps<D> deep = StepsOf(d, sampler.cubic, z.s, z.rate, sink.has_rates());
    for (int k = 0; k < 4; ++k) {
      const int tap = kCubicOrder[k];
      grid.emit(d, k == 0 ? 0 : kSecond, SliceOf(d, base, z.index[tap]), sink, z.in[tap]);
      if (k != 0) sink.merge(d, DeepShare<D>{deep.step[k - 1], deep.rate[k - 1]});
    }
    sink.finish();
  }
};

}  // namespace

size_t RunTricubicInSlices(const FilterCall& call) {
  return Run<TricubicInSlices>(call);
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
