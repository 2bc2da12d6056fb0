// SPDX-License-Identifier: MIT
// Where filters emit to: a buffer of elements that goes to the consumers whenever it is full.

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

template <class D>
class StreamSink {
 public:
  using V = hn::Vec<D>;

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

  /// Whether the lookups that follow lie all over a large texture.
  void set_scattered(bool scattered) { scattered_ = scattered; }

  HWY_INLINE void quad(D d, uint32_t op, const Quad<D>& q) {
    const size_t at = add(d, op | kQuad);
    const hn::RebindToSigned<D> di;
    hn::Store(q.x.s, d, stream_.s + at);
    hn::Store(q.y.s, d, stream_.t + at);
    if (HWY_UNLIKELY(stream_.has_rates)) {
      hn::Store(q.x.rate, d, stream_.rate_s + at);
      hn::Store(q.y.rate, d, stream_.rate_t + at);
    }
    if (HWY_LIKELY(!bordered_)) {
      hn::Store(q.index(0, 0), di, stream_.index[0] + at);
      hn::Store(q.index(0, 1), di, stream_.index[2] + at);
      if (HWY_LIKELY(hn::AllTrue(di, hn::Eq(q.x.i1, q.x.i0 + hn::Set(di, 1))))) {
        stream_.op[stream_.elements - 1] |= kNeighbours;
        return;
      }
      hn::Store(q.index(1, 0), di, stream_.index[1] + at);
      hn::Store(q.index(1, 1), di, stream_.index[3] + at);
      return;
    }
    for (size_t k = 0; k < 4; ++k) {
      hn::Store(TexelOrBorder(d, q.index(k % 2, k / 2), q.in(k % 2, k / 2)), di, stream_.index[k] + at);
    }
  }
  HWY_INLINE void quad(D d, uint32_t op, const Quad<D>& q, V share) {
    quad(d, op, q);
    set_share(d, share);
  }

  HWY_INLINE void texel(D d, uint32_t op, Ints<D> index, MaskOf<D> in) {
    const size_t at = add(d, op);
    const Ints<D> texel = HWY_UNLIKELY(bordered_) ? TexelOrBorder(d, index, in) : index;
    hn::Store(texel, hn::RebindToSigned<D>(), stream_.index[0] + at);
  }
  HWY_INLINE void texel(D d, uint32_t op, Ints<D> index, MaskOf<D> in, const Share<D>& share) {
    texel(d, op, index, in);
    set_share(d, share);
  }

  /// The second average into the first.
  HWY_INLINE void merge(D d, V share) {
    add(d, kMerge);
    set_share(d, share);
  }
  HWY_INLINE void merge(D d, const Share<D>& share) {
    add(d, kMerge);
    set_share(d, share);
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
  HWY_INLINE size_t add(D d, uint32_t op) {
    const size_t lanes = hn::Lanes(d);
    if (HWY_UNLIKELY((stream_.elements + 1) * lanes > Stream::kCapacity)) flush();
    stream_.op[stream_.elements] = static_cast<uint16_t>(op);
    return stream_.elements++ * lanes;
  }
  HWY_INLINE void set_share(D d, V share) {
    hn::Store(share, d, stream_.share + (stream_.elements - 1) * hn::Lanes(d));
  }
  HWY_INLINE void set_share(D d, const Share<D>& share) {
    const size_t at = (stream_.elements - 1) * hn::Lanes(d);
    hn::Store(share.value, d, stream_.share + at);
    if (HWY_LIKELY(!stream_.has_rates)) return;
    stream_.op[stream_.elements - 1] |= kRated;
    hn::Store(share.rate_u, d, stream_.share_rate_u + at);
    hn::Store(share.rate_v, d, stream_.share_rate_v + at);
  }

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
