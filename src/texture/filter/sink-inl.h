// SPDX-License-Identifier: MIT
// Where filters emit to.

#if defined(SHD_TEXTURE_SINK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_SINK_INL_H_
#undef SHD_TEXTURE_SINK_INL_H_
#else
#define SHD_TEXTURE_SINK_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/filter/level-inl.h"
#include "texture/filter/prefetch.h"
#include "texture/stream.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A share of a running average, with its change in u and v where it depends on the point.
template <class D>
struct Share {
  hn::Vec<D> value, rate_u, rate_v;
};

/// Writes a quad as the element at `at`; returns its flags.
template <class D, class Elements>
HWY_INLINE uint32_t WriteQuad(D d, const Quad<D>& q, bool bordered, size_t at, Elements* to) {
  const hn::RebindToSigned<D> di;
  hn::Store(q.x.s, d, to->s + at);
  hn::Store(q.y.s, d, to->t + at);
  if (HWY_UNLIKELY(to->has_rates)) {
    hn::Store(q.x.rate, d, to->rate_s + at);
    hn::Store(q.y.rate, d, to->rate_t + at);
  }
  if (HWY_UNLIKELY(bordered)) {
    for (size_t k = 0; k < 4; ++k) {
      hn::Store(TexelOrBorder(d, q.index(k % 2, k / 2), q.in(k % 2, k / 2)), di, to->index[k] + at);
    }
    return kQuad;
  }
  hn::Store(q.index(0, 0), di, to->index[0] + at);
  hn::Store(q.index(0, 1), di, to->index[2] + at);
  if (HWY_LIKELY(hn::AllTrue(di, hn::Eq(q.x.i1, q.x.i0 + hn::Set(di, 1))))) return kQuad | kNeighbours;
  hn::Store(q.index(1, 0), di, to->index[1] + at);
  hn::Store(q.index(1, 1), di, to->index[3] + at);
  return kQuad;
}

/// Four texels of a row of a level around a point, columns 1, 2, 0 and 3, with the shares of the last three in their
/// running average.
template <class D>
struct Row {
  Ints<D> index[4];
  MaskOf<D> in[4];
  hn::Vec<D> share[3], rate[3];
  bool neighbours;  // columns are side by side in memory
};

/// Writes a row as the element at `at`; returns its flags.
template <class D, class Elements>
HWY_INLINE uint32_t WriteRow(D d, const Row<D>& row, bool bordered, size_t at, Elements* to) {
  const hn::RebindToSigned<D> di;
  float* const shares[3] = {to->s, to->t, to->r};
  float* const rates[3] = {to->rate_s, to->rate_t, to->rate_r};
  for (size_t k = 0; k < 3; ++k) {
    hn::Store(row.share[k], d, shares[k] + at);
    if (HWY_UNLIKELY(to->has_rates)) hn::Store(row.rate[k], d, rates[k] + at);
  }
  if (HWY_LIKELY(row.neighbours && !bordered)) {
    hn::Store(row.index[2], di, to->index[2] + at);
    return kRow | kNeighbours;
  }
  for (size_t k = 0; k < 4; ++k) {
    const auto texel = HWY_UNLIKELY(bordered) ? TexelOrBorder(d, row.index[k], row.in[k]) : row.index[k];
    hn::Store(texel, di, to->index[k] + at);
  }
  return kRow;
}

/// Writes a single texel.
template <class D, class Elements>
HWY_INLINE void WriteTexel(D d, Ints<D> index, MaskOf<D> in, bool bordered, size_t at, Elements* to) {
  const Ints<D> texel = HWY_UNLIKELY(bordered) ? TexelOrBorder(d, index, in) : index;
  hn::Store(texel, hn::RebindToSigned<D>(), to->index[0] + at);
}

template <class D, class Elements>
HWY_INLINE uint32_t WriteShare(D d, hn::Vec<D> share, size_t at, Elements* to) {
  hn::Store(share, d, to->share + at);
  return 0;
}
template <class D, class Elements>
HWY_INLINE uint32_t WriteShare(D d, const Share<D>& share, size_t at, Elements* to) {
  hn::Store(share.value, d, to->share + at);
  if (HWY_LIKELY(!to->has_rates)) return 0;
  hn::Store(share.rate_u, d, to->share_rate_u + at);
  hn::Store(share.rate_v, d, to->share_rate_v + at);
  return kRated;
}

/// A buffer of elements that goes to the consumers of a call whenever it is full.
template <class D>
class StreamSink {
 public:
  explicit StreamSink(const FilterCall& call)
      : bordered_(has_border(call.sampler)),
        first_{TexelSource(call.texture), call.sampler, call.recording, call.out, call.in.count, 0, false, {}},
        second_{TexelSource(call.texture), call.sampler, nullptr, call.out, call.in.count, 0, false, {}} {
    consume_first_ = call.record ? call.record : bordered_ ? call.format.bordered : call.format.values;
    if (!call.record && call.out.wants_gradient()) consume_second_ = call.format.gradient;
    if (!call.record && !call.out.wants_values()) consume_first_ = nullptr;
    stream_.elements = 0;
    stream_.has_rates = consume_second_ != nullptr;
  }
  StreamSink(const StreamSink&) = delete;
  StreamSink& operator=(const StreamSink&) = delete;

  /// Whether shares need their rates.
  HWY_INLINE bool has_rates() const { return stream_.has_rates; }

  /// Lookups from `first` on follow; whether they lie all over a large texture.
  void begin(size_t first, bool scattered) {
    first_.done = second_.done = first;
    scattered_ = scattered;
  }

  HWY_INLINE void quad(D d, uint32_t op, const Quad<D>& q) {
    const size_t at = add(d);
    set_op(op | WriteQuad(d, q, bordered_, at, &stream_));
  }
  HWY_INLINE void quad(D d, uint32_t op, const Quad<D>& q, hn::Vec<D> share) {
    const size_t at = add(d);
    WriteShare(d, share, at, &stream_);
    set_op(op | WriteQuad(d, q, bordered_, at, &stream_));
  }
  template <class AnyShare>
  HWY_INLINE void row(D d, uint32_t op, const Row<D>& r, const AnyShare& share) {
    const size_t at = add(d);
    set_op(op | WriteRow(d, r, bordered_, at, &stream_) | WriteShare(d, share, at, &stream_));
  }
  HWY_INLINE void texel(D d, uint32_t op, Ints<D> index, MaskOf<D> in) {
    WriteTexel(d, index, in, bordered_, add(d), &stream_);
    set_op(op);
  }
  HWY_INLINE void texel(D d, uint32_t op, Ints<D> index, MaskOf<D> in, const Share<D>& share) {
    const size_t at = add(d);
    WriteTexel(d, index, in, bordered_, at, &stream_);
    set_op(op | WriteShare(d, share, at, &stream_));
  }
  /// The second average into the first.
  template <class AnyShare>
  HWY_INLINE void merge(D d, const AnyShare& share) {
    const size_t at = add(d);
    set_op(kMerge | WriteShare(d, share, at, &stream_));
  }
  /// The last element was the last of its lookups.
  HWY_INLINE void finish() { stream_.op[stream_.elements - 1] |= kLast; }

  void flush() {
    const size_t end = stream_.elements, lanes = hn::Lanes(D());
    stream_.elements = 0;
    if (!scattered_) return consume(0, end);
    // Part by part, the next one on its way from memory while one is consumed.
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
  /// Place of a new element.
  HWY_INLINE size_t add(D d) {
    const size_t lanes = hn::Lanes(d);
    if (HWY_UNLIKELY((stream_.elements + 1) * lanes > Stream::kCapacity)) flush();
    return stream_.elements++ * lanes;
  }
  HWY_INLINE void set_op(uint32_t op) { stream_.op[stream_.elements - 1] = static_cast<uint16_t>(op); }

  Stream stream_;
  const bool bordered_;
  bool scattered_ = false;
  Consume consume_first_, consume_second_ = nullptr;
  Consumption first_, second_;
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_SINK_INL_H_
