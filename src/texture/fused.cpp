// SPDX-License-Identifier: MIT
// Hot pairs of a filter and a format, compiled together from the same two structs: each element is consumed as it is
// emitted. The other pairs stream at the same speed or within 10 % of it.
#include "texture/sample.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/fused.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/filter/ewa-inl.h"
#include "texture/filter/nearest-inl.h"
#include "texture/filter/runner-inl.h"
#include "texture/format/consume-inl.h"
#include "texture/format/unorm8-inl.h"
#include "texture/fused-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

/// Values without border of one format.
template <class F, class D>
class FusedSink {
 public:
  using B = Blend<F, false>;

  explicit FusedSink(const FilterCall& call)
      : to_{TexelSource(call.texture), call.sampler, nullptr, call.out, call.in.count, 0, false, {}}, consumer_(to_) {
    element_.has_rates = false;
  }

  HWY_INLINE bool has_rates() const { return false; }

  /// Lookups from `first` on follow.
  void begin(size_t first) { to_.done = first; }

  HWY_INLINE void quad(D d, uint32_t op, const Quad<D>& q) { consume(d, op | WriteQuad(d, q, false, 0, &element_)); }
  HWY_INLINE void quad(D d, uint32_t op, const Quad<D>& q, hn::Vec<D> share) {
    WriteShare(d, share, 0, &element_);
    quad(d, op, q);
  }
  HWY_INLINE void texel(D d, uint32_t op, Ints<D> index, MaskOf<D> in) {
    WriteTexel(d, index, in, false, 0, &element_);
    consume(d, op);
  }
  HWY_INLINE void texel(D d, uint32_t op, Ints<D> index, MaskOf<D> in, const Share<D>& share) {
    WriteShare(d, share, 0, &element_);
    texel(d, op, index, in);
  }
  HWY_INLINE void merge(D d, hn::Vec<D> share) {
    WriteShare(d, share, 0, &element_);
    consume(d, kMerge);
  }
  HWY_INLINE void finish() {
    const D d;
    consumer_.wanted.for_each(
        [&](auto c) { consumer_.blend.template store<c>(d, averages_.value[0][c], to_.done, to_); });
    to_.done += hn::Lanes(d);
  }

 private:
  HWY_INLINE void consume(D d, uint32_t op) {
    ConsumeElement<B, F, false>(d, consumer_, element_, op, 0, &averages_, &to_);
  }

  Elements<kMaxLanes> element_;
  Consumption to_;
  Consumer<B> consumer_;
  Averages<B, D> averages_;
};

/// A RunFilter. Lookups that are scattered over a large texture are streamed, as streams prefetch.
template <class Filter, class F>
size_t RunFused(const FilterCall& call) {
  const Filter filter(call.texture, call.sampler);
  typename Filter::Block block;
  FusedSink<F, BatchTag> fused(call);
  StreamSink<BatchTag> stream(call);
  size_t nonfinite = 0;
  for (size_t first = 0; first < call.in.count; first += kBlock) {
    nonfinite += FindBlock<Filter>(call, first, &block);
    if (Filter::is_scattered(call.texture, block)) {
      stream.begin(first, true);
      EmitBlock(filter, block, stream);
      stream.flush();
    } else {
      fused.begin(first);
      EmitBlock(filter, block, fused);
    }
  }
  return nonfinite;
}

/// Fused over streamed, RGBA8 2048 x 2048, floor, one thread of a Sapphire Rapids Xeon. Measured and left out: trilinear
/// 1.05 (AVX-512), bicubic 1.0, bilinear 0.9, anisotropic 0.95.
struct FusedPair {
  shd_filter filter;
  image::Component component;
  RunFilter run;
};
constexpr FusedPair kFusedPairs[] = {
    {SHD_FILTER_NEAREST, image::Component::kUnorm8, RunFused<Nearest, Unorm8>},  // 1.20 on AVX-512, 1.0 on AVX2, SSE4
    {SHD_FILTER_EWA, image::Component::kUnorm8, RunFused<Ewa, Unorm8>},          // 1.18, 1.26 on AVX2, 1.14 on SSE4
};

}  // namespace

RunFilter FusedOf(shd_filter filter, image::Component component) {
  for (const FusedPair& pair : kFusedPairs) {
    if (pair.filter == filter && pair.component == component) return pair.run;
  }
  return nullptr;
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
