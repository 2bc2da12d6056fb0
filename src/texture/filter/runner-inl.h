// SPDX-License-Identifier: MIT
// The loop of a filter over a batch. It fills a block with shapes and emits the elements of each vector of lookups to a
// sink. A Filter has these members:
//
//   Block                                     shapes of a block of lookups (block.h), which FindShapes() fills: one of
//                                             the overloads of shapes-inl.h and places-inl.h, or one beside Block
//   static bool is_scattered(texture, block)  returns whether the lookups should be prefetched (prefetch.h)
//   emit(d, block, i, sink)                   emits the elements of the vector of lookups at i, and calls sink.finish()
//
// A linear filter may also have these, for blocks that become rows of quads (rows.h):
//
//   static RowBlock rows_of(block)                   the lookups of a block
//   static bool share_levels(texture, rows, levels)  finds the levels that all lookups of a RowBlock read, if there are
//                                                    such levels

#if defined(SHD_TEXTURE_RUNNER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_RUNNER_INL_H_
#undef SHD_TEXTURE_RUNNER_INL_H_
#else
#define SHD_TEXTURE_RUNNER_INL_H_
#endif

#include <type_traits>

#include <hwy/highway.h>

#include "texture/domain/places-inl.h"
#include "texture/domain/shapes-inl.h"
#include "texture/filter/emitter-inl.h"
#include "texture/filter/prefetch.h"
#include "texture/filter/rows-inl.h"
#include "texture/format/formats-inl.h"
#include "texture/store/level-inl.h"
#include "texture/store/place-inl.h"
#include "texture/stream.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Buffers elements and passes them to the consumers of a call whenever the buffer is full.
class StreamSink : public Emitter<StreamSink> {
 public:
  static constexpr bool kBuffered = true;

  explicit StreamSink(const FilterCall& call)
      : sampler_(call.sampler),
        bordered_(has_border(call.texture, call.sampler)),
        placement_(call.placement),
        places_(placement_.places),
        first_(call, TexelSource(call), call.recording),
        second_(call, first_.texels, nullptr) {
    consume_first_ = call.record ? call.record : call.format.values;
    if (!call.record) consume_second_ = call.format.gradient;
    if (!call.record && !call.out.wants_values()) consume_first_ = nullptr;
  }

  HWY_INLINE const Sampler& sampler() const { return sampler_; }
  HWY_INLINE Stream& elements() { return stream_; }
  /// Memory for rows, in place of the stream until the next begin().
  HWY_INLINE RowStream& rows() { return rows_; }
  HWY_INLINE bool has_rates() const { return consume_second_ != nullptr; }
  HWY_INLINE bool rates_in_w() const { return first_.out.wants_deep_gradient(); }
  HWY_INLINE bool bordered() const { return bordered_; }
  HWY_INLINE StreamPlaces* places() const { return places_; }

  /// Begins the block of lookups whose first one is `first`. `scattered`: is_scattered() of the block.
  void begin(size_t first, bool scattered) {
    first_.done = second_.done = first;
    scattered_ = scattered && !places_;
    stream_.elements = 0;
    stream_.places = places_;
  }

  HWY_INLINE size_t add(BatchTag d) {
    const size_t lanes = hn::Lanes(d), fit = Stream::kCapacity / lanes;
    if (HWY_UNLIKELY(stream_.elements == (fit < Stream::kMaxElements ? fit : Stream::kMaxElements))) flush();
    return stream_.elements++ * lanes;
  }
  HWY_INLINE void commit(BatchTag d, uint32_t op) {
    const size_t e = stream_.elements - 1;
    stream_.op[e] = static_cast<uint16_t>(op);
    if (HWY_UNLIKELY(scattered_)) {
      const size_t at = e * hn::Lanes(d);
      prefetch_element(first_.texels, op, stream_.index[0] + at, stream_.index[2] + at, hn::Lanes(d));
    } else if (op & kNeighbours && op & kQuad && HWY_LIKELY(!places_)) {
      prefetch_ends(stream_.index[0] + e * hn::Lanes(d));
      prefetch_ends(stream_.index[2] + e * hn::Lanes(d));
    }
  }

  HWY_INLINE void finish() { stream_.op[stream_.elements - 1] |= kLast; }

  void flush() {
    const size_t end = stream_.elements;
    if (end == 0) return;
    stream_.elements = 0;
    if (HWY_UNLIKELY(places_ != nullptr)) {
      placement_.place(placement_.state, end, hn::Lanes(BatchTag()), &stream_);
    }
    if (consume_first_) consume_first_(stream_, end, &first_);
    if (consume_second_) consume_second_(stream_, end, &second_);
  }

 private:
  /// Prefetches the texels of the first and the last lookup of a vector: those between them are near.
  HWY_INLINE void prefetch_ends(const int32_t* index) const {
    const size_t lanes = hn::Lanes(BatchTag());
    __builtin_prefetch(first_.texels.texel(static_cast<uint32_t>(index[0])));
    if (lanes > 4) __builtin_prefetch(first_.texels.texel(static_cast<uint32_t>(index[lanes - 1])));
  }

  union {
    Stream stream_;
    RowStream rows_;
  };
  const Sampler& sampler_;
  const bool bordered_;
  bool scattered_ = false;
  const Placement placement_;
  StreamPlaces* const places_;  // null: filters write indices
  Consume consume_first_, consume_second_ = nullptr;
  Consumption first_, second_;
};

/// Prefetches the texels of elements and drops them.
class PrefetchSink : public Emitter<PrefetchSink> {
 public:
  explicit PrefetchSink(const FilterCall& call) : sampler_(call.sampler), source_(call.texture) {
    element_.index[0][0] = 0;  // GCC 12 finds no other store at -O1, and warns
  }

  HWY_INLINE const Sampler& sampler() const { return sampler_; }
  HWY_INLINE Elements<kMaxLanes>& elements() { return element_; }
  static constexpr bool has_rates() { return false; }
  static constexpr bool bordered() { return false; }

  HWY_INLINE size_t add(BatchTag) { return 0; }
  HWY_INLINE void commit(BatchTag d, uint32_t op) {
    prefetch_element(source_, op, element_.index[0], element_.index[2], hn::Lanes(d));
  }
  HWY_INLINE void finish() {}

 private:
  const Sampler& sampler_;
  const TexelSource source_;
  Elements<kMaxLanes> element_;
};

/// Stands for a sink that is not used.
struct NoSink {
  explicit NoSink(const FilterCall&) {}
};

/// Whether a filter is linear and can find levels that a block of lookups shares.
template <class Filter, class = void>
struct HasRows : std::false_type {};
template <class Filter>
struct HasRows<Filter, std::void_t<decltype(&Filter::share_levels)>> : std::true_type {};

/// Filters blocks of lookups by rows of quads: those that share their levels and are not scattered, or all blocks.
class RowRunner {
 public:
  /// Lookups of a part of a block.
  static constexpr size_t kPart = 32;

  explicit RowRunner(const FilterCall& call)
      : consume_(call.record ? nullptr : call.format.rows),
        place_(consume_ ? PlaceRowsOf(call.texture.store) : nullptr),
        state_(call.placement.state),
        most_refusals_(call.texture.store == Store::kBc ? 3 : 1),
        shares_(consume_ && call.texture.layers == 1),
        rows_only_(call.format.rows_only),
        to_(call, TexelSource(call), nullptr) {}

  /// Filters the block whose first lookup is `first`. Returns false if some of its lookups need a stream, which may
  /// have the memory of `rows`.
  template <class Filter>
  HWY_INLINE bool run(const FilterCall& call, const Filter& filter, const typename Filter::Block& block, size_t first,
                      bool scattered, RowStream* rows) {
    refusals_ = scattered || !shares_ ? most_refusals_ : 0;
    if (!consume_ || (scattered && !rows_only_)) return false;
    if (HWY_LIKELY(run_shared<Filter>(call, Filter::rows_of(block), first, scattered, rows))) return true;
    if (!rows_only_) return false;
    AddressEach(filter, block, rows);
    consume(first, scattered, *rows);
    return true;
  }

  /// Filters a part of a block that run() did not filter: lookup `first`, which is number `begin` of the block, and up
  /// to kPart - 1 lookups after it. Returns false if they need a stream.
  template <class Filter>
  bool run_part(const FilterCall& call, const typename Filter::Block& block, size_t begin, size_t first,
                RowStream* rows) {
    if (refusals_ >= most_refusals_) return false;
    return run_shared<Filter>(call, Filter::rows_of(block).part(begin, kPart), first, false, rows);
  }

 private:
  template <class Filter>
  HWY_NOINLINE bool run_shared(const FilterCall& call, const RowBlock& block, size_t first, bool scattered,
                               RowStream* rows) {
    RowLevels levels;
    if (!shares_ || !Filter::share_levels(call.texture, block, &levels)) return false;
    AddressRows(call.texture, call.sampler, block, levels, rows);
    if (HWY_UNLIKELY(place_ != nullptr)) {
      const RowLevel placed[2] = {RowLevelOf(call.texture, levels.fine), RowLevelOf(call.texture, levels.coarse)};
      if (!place_(state_, placed, rows)) {
        ++refusals_;
        return false;
      }
    }
    consume(first, scattered, *rows);
    return true;
  }
  void consume(size_t first, bool scattered, const RowStream& rows) {
    if (HWY_UNLIKELY(scattered)) prefetch_rows(to_.texels, rows, hn::Lanes(BatchTag()));
    to_.done = first;
    consume_(rows, &to_);
  }

  const ConsumeRows consume_;
  const PlaceRows place_;  // null: quads are in memory
  void* const state_;
  const uint32_t most_refusals_;  // parts of blocks are tried too: quads at edges and on several rows are few
  const bool shares_, rows_only_;
  uint32_t refusals_ = 0;  // refusals of the block and its parts
  Consumption to_;
};

/// Filters the parts of a block that share their levels by rows, and the others by the stream.
template <class Filter>
HWY_INLINE void RunParts(const FilterCall& call, const Filter& filter, const typename Filter::Block& block,
                         size_t first, bool scattered, RowRunner& rows, StreamSink& sink) {
  const BatchTag d;
  for (size_t begin = 0, end; begin < block.count; begin = end) {
    end = HWY_MIN(begin + RowRunner::kPart, block.count);
    if (rows.run_part<Filter>(call, block, begin, first + begin, &sink.rows())) continue;
    sink.begin(first + begin, scattered);
    for (size_t i = begin; i < end; i += hn::Lanes(d)) filter.emit(d, block, i, sink);
    sink.flush();
    if (HWY_UNLIKELY(call.out.rgba8 != nullptr)) EncodePixels(call.out, first + begin, end - begin);
  }
}

/// Runs a filter over a batch; a RunFilter. Scattered texels are prefetched: streams prefetch an element when they
/// buffer it; for sinks without a buffer, the elements of the next vector of lookups are emitted to a PrefetchSink.
template <class Filter, class Sink = StreamSink>
HWY_NOINLINE size_t Run(const FilterCall& call) {
  constexpr size_t kLine = 16;  // lookups per cache line of a column
  const BatchTag d;
  const Filter filter(call.texture, call.sampler);
  const InputColumns columns(call.in);
  typename Filter::Block block;
  Sink sink(call);
  std::conditional_t<Sink::kBuffered, NoSink, PrefetchSink> prefetch(call);
  constexpr bool kRows = HasRows<Filter>::value && std::is_same_v<Sink, StreamSink>;
  std::conditional_t<kRows, RowRunner, NoSink> rows(call);
  size_t nonfinite = 0;
  for (size_t first = 0; first < call.in.count; first += kBlock) {
    nonfinite += call.in.count <= kBlock
                     ? FindShapes(call.texture, call.sampler, call.in, &block)  // without the time of a copy
                     : FindShapes(call.texture, call.sampler, block_of(call.in, first), &block);
    const bool scattered = Filter::is_scattered(call.texture, block);
    if constexpr (kRows) {
      for (size_t i = 0; i < block.count; i += kLine) columns.prefetch(first + kBlock + i);
      if (!rows.run(call, filter, block, first, scattered, &sink.rows())) {
        RunParts(call, filter, block, first, scattered, rows, sink);
      }
      continue;
    }
    sink.begin(first, scattered);
    for (size_t i = 0; i < block.count; i += hn::Lanes(d)) {
      if (i % kLine == 0) columns.prefetch(first + kBlock + i);  // the next block
      if constexpr (!Sink::kBuffered) {
        const size_t next = i + hn::Lanes(d);
        if (HWY_UNLIKELY(scattered && next < block.count)) filter.emit(d, block, next, prefetch);
      }
      filter.emit(d, block, i, sink);
    }
    sink.flush();
  }
  return nonfinite;
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_RUNNER_INL_H_
