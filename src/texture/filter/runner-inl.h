// SPDX-License-Identifier: MIT
// The loop of a filter over a batch. It fills a block with shapes and emits the elements of each vector of lookups to a
// sink. A Filter has these members:
//
//   Block                                     shapes of a block of lookups (block.h), which FindShapes() fills
//   static bool is_scattered(texture, block)  returns whether the lookups should be prefetched (prefetch.h)
//   emit(d, block, i, sink)                   emits the elements of the vector of lookups at i, and calls sink.finish()

#if defined(SHD_TEXTURE_RUNNER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_RUNNER_INL_H_
#undef SHD_TEXTURE_RUNNER_INL_H_
#else
#define SHD_TEXTURE_RUNNER_INL_H_
#endif

#include <type_traits>

#include <hwy/highway.h>

#include "texture/filter/level-inl.h"
#include "texture/filter/prefetch.h"
#include "texture/footprint/shapes-inl.h"
#include "texture/stream.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A share in a running average that depends on the point, with its derivatives in u and v.
template <class D>
struct Share {
  hn::Vec<D> value, rate_u, rate_v;
};

/// Four texels of a row of a level around a point, in the order of columns 1, 2, 0, 3.
template <class D>
struct Row {
  Ints<D> index[4];
  MaskOf<D> in[4];
  hn::Vec<D> share[3], rate[3];  // shares of the last three texels in their running average, and their derivatives
  bool neighbours;               // columns are adjacent in memory
};

/// Base of sinks, to which filters emit elements. A Sink has these members:
///
///   add(d)         returns the position of a new element in elements()
///   commit(d, op)  completes the new element
///   finish()       marks the latest element as the last one of its vector of lookups
///   sampler()      the sampler
///   bordered()     texels may be the border colour
///   has_rates()    shares need their derivatives
///
/// A share is a vector or a Share. Elements that start an average have no share.
template <class Sink>
class Emitter {
 public:
  Emitter() = default;
  Emitter(const Emitter&) = delete;
  Emitter& operator=(const Emitter&) = delete;

  /// Emits the quad of a level around reduced coordinates.
  template <class D, class... AnyShare>
  HWY_INLINE void quad(D d, uint32_t op, const Level<D>& level, hn::Vec<D> u, hn::Vec<D> v, const AnyShare&... share) {
    const Sampler& sampler = self().sampler();
    LinearTaps<D> x = WrapLinear(d, sampler.wrap_u, u, level.across);
    LinearTaps<D> y = WrapLinear(d, sampler.wrap_v, v, level.down);
    if (HWY_UNLIKELY(sampler.rounded_weights)) {
      RoundWeights(d, &x);
      RoundWeights(d, &y);
    }
    quad(d, op, level, x, y, share...);
  }

  /// Emits the quad of columns x and rows y of a level.
  template <class D, class... AnyShare>
  HWY_INLINE void quad(D d, uint32_t op, const Level<D>& level, const LinearTaps<D>& x, const LinearTaps<D>& y,
                       const AnyShare&... share) {
    const hn::RebindToSigned<D> di;
    const size_t at = self().add(d);
    auto& to = self().elements();
    hn::Store(x.s, d, to.s + at);
    hn::Store(y.s, d, to.t + at);
    if (HWY_UNLIKELY(self().has_rates())) {
      hn::Store(x.rate, d, to.rate_s + at);
      hn::Store(y.rate, d, to.rate_t + at);
    }
    op |= kQuad | write_share(d, at, share...);
    const auto top = RowIndex(d, level, y.i0), bottom = RowIndex(d, level, y.i1);
    if (HWY_UNLIKELY(self().bordered())) {
      write_texel(d, 0, at, top + x.i0, hn::And(x.in0, y.in0));
      write_texel(d, 1, at, top + x.i1, hn::And(x.in1, y.in0));
      write_texel(d, 2, at, bottom + x.i0, hn::And(x.in0, y.in1));
      write_texel(d, 3, at, bottom + x.i1, hn::And(x.in1, y.in1));
      return self().commit(d, op);
    }
    hn::Store(top + x.i0, di, to.index[0] + at);
    hn::Store(bottom + x.i0, di, to.index[2] + at);
    if (HWY_LIKELY(hn::AllTrue(di, hn::Eq(x.i1, x.i0 + hn::Set(di, 1))))) return self().commit(d, op | kNeighbours);
    hn::Store(top + x.i1, di, to.index[1] + at);
    hn::Store(bottom + x.i1, di, to.index[3] + at);
    self().commit(d, op);
  }

  template <class D, class AnyShare>
  HWY_INLINE void row(D d, uint32_t op, const Row<D>& row, const AnyShare& share) {
    const size_t at = self().add(d);
    auto& to = self().elements();
    float* const shares[3] = {to.s, to.t, to.r};
    float* const rates[3] = {to.rate_s, to.rate_t, to.rate_r};
    for (size_t k = 0; k < 3; ++k) {
      hn::Store(row.share[k], d, shares[k] + at);
      if (HWY_UNLIKELY(self().has_rates())) hn::Store(row.rate[k], d, rates[k] + at);
    }
    op |= kRow | write_share(d, at, share);
    if (HWY_LIKELY(row.neighbours && !self().bordered())) {
      hn::Store(row.index[2], hn::RebindToSigned<D>(), to.index[2] + at);
      return self().commit(d, op | kNeighbours);
    }
    for (size_t k = 0; k < 4; ++k) write_texel(d, k, at, row.index[k], row.in[k]);
    self().commit(d, op);
  }

  template <class D, class... AnyShare>
  HWY_INLINE void texel(D d, uint32_t op, Ints<D> index, MaskOf<D> in, const AnyShare&... share) {
    const size_t at = self().add(d);
    write_texel(d, 0, at, index, in);
    self().commit(d, op | write_share(d, at, share...));
  }

  /// Emits the merge of the second average into the first.
  template <class D, class AnyShare>
  HWY_INLINE void merge(D d, const AnyShare& share) {
    const size_t at = self().add(d);
    self().commit(d, kMerge | write_share(d, at, share));
  }

 private:
  HWY_INLINE Sink& self() { return static_cast<Sink&>(*this); }

  template <class D>
  HWY_INLINE void write_texel(D d, size_t k, size_t at, Ints<D> index, MaskOf<D> in) {
    const Ints<D> texel = HWY_UNLIKELY(self().bordered()) ? TexelOrBorder(d, index, in) : index;
    hn::Store(texel, hn::RebindToSigned<D>(), self().elements().index[k] + at);
  }

  /// Writes the share of an element. Returns its flags.
  template <class D>
  HWY_INLINE uint32_t write_share(D, size_t) {
    return 0;
  }
  template <class D>
  HWY_INLINE uint32_t write_share(D d, size_t at, hn::Vec<D> share) {
    hn::Store(share, d, self().elements().share + at);
    return 0;
  }
  template <class D>
  HWY_INLINE uint32_t write_share(D d, size_t at, const Share<D>& share) {
    auto& to = self().elements();
    hn::Store(share.value, d, to.share + at);
    if (HWY_LIKELY(!self().has_rates())) return 0;
    hn::Store(share.rate_u, d, to.share_rate_u + at);
    hn::Store(share.rate_v, d, to.share_rate_v + at);
    return kRated;
  }
};

/// Buffers elements and passes them to the consumers of a call whenever the buffer is full.
class StreamSink : public Emitter<StreamSink> {
 public:
  explicit StreamSink(const FilterCall& call)
      : sampler_(call.sampler),
        bordered_(has_border(call.sampler)),
        first_{TexelSource(call.texture), call.sampler, call.recording, call.out, call.in.count, 0, false, {}},
        second_{TexelSource(call.texture), call.sampler, nullptr, call.out, call.in.count, 0, false, {}} {
    consume_first_ = call.record ? call.record : bordered_ ? call.format.bordered : call.format.values;
    if (!call.record && call.out.wants_gradient()) consume_second_ = call.format.gradient;
    if (!call.record && !call.out.wants_values()) consume_first_ = nullptr;
    stream_.elements = 0;
  }

  HWY_INLINE const Sampler& sampler() const { return sampler_; }
  HWY_INLINE Stream& elements() { return stream_; }
  HWY_INLINE bool has_rates() const { return consume_second_ != nullptr; }
  HWY_INLINE bool bordered() const { return bordered_; }

  /// Begins the block of lookups whose first one is `first`. `scattered`: is_scattered() of the block.
  void begin(size_t first, bool scattered) {
    first_.done = second_.done = first;
    scattered_ = scattered;
  }

  HWY_INLINE size_t add(BatchTag d) {
    const size_t lanes = hn::Lanes(d);
    if (HWY_UNLIKELY((stream_.elements + 1) * lanes > Stream::kCapacity)) flush();
    return stream_.elements++ * lanes;
  }
  HWY_INLINE void commit(BatchTag, uint32_t op) { stream_.op[stream_.elements - 1] = static_cast<uint16_t>(op); }

  HWY_INLINE void finish() { stream_.op[stream_.elements - 1] |= kLast; }

  void flush() {
    const size_t end = stream_.elements, lanes = hn::Lanes(BatchTag());
    stream_.elements = 0;
    if (!scattered_) return consume(0, end);
    // Consume the stream in parts, and prefetch the next part before each one.
    constexpr size_t kPart = Stream::kCapacity / 2;
    const size_t part = kPart > lanes ? kPart / lanes : 1;
    prefetch_elements(first_.texels, stream_, 0, part < end ? part : end, lanes);
    for (size_t e = 0; e < end; e += part) {
      const size_t next = e + part < end ? e + part : end;
      prefetch_elements(first_.texels, stream_, next, next + part < end ? next + part : end, lanes);
      consume(e, next);
    }
  }

 private:
  void consume(size_t first, size_t end) {
    if (first == end) return;
    if (consume_first_) consume_first_(stream_, first, end, &first_);
    if (consume_second_) consume_second_(stream_, first, end, &second_);
  }

  Stream stream_;
  const Sampler& sampler_;
  const bool bordered_;
  bool scattered_ = false;
  Consume consume_first_, consume_second_ = nullptr;
  Consumption first_, second_;
};

/// Stands for the sink of filters that are not compiled together with a format.
struct NoSink {
  explicit NoSink(const FilterCall&) {}
};

/// Runs a filter over a batch; a RunFilter. Elements of scattered lookups are streamed even if the filter is fused with
/// a format by `FusedSink`, because streams are prefetched.
template <class Filter, class FusedSink = NoSink>
HWY_NOINLINE size_t Run(const FilterCall& call) {
  constexpr bool kFused = !std::is_same_v<FusedSink, NoSink>;
  constexpr size_t kLine = 16;  // lookups per cache line of a column
  const BatchTag d;
  const Filter filter(call.texture, call.sampler);
  const InputColumns columns(call.in);
  typename Filter::Block block;
  StreamSink stream(call);
  FusedSink fused(call);
  size_t nonfinite = 0;
  for (size_t first = 0; first < call.in.count; first += kBlock) {
    nonfinite += FindShapes(call.texture, call.sampler, block_of(call.in, first), &block);
    const auto emit = [&](auto& sink) SHD_INLINE_LAMBDA {
      for (size_t i = 0; i < block.count; i += hn::Lanes(d)) {
        if (i % kLine == 0) columns.prefetch(first + kBlock + i);  // the next block
        filter.emit(d, block, i, sink);
      }
    };
    const bool scattered = Filter::is_scattered(call.texture, block);
    if constexpr (kFused) {
      if (!scattered) {
        fused.begin(first);
        emit(fused);
        continue;
      }
    }
    stream.begin(first, scattered);
    emit(stream);
    stream.flush();
  }
  return nonfinite;
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_RUNNER_INL_H_
