// SPDX-License-Identifier: MIT
// Nearest lookups with a linear blend of two levels, in 2D and in 3D.
#include "texture/stream.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/filter/nearest_mip_linear.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/filter/filters-inl.h"
#include "texture/filter/nearest_mip_linear-inl.h"
#include "texture/filter/slices-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

struct NearestMipLinearInSlices : OnSlices<PlaceLodBlock> {
  using OnSlices::OnSlices;

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const PlaceLodBlock& block, size_t i, Sink& sink) const {
    const LevelNumbers<D> levels(d, texture, hn::Load(d, block.lod + i));
    EmitNearestTexel(d, sampler, SlicesAt(d, texture, levels.high), block, i, 0, sink);
    if (levels.blended) {
      EmitNearestTexel(d, sampler, SlicesAt(d, texture, levels.low), block, i, kSecond, sink);
      sink.merge(d, levels.fraction);
    }
    sink.finish();
  }
};

}  // namespace

size_t RunNearestMipLinear(const FilterCall& call) {
  return Run<NearestMipLinear>(call);
}
size_t RunNearestMipLinearInSlices(const FilterCall& call) {
  return Run<NearestMipLinearInSlices>(call);
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
