// SPDX-License-Identifier: MIT
// Filters in fixed point: a sink that takes the quads of a filter as integer addresses and weights.

#if defined(SHD_TEXTURE_FIXED_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_FIXED_INL_H_
#undef SHD_TEXTURE_FIXED_INL_H_
#else
#define SHD_TEXTURE_FIXED_INL_H_
#endif

#include <hwy/highway.h>

#include "texture/filter/runner-inl.h"
#include "texture/format/fixed.h"
#include "texture/stream.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The two taps of one axis in units of 2^-13 texels. Their weights are kWeightOne - s and s.
template <class D>
struct FixedTaps {
  Ints<D> i0, i1;  // 0..size - 1
  Ints<D> s;       // 0..kWeightOne - 1
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
    return {i + (size.whole & hn::BroadcastSignBit(i)), hn::IfThenZeroElse(hn::Eq(next, size.whole), next),
            place & fraction};
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
  return {i, hn::Min(i + one, size.whole - one), place & fraction};
}

/// The same with the fraction rounded to 8 bits, as profiles of texture units do.
template <class D>
HWY_NOINLINE FixedTaps<D> WrapRounded(D d, shd_wrap wrap, hn::Vec<D> reduced, const AxisSize<D>& size) {
  LinearTaps<D> taps = WrapLinear(d, wrap, reduced, size);
  RoundWeights(d, &taps);
  const auto units = hn::Set(d, static_cast<float>(kWeightOne));
  return {taps.i0, taps.i1, hn::ConvertTo(hn::RebindToSigned<D>(), taps.s * units)};
}

/// Sums the quads of each vector of lookups as integers; a sink of Run(). With kProbes, the quads of an average have
/// equal shares: those of SHD_FILTER_ANISOTROPIC with equal weights. Otherwise there are at most two quads, and the
/// share of the second one blends them.
template <bool kProbes>
class FixedSink {
 public:
  static constexpr bool kBuffered = false;
  using D = BatchTag;

  explicit FixedSink(const FilterCall& call)
      : sampler_(call.sampler), source_(call.texture), kernels_(call.format.fixed), out_(call.out), count_(call.in.count) {}

  /// Begins the block of lookups whose first one is `first`.
  void begin(size_t first, bool) { done_ = first; }
  void flush() {}

  template <class... AnyShare>
  HWY_INLINE void quad(D d, uint32_t op, const Level<D>& level, hn::Vec<D> u, hn::Vec<D> v, const AnyShare&... share) {
    const hn::RebindToSigned<D> di;
    const bool second = kProbes ? (op & kSecond) != 0 : (op & kHow) != kStart;
    const FixedTaps<D> x = taps(d, sampler_.wrap_u, u, level.across), y = taps(d, sampler_.wrap_v, v, level.down);
    if (!second) add_row(d, op, share...);
    if (second) add_second(d, share...);
    const size_t at = 2 * (quads_.rows - 1) + (second ? 1 : 0);
    FixedQuad& quad = quads_.quad[at];
    const auto upper = RowIndex(d, level, y.i0), lower = RowIndex(d, level, y.i1);
    hn::Store(upper + x.i0, di, quad.upper);
    hn::Store(lower + x.i0, di, quad.lower);
    const auto one = hn::Set(di, kWeightOne);
    const auto w11 = hn::ShiftRight<kWeightBits>(x.s * y.s + hn::Set(di, kWeightOne / 2));
    const auto w01 = y.s - w11;
    hn::Store((one - x.s - w01) | hn::ShiftLeft<16>(x.s - w11), di, quad.upper_weights);
    hn::Store(w01 | hn::ShiftLeft<16>(w11), di, quad.lower_weights);
    const auto next = hn::Or(hn::Eq(x.i1, x.i0 + hn::Set(di, 1)), hn::Eq(x.s, hn::Zero(di)));
    if (HWY_LIKELY(hn::AllTrue(di, next))) return;
    quads_.split |= 1u << at;
    hn::Store(upper + x.i1, di, quad.upper_right);
    hn::Store(lower + x.i1, di, quad.lower_right);
  }

  HWY_INLINE void merge(D d, hn::Vec<D> fraction) { hn::Store(fraction, d, average_.fraction); }

  HWY_INLINE void finish() {
    const D d;
    sum();
    hn::Store(probes_, d, average_.probes);
    average_.two_sums = quads_.two_sums;
    kernels_.store(sums_, average_, count_ - done_, part_of(out_, done_));
    done_ += hn::Lanes(d);
  }

 private:
  HWY_INLINE FixedTaps<D> taps(D d, shd_wrap wrap, hn::Vec<D> reduced, const AxisSize<D>& size) const {
    if (HWY_UNLIKELY(sampler_.rounded_weights)) return WrapRounded(d, wrap, reduced, size);
    return WrapFixed(d, wrap, reduced, size);
  }

  /// Begins the quad of the next probe.
  HWY_INLINE void add_row(D d, uint32_t op) { add_row(d, op, hn::Set(d, 1.0f)); }
  HWY_INLINE void add_row(D d, uint32_t op, hn::Vec<D> share) {
    if ((op & kHow) == kStart) {
      quads_.two_sums = false;
      first_ = true;
      probes_ = summed_ = hn::Zero(d);
    } else if (HWY_UNLIKELY(quads_.rows == FixedQuads::kRows)) {
      sum();
    }
    probes_ = probes_ + hn::IfThenElseZero(hn::Gt(share, hn::Zero(d)), hn::Set(d, 1.0f));
    ++quads_.rows;
  }

  HWY_INLINE void add_second(D) { quads_.two_sums = true; }
  HWY_INLINE void add_second(D d, hn::Vec<D> share) {
    quads_.two_sums = true;
    if (!kProbes) hn::Store(share, d, average_.fraction);
  }

  /// Sums the quads so far.
  HWY_INLINE void sum() {
    const D d;
    const hn::RebindToSigned<D> di;
    hn::Store(hn::ConvertTo(di, probes_ - summed_), di, quads_.count);
    kernels_.sum(source_, quads_, hn::Lanes(d), first_, &sums_);
    first_ = false;
    summed_ = probes_;
    quads_.rows = 0;
    quads_.split = 0;
  }

  const Sampler& sampler_;
  const TexelSource source_;
  const FixedKernels kernels_;
  const Texels out_;
  const size_t count_;
  size_t done_ = 0;
  bool first_ = true;
  hn::Vec<D> probes_, summed_;  // quads of each lookup so far, and those of them that are in the sums
  FixedQuads quads_;
  FixedAverage average_;
  FixedSums sums_;
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_FIXED_INL_H_
