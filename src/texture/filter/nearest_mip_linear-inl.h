// SPDX-License-Identifier: MIT
// Blend of nearest lookups on the two levels around the level of detail.

#if defined(SHD_TEXTURE_NEAREST_MIP_LINEAR_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_NEAREST_MIP_LINEAR_INL_H_
#undef SHD_TEXTURE_NEAREST_MIP_LINEAR_INL_H_
#else
#define SHD_TEXTURE_NEAREST_MIP_LINEAR_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/filter/nearest-inl.h"
#include "texture/stream.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

struct NearestMipLinear : OnMipLevels {
  using OnMipLevels::OnMipLevels;

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const LodBlock& block, size_t i, Sink& sink) const {
    const auto levels = LevelsOf(d, texture, FirstTexel(d, texture, block, i), hn::Load(d, block.lod + i));
    emit_nearest(d, sampler, levels.high, block, i, sink);
    if (levels.blended) {
      emit_nearest(d, sampler, levels.low, block, i, sink, kSecond);
      sink.merge(d, levels.fraction);
    }
    sink.finish();
  }
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_NEAREST_MIP_LINEAR_INL_H_
