// SPDX-License-Identifier: MIT
// How a filter runs over a batch: blocks, their shapes, the stream. A Filter has
//
//   Block                                  what it needs of each lookup (block.h)
//   static size_t find(texture, sampler, in, &block)  fills it; returns how many lookups were not finite
//   static bool is_scattered(texture, block)  whether prefetching pays (prefetch.h)
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

/// The shapes of the lookups of a call from `first` on, at most kBlock of them. Returns how many are not finite.
template <class Filter>
HWY_INLINE size_t FindBlock(const FilterCall& call, size_t first, typename Filter::Block* block) {
  const size_t count = call.in.count - first < kBlock ? call.in.count - first : kBlock;
  return Filter::find(call.texture, call.sampler, part_of(call.in, first, count), block);
}

/// Emits a block.
template <class Filter, class Sink>
HWY_INLINE void EmitBlock(const Filter& filter, const typename Filter::Block& block, Sink& sink) {
  const BatchTag d;
  for (size_t i = 0; i < block.count; i += hn::Lanes(d)) filter.emit(d, block, i, sink);
}

/// A RunFilter.
template <class Filter>
HWY_NOINLINE size_t Run(const FilterCall& call) {
  const Filter filter(call.texture, call.sampler);
  typename Filter::Block block;
  StreamSink<BatchTag> sink(call);
  size_t nonfinite = 0;
  for (size_t first = 0; first < call.in.count; first += kBlock) {
    nonfinite += FindBlock<Filter>(call, first, &block);
    sink.begin(first, Filter::is_scattered(call.texture, block));
    EmitBlock(filter, block, sink);
    sink.flush();
  }
  return nonfinite;
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_RUNNER_INL_H_
