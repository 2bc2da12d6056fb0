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
      : texture_(call.texture),
        bordered_(has_border(call.sampler)),
        first_{call.texture, call.sampler, call.recording, call.out, call.in.count, 0, false, {}},
        second_{call.texture, call.sampler, nullptr, call.out, call.in.count, 0, false, {}} {
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
    if (stream_.elements == 0) return;
    if (scattered_) prefetch_stream(texture_, stream_, hn::Lanes(D()));
    if (consume_first_) consume_first_(stream_, &first_);
    if (consume_second_) consume_second_(stream_, &second_);
    stream_.elements = 0;
  }

 private:
  /// Place of a new element.
  HWY_INLINE size_t add(D d) {
    const size_t lanes = hn::Lanes(d);
    if (HWY_UNLIKELY((stream_.elements + 1) * lanes > Stream::kCapacity)) flush();
    return stream_.elements++ * lanes;
  }
  HWY_INLINE void set_op(uint32_t op) { stream_.op[stream_.elements - 1] = static_cast<uint16_t>(op); }

  Stream stream_;
  const Texture& texture_;
  const bool bordered_;
  bool scattered_ = false;
  Consume consume_first_, consume_second_ = nullptr;
  Consumption first_, second_;
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_SINK_INL_H_
