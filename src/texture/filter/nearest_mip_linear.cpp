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
    emit_texel(d, kStart | kNewLine, SlicesAt(d, texture, levels.high), block, i, sink);
    if (levels.blended) {
      emit_texel(d, kStart | kNewLine | kSecond, SlicesAt(d, texture, levels.low), block, i, sink);
      sink.merge(d, levels.fraction);
    }
    sink.finish();
  }

 private:
  template <class D, class Sink>
  HWY_INLINE void emit_texel(D d, uint32_t op, const Slices<D>& slices, const PlaceLodBlock& block, size_t i,
                             Sink& sink) const {
    MaskOf<D> in_x, in_y, in_z;
    const auto x = WrapNearest(d, sampler.wrap_u, hn::Load(d, block.u + i), slices.level.across, &in_x);
    const auto y = WrapNearest(d, sampler.wrap_v, hn::Load(d, block.v + i), slices.level.down, &in_y);
    const auto z = WrapNearest(d, sampler.wrap_w, hn::Load(d, block.w + i), slices.deep, &in_z);
    sink.texel(d, op, SliceOf(d, slices, z), x, y, hn::And(hn::And(in_x, in_y), in_z));
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
