// SPDX-License-Identifier: MIT
// Hot pairs of a filter and a format, compiled together from the same two structs: each element is consumed as soon as
// it is emitted. Streams are as fast for the other pairs, or at most 10 % slower.
#include "core/simd_narrow.h"
#include "texture/lookup/sample.h"

#define SHD_FORMAT_KERNELS
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/lookup/fused.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/filter/anisotropic-inl.h"
#include "texture/filter/bilinear-inl.h"
#include "texture/filter/ewa-inl.h"
#include "texture/filter/nearest-inl.h"
#include "texture/filter/runner-inl.h"
#include "texture/filter/trilinear-inl.h"
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

#if HWY_MAX_BYTES == 16
/// Consumes each element of few lookups as soon as it is emitted, for texels of four 8-bit channels without border. The
/// lanes of its vectors are the channels of one lookup: vectors of lookups would be empty for the most part.
class ChannelSink : public Emitter<ChannelSink> {
 public:
  static_assert(hn::MaxLanes(BatchTag()) == core::kNarrowLanes, "few lookups are one vector");

  ChannelSink(const Texture& texture, const Sampler& sampler, size_t count, const Texels& out)
      : sampler_(sampler), texture_(texture), out_(out), count_(count) {}

  HWY_INLINE const Sampler& sampler() const { return sampler_; }
  HWY_INLINE Elements<kMaxLanes>& elements() { return element_; }
  static constexpr bool has_rates() { return false; }
  static constexpr bool bordered() { return false; }

  HWY_INLINE size_t add(BatchTag) { return 0; }
  HWY_INLINE void commit(BatchTag, uint32_t op) {
    for (size_t k = 0; k < count_; ++k) {
      V* const average = &average_[op & kSecond ? 1 : 0][k];
      const V value = op & kQuad ? quad_at(op, k) : op & kMerge ? average_[1][k] : texel_at(0, k);
      *average = op & (kHow | kMerge) ? averaged(op, *average, value, element_.share[k]) : value;
    }
  }
  HWY_INLINE void finish() {
    float unwanted[core::kNarrowLanes];
    float* to[4];
    for (size_t c = 0; c < 4; ++c) to[c] = out_.channel[c] ? out_.channel[c] : unwanted;
    for (size_t k = 0; k < count_; ++k) {
      alignas(16) float channel[4];
      hn::Store(Unorm8::finish<0>(D(), average_[0][k]), D(), channel);
      for (size_t c = 0; c < 4; ++c) to[c][k] = channel[c];
    }
  }

 private:
  using D = hn::FixedTag<float, 4>;
  using V = hn::Vec<D>;

  static HWY_INLINE V decode(const uint8_t* texel) {
    const hn::RebindToSigned<D> di;
    return hn::ConvertTo(D(), hn::PromoteTo(di, hn::LoadU(hn::Rebind<uint8_t, D>(), texel)));
  }
  HWY_INLINE const uint8_t* address_of(int32_t texel) const {
    const auto index = static_cast<uint32_t>(texel);
    return (index < texture_.borrowed_units ? texture_.borrowed : texture_.origin) + size_t{4} * index;
  }
  HWY_INLINE V texel_at(size_t i, size_t k) const { return decode(address_of(element_.index[i][k])); }
  HWY_INLINE V quad_at(uint32_t op, size_t k) const {
    const D d;
    const V s = hn::Set(d, element_.s[k]), t = hn::Set(d, element_.t[k]);
    if (HWY_LIKELY(op & kNeighbours)) {
      const uint8_t* const top = address_of(element_.index[0][k]);
      const uint8_t* const bottom = address_of(element_.index[2][k]);
      return Lerp(d, Lerp(d, decode(top), decode(top + 4), s), Lerp(d, decode(bottom), decode(bottom + 4), s), t);
    }
    return quad_apart(k, s, t);
  }
  HWY_NOINLINE V quad_apart(size_t k, V s, V t) const {
    const D d;
    return Lerp(d, Lerp(d, texel_at(0, k), texel_at(1, k), s), Lerp(d, texel_at(2, k), texel_at(3, k), s), t);
  }
  static HWY_INLINE V averaged(uint32_t op, V average, V value, float share) {
    if ((op & kHow) == kReplace && share == kWhole) return value;
    return Lerp(D(), average, value, hn::Set(D(), share));
  }

  const Sampler& sampler_;
  const Texture& texture_;
  const Texels& out_;
  const size_t count_;
  V average_[2][core::kNarrowLanes];
  Elements<kMaxLanes> element_;
};

/// Runs a filter over few lookups, without what only longer batches need; a RunFew.
template <class Filter>
HWY_NOINLINE size_t FilterFew(const Texture& texture, const Sampler& sampler, const Lookups& in, const Texels& out) {
  const Filter filter(texture, sampler);
  typename Filter::Block block;
  const size_t nonfinite = FindShapes(texture, sampler, in, &block);
  ChannelSink sink(texture, sampler, in.count, out);
  filter.emit(BatchTag(), block, 0, sink);
  return nonfinite;
}
#endif

}  // namespace

RunFilter FusedOf(shd_filter filter, image::Component component) {
  for (const FusedPair& pair : kFusedPairs) {
    if (pair.filter == filter && pair.component == component) return pair.run;
  }
  return nullptr;
}

RunFew FewOf([[maybe_unused]] const Texture& texture, [[maybe_unused]] shd_filter filter) {
#if HWY_MAX_BYTES == 16
  if (texture.component != image::Component::kUnorm8 || texture.channels != 4) return nullptr;
  switch (filter) {
    case SHD_FILTER_BILINEAR:
    case SHD_FILTER_HERMITE: return FilterFew<Bilinear>;
    case SHD_FILTER_TRILINEAR: return FilterFew<Trilinear>;
    case SHD_FILTER_ANISOTROPIC: return FilterFew<Anisotropic>;
    case SHD_FILTER_EWA: return FilterFew<Ewa>;
    default: break;
  }
#endif
  return nullptr;
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
