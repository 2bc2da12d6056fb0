// SPDX-License-Identifier: MIT
// Trilinear filter: blend of bilinear lookups on the two levels around the level of detail (Williams, "Pyramidal
// Parametrics", 1983).

#if defined(SHD_TEXTURE_TRILINEAR_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_TRILINEAR_INL_H_
#undef SHD_TEXTURE_TRILINEAR_INL_H_
#else
#define SHD_TEXTURE_TRILINEAR_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/filter/bases-inl.h"
#include "texture/stream.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

struct Trilinear : OnMipLevels {
  using OnMipLevels::OnMipLevels;

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const LodBlock& block, size_t i, Sink& sink) const {
    emit(d, block, i, levels_at(d, block, i), sink);
  }

  /// Returns the levels of the vector of lookups at i.
  template <class D>
  HWY_INLINE LevelPair<D> levels_at(D d, const LodBlock& block, size_t i) const {
    return LevelsOf(d, texture, FirstTexel(d, texture, block, i), hn::Load(d, block.lod + i));
  }

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const LodBlock& block, size_t i, const LevelPair<D>& levels, Sink& sink) const {
    const auto u = hn::Load(d, block.u + i), v = hn::Load(d, block.v + i);
    sink.quad(d, kStart, levels.high, u, v);
    if (levels.blended) sink.quad(d, kBlend, levels.low, u, v, levels.fraction);
    sink.finish();
  }
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_TRILINEAR_INL_H_
