// SPDX-License-Identifier: MIT
// Hot pairs of a filter and a format, compiled together from the same two structs: each element is consumed as soon as
// it is emitted. Streams are as fast for the other pairs, or at most 10 % slower.
#include "texture/lookup/sample.h"

#define SHD_FORMAT_KERNELS
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/lookup/fused.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/filter/ewa-inl.h"
#include "texture/filter/nearest-inl.h"
#include "texture/filter/runner-inl.h"
#include "texture/format/consume-inl.h"
#include "texture/format/unorm8-inl.h"
#include "texture/lookup/fused-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

/// Consumes each element as soon as it is emitted: values of one format, without border.
template <class F>
class FusedSink : public Emitter<FusedSink<F>> {
 public:
  static constexpr bool kBuffered = false;
  using D = BatchTag;
  using B = Blend<F, false>;

  explicit FusedSink(const FilterCall& call) : to_(call, TexelSource(call.texture), nullptr), consumer_(to_) {}

  HWY_INLINE const Sampler& sampler() const { return to_.sampler; }
  HWY_INLINE Elements<kMaxLanes>& elements() { return element_; }
  static constexpr bool has_rates() { return false; }
  static constexpr bool bordered() { return false; }

  /// Begins the block of lookups whose first one is `first`.
  void begin(size_t first, bool) { to_.done = first; }
  void flush() {}

  HWY_INLINE size_t add(D) { return 0; }
  HWY_INLINE void commit(D d, uint32_t op) {
    ConsumeElement<B, F, false>(d, consumer_, element_, op, 0, &averages_, &to_);
  }
  HWY_INLINE void finish() {
    const D d;
    consumer_.wanted.for_each([&](auto c) SHD_INLINE_LAMBDA {
      const auto result = B::template finish<c>(d, averages_.value[0][c]);
      StoreFirst(d, result, to_.count - to_.done, to_.out.channel[c] + to_.done);
    });
    to_.done += hn::Lanes(d);
  }

 private:
  Elements<kMaxLanes> element_;
  Consumption to_;
  Consumer<B> consumer_;
  Averages<B, D> averages_;
};

/// A fused pair, with its speed relative to the streamed filter (RGBA8, 2048 x 2048, receding floor, one thread of a
/// Sapphire Rapids Xeon). Measured and rejected: trilinear 1.05 (AVX-512), bicubic 1.0, bilinear 0.9, anisotropic 0.95;
/// trilinear in 3D 0.75 on AMD's Zen 5, because the texels of a stream arrive while the next elements are made.
struct FusedPair {
  shd_filter filter;
  image::Component component;
  RunFilter run;
};
constexpr FusedPair kFusedPairs[] = {
    {SHD_FILTER_NEAREST, image::Component::kUnorm8,
     Run<Nearest, FusedSink<Unorm8>>},  // 1.20 on AVX-512, 1.0 on AVX2, SSE4
    {SHD_FILTER_EWA, image::Component::kUnorm8,
     Run<Ewa, FusedSink<Unorm8>>},  // 1.18 on AVX-512, 1.26 on AVX2, 1.14 on SSE4
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
