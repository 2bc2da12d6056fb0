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

#include "texture/block/place-inl.h"
#include "texture/filter/level-inl.h"
#include "texture/filter/prefetch.h"
#include "texture/footprint/shapes-inl.h"
#include "texture/stream.h"
#include "texture/tile/lease.h"
#include "texture/tile/place-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A share in a running average that depends on the point, with its derivatives in u and v.
template <class D>
struct Share {
  hn::Vec<D> value, rate_u, rate_v;
};

/// A share in a running average that depends on w, with its derivative in w.
template <class D>
struct DeepShare {
  hn::Vec<D> value, rate;
};

/// Four texels of a row of a level around a point, in the order of columns 1, 2, 0, 3.
template <class D>
struct Row {
  Ints<D> first, column[4];  // index of a texel of the texture, and the distances of the four texels from it
  Ints<D> y;                 // row of `level`, whose columns are `column`
  const Level<D>* level;     // null: the texture is not in tiles, and y is not set
  MaskOf<D> in[4];
  hn::Vec<D> share[3], rate[3];  // shares of the last three texels in their running average, and their derivatives
  bool neighbours;               // columns are adjacent
};

/// Base of sinks, to which filters emit elements. A Sink has these members:
///
///   add(d)         returns the position of a new element in elements()
///   commit(d, op)  completes the new element
///   finish()       marks the latest element as the last one of its vector of lookups
///   sampler()      the sampler
///   bordered()     texels may be the border colour
///   tiles()        null, or the lease of a texture in tiles, which takes rows and levels beside the columns
///   kTakesLines    takes whole lines of probes with equal weights
///   has_rates()    shares need their derivatives
///
/// Sinks of Run() also have begin() and flush() for each block of lookups, and kBuffered.
///
/// A share is a vector, a Share or a DeepShare. Elements that start an average have no share.
template <class Sink>
class Emitter {
 public:
  Emitter() = default;
  static constexpr bool kTakesLines = false;
  static constexpr TileLease* tiles() { return nullptr; }
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
    if (HWY_UNLIKELY(self().tiles() != nullptr)) {
      write_place(d, 0, at, x.i0, x.in0);
      write_place(d, 1, at, x.i1, x.in1);
      write_rows(d, at, level, y.i0, y.in0);
      write_row(d, 1, at, y.i1, y.in1);
      return self().commit(d, op);
    }
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

  /// Emits the quad of four given texels, none of which is the border.
  template <class D, class... AnyShare>
  HWY_INLINE void quad_of(D d, uint32_t op, const Ints<D> (&index)[4], hn::Vec<D> s, hn::Vec<D> t,
                          const AnyShare&... share) {
    const size_t at = self().add(d);
    auto& to = self().elements();
    hn::Store(s, d, to.s + at);
    hn::Store(t, d, to.t + at);
    for (size_t k = 0; k < 4; ++k) hn::Store(index[k], hn::RebindToSigned<D>(), to.index[k] + at);
    self().commit(d, op | kQuad | write_share(d, at, share...));
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
    const bool neighbours = row.neighbours && !self().bordered();
    if (HWY_UNLIKELY(self().tiles() != nullptr)) {
      for (size_t k = 0; k < 4; ++k) write_place(d, k, at, row.column[k], row.in[k]);
      write_rows(d, at, *row.level, row.y, hn::Eq(row.share[0], row.share[0]));
      return self().commit(d, neighbours ? op | kNeighbours : op);
    }
    if (HWY_LIKELY(neighbours)) {
      hn::Store(row.first + row.column[2], hn::RebindToSigned<D>(), to.index[2] + at);
      return self().commit(d, op | kNeighbours);
    }
    for (size_t k = 0; k < 4; ++k) write_texel(d, k, at, row.first + row.column[k], row.in[k]);
    self().commit(d, op);
  }

  /// Emits the texel of a level.
  template <class D, class... AnyShare>
  HWY_INLINE void texel(D d, uint32_t op, const Level<D>& level, Ints<D> x, Ints<D> y, MaskOf<D> in,
                        const AnyShare&... share) {
    if (HWY_LIKELY(self().tiles() == nullptr)) return texel(d, op, RowIndex(d, level, y) + x, in, share...);
    const size_t at = self().add(d);
    write_place(d, 0, at, x, in);
    write_rows(d, at, level, y, in);
    self().commit(d, op | write_share(d, at, share...));
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

  /// Write the place of a texel in its level, for a texture in tiles: -1 on the border.
  template <class D>
  HWY_INLINE void write_place(D, size_t k, size_t at, Ints<D> column, MaskOf<D> in) {
    const hn::RebindToSigned<D> di;
    hn::Store(hn::IfThenElse(hn::RebindMask(di, in), column, hn::Set(di, -1)), di, self().elements().index[k] + at);
  }
  template <class D>
  HWY_INLINE void write_row(D, size_t k, size_t at, Ints<D> y, MaskOf<D> in) {
    const hn::RebindToSigned<D> di;
    hn::Store(hn::IfThenElse(hn::RebindMask(di, in), y, hn::Set(di, -1)), di, self().tiles()->y[k] + at);
  }
  /// Writes the first row of an element, and its level.
  template <class D>
  HWY_INLINE void write_rows(D d, size_t at, const Level<D>& level, Ints<D> y, MaskOf<D> in) {
    const hn::RebindToSigned<D> di;
    write_row(d, 0, at, y, in);
    hn::Store(level.offset, di, self().tiles()->first_tile + at);
    hn::Store(level.across.whole, di, self().tiles()->width + at);
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
  template <class D>
  HWY_INLINE uint32_t write_share(D d, size_t at, const DeepShare<D>& share) {
    hn::Store(share.value, d, self().elements().share + at);
    if (HWY_LIKELY(!self().has_rates())) return 0;
    hn::Store(share.rate, d, self().elements().share_rate_u + at);
    return kDeep;
  }
};

/// Buffers elements and passes them to the consumers of a call whenever the buffer is full.
class StreamSink : public Emitter<StreamSink> {
 public:
  static constexpr bool kBuffered = true;

  explicit StreamSink(const FilterCall& call)
      : sampler_(call.sampler),
        bordered_(has_border(call.texture, call.sampler)),
        texture_(call.texture),
        blocks_(call.blocks),
        tiles_(call.tiles),
        placed_(call.blocks != nullptr || call.tiles != nullptr),
        first_(call, TexelSource(call), call.recording),
        second_(call, first_.texels, nullptr) {
    consume_first_ = call.record ? call.record : call.format.values;
    if (!call.record) consume_second_ = call.format.gradient;
    if (!call.record && !call.out.wants_values()) consume_first_ = nullptr;
    stream_.elements = 0;
  }

  HWY_INLINE const Sampler& sampler() const { return sampler_; }
  HWY_INLINE Stream& elements() { return stream_; }
  HWY_INLINE bool has_rates() const { return consume_second_ != nullptr; }
  HWY_INLINE bool bordered() const { return bordered_; }
  HWY_INLINE TileLease* tiles() const { return tiles_; }

  /// Begins the block of lookups whose first one is `first`. `scattered`: is_scattered() of the block.
  void begin(size_t first, bool scattered) {
    first_.done = second_.done = first;
    scattered_ = scattered && !placed_;
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
    } else if (op & kNeighbours && op & kQuad && HWY_LIKELY(!placed_)) {
      prefetch_ends(stream_.index[0] + e * hn::Lanes(d));
      prefetch_ends(stream_.index[2] + e * hn::Lanes(d));
    }
  }

  HWY_INLINE void finish() { stream_.op[stream_.elements - 1] |= kLast; }

  void flush() {
    const size_t end = stream_.elements;
    if (end == 0) return;
    stream_.elements = 0;
    if (HWY_UNLIKELY(placed_)) place(end);
    if (consume_first_) consume_first_(stream_, end, &first_);
    if (consume_second_) consume_second_(stream_, end, &second_);
  }

 private:
  /// Finds the places of texels in a cache.
  HWY_NOINLINE void place(size_t end) {
    if (blocks_) PlaceStream(texture_, blocks_, end, &stream_);
    if (tiles_) PlaceInTiles(tiles_, end, &stream_);
  }

  /// Prefetches the texels of the first and the last lookup of a vector: those between them are near.
  HWY_INLINE void prefetch_ends(const int32_t* index) const {
    const size_t lanes = hn::Lanes(BatchTag());
    __builtin_prefetch(first_.texels.texel(static_cast<uint32_t>(index[0])));
    if (lanes > 4) __builtin_prefetch(first_.texels.texel(static_cast<uint32_t>(index[lanes - 1])));
  }

  Stream stream_;
  const Sampler& sampler_;
  const bool bordered_;
  bool scattered_ = false;
  const Texture& texture_;
  BlockCache* const blocks_;
  TileLease* const tiles_;
  const bool placed_;
  Consume consume_first_, consume_second_ = nullptr;
  Consumption first_, second_;
};

/// Prefetches the texels of elements and drops them.
class PrefetchSink : public Emitter<PrefetchSink> {
 public:
  explicit PrefetchSink(const FilterCall& call) : sampler_(call.sampler), source_(call.texture) {}

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

/// Whether a filter can emit vectors of lookups on levels that a whole block shares.
template <class Filter, class = void>
struct SharesLevels : std::false_type {};
template <class Filter>
struct SharesLevels<Filter, std::void_t<decltype(&Filter::template levels_at<BatchTag>)>> : std::true_type {};

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
  size_t nonfinite = 0;
  for (size_t first = 0; first < call.in.count; first += kBlock) {
    nonfinite += call.in.count <= kBlock
                     ? FindShapes(call.texture, call.sampler, call.in, &block)  // without the time of a copy
                     : FindShapes(call.texture, call.sampler, block_of(call.in, first), &block);
    const bool scattered = Filter::is_scattered(call.texture, block);
    sink.begin(first, scattered);
    if constexpr (SharesLevels<Filter>::value) {
      if (block.one_lod && call.texture.layers == 1) {
        const auto levels = filter.levels_at(d, block, 0);
        for (size_t i = 0; i < block.count; i += hn::Lanes(d)) {
          if (i % kLine == 0) columns.prefetch(first + kBlock + i);
          filter.emit(d, block, i, levels, sink);
        }
        sink.flush();
        continue;
      }
    }
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
