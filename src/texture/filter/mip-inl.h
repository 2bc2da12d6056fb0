// SPDX-License-Identifier: MIT
// Filters on the nearest mip level.

#if defined(SHD_TEXTURE_MIP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_MIP_INL_H_
#undef SHD_TEXTURE_MIP_INL_H_
#else
#define SHD_TEXTURE_MIP_INL_H_
#endif

#include <hwy/highway.h>

#include "simd/round-inl.h"
#include "texture/filter/bases-inl.h"
#include "texture/filter/nearest-inl.h"
#include "texture/stream.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::RoundUp;

/// Returns the nearest level: ceil(lod + 1/2) - 1 (Vulkan 1.3 specification, "Image Level(s) Selection").
template <class D>
HWY_INLINE Level<D> NearestLevel(D d, const Texture& texture, const LodBlock& block, size_t i) {
  const auto level = RoundUp(hn::Load(d, block.lod + i) + hn::Set(d, 0.5f)) - hn::Set(d, 1.0f);
  return LevelAt(d, texture, FirstTexel(d, texture, block, i), hn::Max(level, hn::Zero(d)));
}

struct NearestMip : OnMipLevels {
  using OnMipLevels::OnMipLevels;

  /// Never prefetches: for one texel per lookup, prefetches cost more than they save.
  static bool is_scattered(const Texture&, const PointBlock&) { return false; }

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const LodBlock& block, size_t i, Sink& sink) const {
    emit_nearest(d, sampler, NearestLevel(d, texture, block, i), block, i, sink);
    sink.finish();
  }
};

struct BilinearMip : OnMipLevels {
  using OnMipLevels::OnMipLevels;

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const LodBlock& block, size_t i, Sink& sink) const {
    const auto u = hn::Load(d, block.u + i), v = hn::Load(d, block.v + i);
    sink.quad(d, kStart, NearestLevel(d, texture, block, i), u, v);
    sink.finish();
  }
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_MIP_INL_H_
