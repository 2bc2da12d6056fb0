// SPDX-License-Identifier: MIT
// Filters in fixed point: a sink that takes the quads of a filter as integer addresses and weights.

#if defined(SHD_TEXTURE_FIXED_SINK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_FIXED_SINK_INL_H_
#undef SHD_TEXTURE_FIXED_SINK_INL_H_
#else
#define SHD_TEXTURE_FIXED_SINK_INL_H_
#endif

#include <hwy/highway.h>

#include "simd/integer-inl.h"
#include "texture/filter/runner-inl.h"
#include "texture/format/fixed.h"
#include "texture/stream.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::ShortProduct;

/// The two taps of one axis in units of 2^-13 texels. Their weights are kWeightOne - s and s.
template <class D>
struct FixedTaps {
  Ints<D> i0, i1;  // 0..size - 1
  Ints<D> s;       // 0..kWeightOne - 1
  bool adjacent;   // i1 is i0 + 1, or s is 0
};

/// Returns the taps of a reduced coordinate, which are those of WrapLinear() with a rounded fraction. No wrap is
/// SHD_WRAP_BORDER. All wraps but repeat are clamps of a folded coordinate.
template <class D>
HWY_INLINE FixedTaps<D> WrapFixed(D d, shd_wrap wrap, hn::Vec<D> reduced, const AxisSize<D>& size) {
  using V = hn::Vec<D>;
  const hn::RebindToSigned<D> di;
  const V half_texel = hn::Set(d, kWeightOne / 2.0f), half = hn::Set(d, 0.5f);
  const V extent = size.real * hn::Set(d, static_cast<float>(kWeightOne));
  const auto fraction = hn::Set(di, kWeightOne - 1), one = hn::Set(di, 1);
  V x = reduced * extent;
  if (HWY_LIKELY(wrap == SHD_WRAP_REPEAT)) {
    const auto place = hn::ConvertTo(di, x + half) - hn::Set(di, kWeightOne / 2);
    const auto i = hn::ShiftRight<kWeightBits>(place), next = i + one;  // i: -1..size - 1
    const auto i0 = i + (size.whole & hn::BroadcastSignBit(i));
    const bool adjacent = hn::AllFalse(di, hn::Eq(i0, size.whole - one));
    return {i0, hn::IfThenZeroElse(hn::Eq(next, size.whole), next), place & fraction, adjacent};
  }
  if (wrap == SHD_WRAP_MIRROR) {
    x = x + x;
    x = hn::Min(x, extent + extent - x);
  } else if (wrap == SHD_WRAP_MIRROR_ONCE) {
    x = hn::Abs(x);
  }
  x = hn::Min(hn::Max(x, half_texel), extent - half_texel);
  const auto place = hn::ConvertTo(di, x + half) - hn::Set(di, kWeightOne / 2);
  const auto i = hn::ShiftRight<kWeightBits>(place);
  return {i, hn::Min(i + one, size.whole - one), place & fraction, true};
}

/// Returns the taps with the fraction rounded to 8 bits, as profiles of texture units round it.
template <class D>
HWY_NOINLINE FixedTaps<D> WrapRounded(D d, shd_wrap wrap, hn::Vec<D> reduced, const AxisSize<D>& size) {
  const hn::RebindToSigned<D> di;
  LinearTaps<D> taps = WrapLinear(d, wrap, reduced, size);
  RoundWeights(d, &taps);
  const auto s = hn::ConvertTo(di, taps.s * hn::Set(d, static_cast<float>(kWeightOne)));
  return {taps.i0, taps.i1, s, hn::AllTrue(di, hn::Eq(taps.i1, taps.i0 + hn::Set(di, 1)))};
}

/// Sums the quads of each vector of lookups as integers; a sink of Run(). With kProbes, the quads of an average have
/// equal shares: those of SHD_FILTER_ANISOTROPIC with equal weights. Otherwise there are at most two quads, and the
/// share of the second one blends them.
/// Vectors are buffered and summed together, so that the loads of their texels overlap.
template <bool kProbes>
class FixedSink {
 public:
  static constexpr bool kBuffered = false;
  using D = BatchTag;

  explicit FixedSink(const FilterCall& call)
      : sampler_(call.sampler),
        source_(call.texture),
        kernels_(call.format.fixed),
        out_(call.out),
        end_(call.in.count) {
    const D d;
    for (FixedVector& vector : vectors_) {
      hn::Store(hn::Set(d, 1.0f), d, vector.probes);
      hn::Store(hn::Set(hn::RebindToSigned<D>(), 1), hn::RebindToSigned<D>(), vector.count);
    }
  }

  /// Begins the block of lookups whose first one is `first`.
  void begin(size_t first, bool) { next_ = first; }
  void flush() {
    if (current_ == vectors_) return;
    const auto count = static_cast<size_t>(current_ - vectors_);
    kernels_.sum(source_, vectors_, count);
    kernels_.store(vectors_, count, end_, out_);
    current_ = vectors_;
    free_ = pool_;
  }

  template <class... AnyShare>
  HWY_INLINE void quad(D d, uint32_t op, const Level<D>& level, hn::Vec<D> u, hn::Vec<D> v, const AnyShare&... share) {
    const hn::RebindToSigned<D> di;
    const bool second = kProbes ? (op & kSecond) != 0 : (op & kHow) != kStart;
    const FixedTaps<D> x = taps(d, sampler_.wrap_u, u, level.across), y = taps(d, sampler_.wrap_v, v, level.down);
    if (!second) add_row(d, op, share...);
    if (second) add_second(d, share...);
    int32_t* const quad = second ? free_ - kQuad : free_ - 2 * kQuad;
    const auto upper = RowIndex(d, level, y.i0), lower = RowIndex(d, level, y.i1);
    hn::Store(upper + x.i0, di, quad + kUpper * kLanes);
    hn::Store(lower + x.i0, di, quad + kLower * kLanes);
    const auto w11 = hn::ShiftRight<kWeightBits>(ShortProduct(x.s, y.s) + hn::Set(di, kWeightOne / 2));
    const auto w01 = y.s - w11;
    hn::Store((hn::Set(di, kWeightOne) - x.s - w01) | hn::ShiftLeft<16>(x.s - w11), di, quad + kUpperWeights * kLanes);
    hn::Store(w01 | hn::ShiftLeft<16>(w11), di, quad + kLowerWeights * kLanes);
    if (HWY_LIKELY(x.adjacent)) return;
    current_->split |= uint64_t{1} << (2 * current_->rows - (second ? 1 : 2));
    hn::Store(upper + x.i1, di, quad + kUpperRight * kLanes);
    hn::Store(lower + x.i1, di, quad + kLowerRight * kLanes);
  }

  HWY_INLINE void merge(D d, hn::Vec<D> fraction) { hn::Store(fraction, d, current_->fraction); }

  HWY_INLINE void finish() {
    const D d;
    if (kProbes) {
      set_count();
      hn::Store(probes_, d, current_->probes);
    }
    current_->at = next_;
    next_ += kLanes;
    if (++current_ == vectors_ + kVectors) flush();
  }

 private:
  static constexpr size_t kLanes = hn::MaxLanes(D()), kQuad = kFixedColumns * kLanes;
  static constexpr size_t kVectors = 8, kRows = 32;  // 2 * kRows bits of FixedVector::split

  HWY_INLINE FixedTaps<D> taps(D d, shd_wrap wrap, hn::Vec<D> reduced, const AxisSize<D>& size) const {
    if (HWY_UNLIKELY(sampler_.rounded_weights)) return WrapRounded(d, wrap, reduced, size);
    return WrapFixed(d, wrap, reduced, size);
  }

  /// Begins the first quad of a vector of lookups.
  HWY_INLINE void add_row(D, uint32_t) {
    if (HWY_UNLIKELY(free_ == pool_ + 2 * kRows * kQuad)) flush();
    current_->quads = free_;
    free_ += 2 * kQuad;
    current_->rows = 1;
    current_->split = 0;
    current_->two_sums = false;
    current_->first = true;
  }
  /// Begins the quad of the next probe.
  HWY_INLINE void add_row(D d, uint32_t op, hn::Vec<D> share) {
    if ((op & kHow) == kStart) {
      add_row(d, op);
      summed_ = hn::Zero(d);
      probes_ = hn::Set(d, 1.0f);
      return;
    }
    if (HWY_UNLIKELY(free_ == pool_ + 2 * kRows * kQuad)) sum_early();
    probes_ = probes_ + hn::IfThenElseZero(hn::Gt(share, hn::Zero(d)), hn::Set(d, 1.0f));
    free_ += 2 * kQuad;
    ++current_->rows;
  }

  HWY_INLINE void add_second(D) { current_->two_sums = true; }
  HWY_INLINE void add_second(D d, hn::Vec<D> share) {
    current_->two_sums = true;
    if (!kProbes) hn::Store(share, d, current_->fraction);
  }

  HWY_INLINE void set_count() {
    const hn::RebindToSigned<D> di;
    hn::Store(hn::ConvertTo(di, probes_ - summed_), di, current_->count);
  }

  /// Makes room for further quads of the current vector: sums those of all vectors.
  HWY_NOINLINE void sum_early() {
    set_count();
    const auto whole = static_cast<size_t>(current_ - vectors_);
    kernels_.sum(source_, vectors_, whole + 1);
    kernels_.store(vectors_, whole, end_, out_);
    if (whole > 0) vectors_[0] = *current_;
    current_ = vectors_;
    current_->quads = free_ = pool_;
    current_->rows = current_->split = 0;
    current_->first = false;
    summed_ = probes_;
  }

  const Sampler& sampler_;
  const TexelSource source_;
  const FixedKernels kernels_;
  const Texels out_;
  const size_t end_;
  size_t next_ = 0;             // first lookup of the current vector
  hn::Vec<D> probes_, summed_;  // quads of each lookup so far, and those of them that are in the sums
  FixedVector vectors_[kVectors];
  FixedVector* current_ = vectors_;
  alignas(64) int32_t pool_[2 * kRows * kQuad];  // quads of the vectors, in pairs
  int32_t* free_ = pool_;
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_FIXED_SINK_INL_H_
