// SPDX-License-Identifier: MIT

#if defined(SHD_TEXTURE_NEAREST_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_NEAREST_INL_H_
#undef SHD_TEXTURE_NEAREST_INL_H_
#else
#define SHD_TEXTURE_NEAREST_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/filter/bases-inl.h"
#include "texture/stream.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Emits the texel of a level that contains the point as the start of an average: the first one, or kSecond.
template <class D, class Sink>
HWY_INLINE void emit_nearest(D d, const Sampler& sampler, const Level<D>& level, const PointBlock& block, size_t i,
                             Sink& sink, uint32_t average = 0) {
  MaskOf<D> in_x, in_y;
  const auto x = WrapNearest(d, sampler.wrap_u, hn::Load(d, block.u + i), level.across, &in_x);
  const auto y = WrapNearest(d, sampler.wrap_v, hn::Load(d, block.v + i), level.down, &in_y);
  sink.texel(d, kStart | kNewLine | average, level, x, y, hn::And(in_x, in_y));
}

struct Nearest : OnBaseLevel {
  using OnBaseLevel::OnBaseLevel;

  /// Never prefetches: for one texel per lookup, prefetches cost more than they save.
  static bool is_scattered(const Texture&, const PointBlock&) { return false; }

  template <class D, class Sink>
  HWY_INLINE void emit(D d, const PointBlock& block, size_t i, Sink& sink) const {
    emit_nearest(d, sampler, level(d, block, i), block, i, sink);
    sink.finish();
  }
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_NEAREST_INL_H_
