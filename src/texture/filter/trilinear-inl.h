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
#include "texture/filter/rows-inl.h"
#include "texture/stream.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

struct Trilinear : OnMipLevels {
  using OnMipLevels::OnMipLevels;

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const LodBlock& block, size_t i, Sink& sink) const {
    const auto levels = LevelsOf(d, texture, FirstTexel(d, texture, block, i), hn::Load(d, block.lod + i));
    const auto u = hn::Load(d, block.u + i), v = hn::Load(d, block.v + i);
    sink.quad(d, kStart, levels.high, u, v);
    if (levels.blended) sink.quad(d, kBlend, levels.low, u, v, levels.fraction);
    sink.finish();
  }

  /// Finds the levels that lookups share, for rows. Returns false if they share none.
  static bool share_levels(const Texture& texture, const RowBlock& block, RowLevels* out) {
    const LodBounds lod = BoundsOf(block);
    out->fine = static_cast<uint32_t>(lod.least);
    out->coarse = out->fine + 1 < texture.level_count ? out->fine + 1 : out->fine;
    out->blended = lod.most > static_cast<float>(out->fine);
    return static_cast<uint32_t>(lod.most) == out->fine;
  }
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_TRILINEAR_INL_H_
