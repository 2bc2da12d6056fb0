// SPDX-License-Identifier: MIT
// The loop over a batch of directions: projects blocks of them, finds their shapes and runs a filter.

#if defined(SHD_TEXTURE_RUN_DIRECTIONS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_RUN_DIRECTIONS_INL_H_
#undef SHD_TEXTURE_RUN_DIRECTIONS_INL_H_
#else
#define SHD_TEXTURE_RUN_DIRECTIONS_INL_H_
#endif

#include <type_traits>

#include <hwy/highway.h>

#include "simd/round-inl.h"
#include "texture/domain/direction.h"
#include "texture/domain/project-inl.h"
#include "texture/filter/direction_sink-inl.h"
#include "texture/filter/random-inl.h"
#include "texture/filter/runner-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::RoundDown;

/// Part of the footprint that is stretched along the parallel: none where the lookup is not minified.
template <class D>
HWY_INLINE hn::Vec<D> BlurOf(D d, const PointBlock&, size_t) {
  return hn::Zero(d);
}
template <class D>
HWY_INLINE hn::Vec<D> BlurOf(D d, const LodBlock& block, size_t i) {
  return hn::Min(hn::Max(hn::Load(d, block.lod + i), hn::Zero(d)), hn::Set(d, 1.0f));
}

/// Quads along a parallel in place of one: fewer for each probe of a line.
template <class D>
HWY_INLINE hn::Vec<D> QuadLimit(D d, const PointBlock&, size_t) {
  return hn::Set(d, kMaxParallel);
}
template <class D>
HWY_INLINE hn::Vec<D> QuadLimit(D d, const ProbeBlock& block, size_t i) {
  return hn::Min(RoundDown(hn::Set(d, kMaxQuads) / hn::Load(d, block.probes + i)), hn::Set(d, kMaxParallel));
}

/// The block that FindShapes() fills.
template <class Block>
HWY_INLINE auto ShapesOf(Block* block) {
  using Shapes = std::conditional_t<std::is_base_of_v<EllipseBlock, Block>, EllipseBlock, Block>;
  return static_cast<Shapes*>(block);
}

/// Brings the shapes of LAT_LONG from the equator to their parallels.
inline void StretchShapes(const ProjectedBlock&, const Texture&, PointBlock*) {}
inline void StretchShapes(const ProjectedBlock& points, const Texture&, ProbeBlock* block) {
  const BatchTag d;
  for (size_t i = 0; i < block->count; i += hn::Lanes(d)) {
    const auto limit = hn::Set(d, 0.5f) / hn::Load(d, block->probes + i);  // together one circle
    const auto step = hn::Load(d, block->step_u + i) * hn::Load(d, points.stretch + i);
    hn::Store(hn::Min(hn::Max(step, hn::Neg(limit)), limit), d, block->step_u + i);
  }
}

/// Finds the random bits of a block of directions: those of the lookups, or a hash of the direction.
inline void FindRandom(const Lookups& in, uint32_t* random) {
  ForEachVector(in, [&](auto d, const Lookups& from, size_t i, size_t to) {
    const hn::RebindToUnsigned<decltype(d)> du;
    const auto load = [&](const float* column) { return FiniteOrZero(d, LoadOrZero(d, column, i)); };
    const auto hash = BitsOfPoint(d, load(from.u), hn::BitCast(d, BitsOfPoint(d, load(from.v), load(from.w))));
    hn::Store(from.random ? hn::LoadU(du, from.random + i) : hash, du, random + to);
  });
}

/// Runs a filter over a batch of directions; a RunFilter.
template <class Filter, class Stream = StreamSink>
HWY_NOINLINE size_t RunDirections(const FilterCall& given) {
  const BatchTag d;
  const Sampler sampler = SamplerOfDirections(given.texture, given.sampler);
  const FilterCall call = {given.texture, sampler,      given.in,        given.out,
                           given.format,  given.record, given.recording, given.placement};
  const Filter filter(call.texture, call.sampler);
  ProjectedBlock points;
  typename Filter::Block block;
  constexpr bool kPicks = !std::is_same_v<Stream, StreamSink>;
  alignas(64) uint32_t random[kPicks ? kBlock : 1];
  DirectionSink<Stream> sink(call);
  size_t nonfinite = 0;
  for (size_t first = 0; first < call.in.count; first += kBlock) {
    nonfinite += ProjectLookups(call.texture, block_of(call.in, first), &points);
    FindShapes(call.texture, call.sampler, points.points, ShapesOf(&block));
    if (points.stretches) StretchShapes(points, call.texture, &block);
    if constexpr (kPicks) FindRandom(block_of(call.in, first), random);
    sink.begin(first, Filter::is_scattered(call.texture, block));
    for (size_t i = 0; i < block.count; i += hn::Lanes(d)) {
      if constexpr (kPicks) sink.start(d, hn::Load(hn::RebindToUnsigned<BatchTag>(), random + i));
      sink.place(d, points, i, BlurOf(d, block, i), QuadLimit(d, block, i));
      filter.emit(d, block, i, sink);
    }
    sink.flush();
  }
  return nonfinite;
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_RUN_DIRECTIONS_INL_H_
