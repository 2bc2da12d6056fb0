// SPDX-License-Identifier: MIT
// How a filter runs over a batch: blocks, their shapes, the stream. A Filter has
//
//   Block                                  what it needs of each lookup (block.h)
//   static size_t find(call, in, &block)   fills it; returns how many lookups were not finite
//   static const float* lods(block)        the levels of detail for prefetching, or null for level 0
//   emit(d, block, i, sink)                the elements of the vector of lookups at i, the last one finished

#if defined(SHD_TEXTURE_RUNNER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_RUNNER_INL_H_
#undef SHD_TEXTURE_RUNNER_INL_H_
#else
#define SHD_TEXTURE_RUNNER_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/filter/sink-inl.h"
#include "texture/footprint/points-inl.h"
#include "texture/footprint/shapes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A RunFilter.
template <class Filter>
HWY_NOINLINE size_t Run(const FilterCall& call) {
  const BatchTag d;
  const size_t lanes = hn::Lanes(d);
  const Filter filter(call.texture, call.sampler);
  StreamSink<BatchTag> sink(call);
  typename Filter::Block block;
  size_t nonfinite = 0;
  for (size_t first = 0; first < call.in.count; first += kBlock) {
    const Lookups in = part_of(call.in, first, call.in.count - first < kBlock ? call.in.count - first : kBlock);
    nonfinite += Filter::find(call.texture, call.sampler, in, &block);
    sink.set_scattered(is_scattered(call.texture, block, Filter::lods(block)));
    for (size_t i = 0; i < in.count; i += lanes) filter.emit(d, block, i, sink);
    sink.flush();
  }
  return nonfinite;
}

/// What filters on level 0 have in common.
struct OnBaseLevel {
  using Block = PointBlock;

  const Texture& texture;
  const Sampler& sampler;

  OnBaseLevel(const Texture& of_texture, const Sampler& of_sampler) : texture(of_texture), sampler(of_sampler) {}

  static size_t find(const Texture& texture, const Sampler& sampler, const Lookups& in, PointBlock* block) {
    return FindPoints(texture, sampler, in, block);
  }
  static const float* lods(const PointBlock&) { return nullptr; }

  template <class D>
  HWY_INLINE Level<D> level(D d, const PointBlock& block, size_t i) const {
    return SameLevel(d, texture, FirstTexel(d, texture, block, i), 0);
  }
};

/// What filters with a level of detail have in common.
struct OnMipLevels {
  using Block = LodBlock;

  const Texture& texture;
  const Sampler& sampler;

  OnMipLevels(const Texture& of_texture, const Sampler& of_sampler) : texture(of_texture), sampler(of_sampler) {}

  static size_t find(const Texture& texture, const Sampler& sampler, const Lookups& in, LodBlock* block) {
    return FindLods(texture, sampler, lod_range(texture, sampler), LodRounding::kFilter, in, block);
  }
  static const float* lods(const LodBlock& block) { return block.lod; }
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_RUNNER_INL_H_
