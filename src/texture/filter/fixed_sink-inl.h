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
#include "texture/filter/anisotropic-inl.h"
#include "texture/filter/runner-inl.h"
#include "texture/format/fixed.h"
#include "texture/stream.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::RoundedProducts;
using simd::HWY_NAMESPACE::ToInt;
using simd::HWY_NAMESPACE::ToNearestInt;
using simd::HWY_NAMESPACE::TwiceLow;

/// The two taps of one axis. Their weights are 1 - s and s in fixed point.
template <class D>
struct FixedTaps {
  Ints<D> i0, i1;  // 0..size - 1
  Ints<D> s;       // fraction in units of 2^-kBits
};

/// One axis of a level. kBits: fraction bits of its coordinates.
template <class D, int kBits>
struct FixedAxis {
  static constexpr float kOne = static_cast<float>(1 << kBits), kHalf = 0.5f * kOne;
  hn::Vec<D> extent;   // size in units of 2^-kBits texels
  Ints<D> size, last;  // size - 1

  HWY_INLINE FixedAxis(D d, const AxisSize<D>& axis)
      : extent(axis.real * hn::Set(d, kOne)),
        size(axis.whole),
        last(axis.whole - hn::Set(hn::RebindToSigned<D>(), 1)) {}

  /// Returns the place of a reduced coordinate relative to the centre of texel 0, that of WrapLinear() with a rounded
  /// fraction. No wrap is SHD_WRAP_BORDER. All wraps but repeat are clamps of a folded coordinate.
  HWY_INLINE Ints<D> place(D d, shd_wrap wrap, hn::Vec<D> reduced) const {
    const auto half = hn::Set(d, kHalf);
    auto x = reduced * extent;
    if (HWY_UNLIKELY(wrap != SHD_WRAP_REPEAT)) {
      if (wrap == SHD_WRAP_MIRROR) {
        x = x + x;
        x = hn::Min(x, extent + extent - x);
      } else if (wrap == SHD_WRAP_MIRROR_ONCE) {
        x = hn::Abs(x);
      }
      x = hn::Min(hn::Max(x, half), extent - half);
    }
    return ToNearestInt(x - half);
  }
  /// Returns the first tap of a place: -1 becomes size - 1.
  HWY_INLINE Ints<D> first_tap(Ints<D> place) const {
    const hn::RebindToUnsigned<D> du;
    const hn::RebindToSigned<D> di;
    const auto i = hn::ShiftRight<kBits>(place);
    return hn::BitCast(di, hn::Min(hn::BitCast(du, i), hn::BitCast(du, i + size)));
  }
};

/// A level in fixed point.
template <class D>
struct FixedLevel {
  FixedAxis<D, kWeightBits> across;
  FixedAxis<D, kWeightBits + 1> down;
  Ints<D> offset;
  Ints<D> last_down;  // step from the last row to the next one

  HWY_INLINE FixedLevel(D d, shd_wrap wrap_v, const Level<D>& level)
      : across(d, level.across), down(d, level.down), offset(level.offset) {
    const auto none = hn::Zero(hn::RebindToSigned<D>());
    last_down = wrap_v == SHD_WRAP_REPEAT ? none - down.last * across.size : none;
  }
};

/// Writes the weights of a quad: s and t with kWeightBits and kWeightBits + 1 fraction bits.
template <class D>
HWY_INLINE void WriteWeights(D, Ints<D> s, Ints<D> t, int32_t* quad) {
  const hn::RebindToSigned<D> di;
  constexpr size_t kLanes = hn::MaxLanes(D());
  const auto both = (hn::Set(di, kWeightOne) - s) + hn::ShiftLeft<16>(s);
  const auto lower = RoundedProducts(both, TwiceLow(t));
  hn::Store(both - lower, di, quad + kUpperWeights * kLanes);
  hn::Store(lower, di, quad + kLowerWeights * kLanes);
}

/// Returns the taps with the fraction rounded to 8 bits, as profiles of texture units round it.
template <int kBits, class D>
HWY_INLINE FixedTaps<D> RoundedTaps(D d, shd_wrap wrap, hn::Vec<D> reduced, const AxisSize<D>& size) {
  LinearTaps<D> taps = WrapLinear(d, wrap, reduced, size);
  RoundWeights(d, &taps);
  return {taps.i0, taps.i1, ToInt(taps.s * hn::Set(d, static_cast<float>(1 << kBits)))};
}

/// Sums the quads of each vector of lookups as integers; a sink of Run(). It takes lines of probes with equal weights,
/// or at most two quads, which the share of the second one blends.
/// Vectors are buffered and summed together, so that the loads of their texels overlap.
class FixedSink {
 public:
  static constexpr bool kBuffered = false, kTakesLines = true;
  using D = BatchTag;

  explicit FixedSink(const FilterCall& call)
      : sampler_(call.sampler),
        repeats_(sampler_.wrap_u == SHD_WRAP_REPEAT && sampler_.wrap_v == SHD_WRAP_REPEAT && !sampler_.rounded_weights),
        source_(call.texture),
        kernels_(call.format.fixed),
        out_(call.out),
        end_(call.in.count) {
    const hn::RebindToSigned<D> di;
    for (FixedVector& vector : vectors_) hn::Store(hn::Set(di, 1), di, vector.count);
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

  /// Takes the quad of the only average, or the second quad, which is blended by its share.
  HWY_INLINE void quad(D d, uint32_t, const Level<D>& level, hn::Vec<D> u, hn::Vec<D> v) {
    begin_vector(false);
    current_->one_quad = true;
    quad(d, level, u, v, 0, free_);
    free_ += 2 * kQuad;
    current_->rows = 1;
  }
  HWY_INLINE void quad(D d, uint32_t, const Level<D>& level, hn::Vec<D> u, hn::Vec<D> v, hn::Vec<D> share) {
    current_->two_sums = true;
    hn::Store(share, d, current_->fraction);
    quad(d, level, u, v, 1, free_ - kQuad);
  }

  /// Takes the quads of lines of probes with equal weights.
  HWY_INLINE void line(D d, const ProbeLine<D>& line, const LevelPair<D>& levels) {
    begin_vector(levels.blended);
    current_->one_quad = false;
    hn::Store(line.probes, d, current_->probes);
    hn::Store(levels.fraction, d, current_->fraction);
    if (HWY_UNLIKELY(!repeats_)) {
      add_probes<false, true>(d, line, levels);
    } else if (levels.blended) {
      add_probes<true, true>(d, line, levels);
    } else {
      add_probes<true, false>(d, line, levels);
    }
    set_count();
  }

  HWY_INLINE void finish() {
    current_->at = next_;
    if (next_ % kLine == 0) prefetch_outputs();
    next_ += kLanes;
    if (++current_ == vectors_ + kVectors) flush();
  }

 private:
  static constexpr size_t kLanes = hn::MaxLanes(D()), kQuad = kFixedColumns * kLanes;
  static constexpr size_t kVectors = 8, kRows = 32;  // 2 * kRows bits of FixedVector::split
  static constexpr size_t kLine = 16;                // lookups per cache line of an output

  /// Begins a vector of lookups.
  HWY_INLINE void begin_vector(bool two_sums) {
    if (HWY_UNLIKELY(free_ == pool_end())) flush();
    current_->quads = free_;
    current_->rows = 0;
    current_->split = 0;
    current_->two_sums = two_sums;
    current_->first = true;
    summed_ = 0;
  }

  HWY_INLINE void quad(D d, const Level<D>& level, hn::Vec<D> u, hn::Vec<D> v, size_t which, int32_t* quad) {
    current_->split |= uint64_t{write(d, level, {d, sampler_.wrap_v, level}, sampler_.wrap_u, u, v, quad)} << which;
  }

  /// Adds the quads of lines. kRepeat: both wraps are SHD_WRAP_REPEAT, and weights are not rounded. kTwoSums: both
  /// levels are read if they are blended.
  template <bool kRepeat, bool kTwoSums>
  HWY_INLINE void add_probes(D d, const ProbeLine<D>& line, const LevelPair<D>& levels) {
    const shd_wrap wrap_u = kRepeat ? SHD_WRAP_REPEAT : sampler_.wrap_u;
    const shd_wrap wrap_v = kRepeat ? SHD_WRAP_REPEAT : sampler_.wrap_v;
    const bool two_sums = kTwoSums && (kRepeat || levels.blended);
    const FixedLevel<D> high(d, wrap_v, levels.high), low(d, wrap_v, two_sums ? levels.low : levels.high);
    const auto two = hn::Set(d, 2.0f), last = line.probes - hn::Set(d, 1.0f);
    auto position = hn::Neg(last);
    auto missing = static_cast<size_t>(hn::GetLane(hn::MaxOfLanes(d, line.probes)));
    for (;;) {
      const size_t room = static_cast<size_t>(pool_end() - free_) / (2 * kQuad);
      const size_t rows = missing < room ? missing : room;
      uint64_t split = 0;
      for (size_t row = 0; row < rows; ++row) {
        const auto u = ProbeLine<D>::at(wrap_u, line.u, position, line.step_u);
        const auto v = ProbeLine<D>::at(wrap_v, line.v, position, line.step_v);
        split |= uint64_t{write<kRepeat>(d, levels.high, high, wrap_u, u, v, free_)} << (2 * row);
        if (two_sums)
          split |= uint64_t{write<kRepeat>(d, levels.low, low, wrap_u, u, v, free_ + kQuad)} << (2 * row + 1);
        position = hn::Min(position + two, last);  // finished lanes repeat their last probe, which is not added
        free_ += 2 * kQuad;
      }
      current_->rows = rows;
      current_->split = split;
      missing -= rows;
      if (HWY_LIKELY(missing == 0)) return;
      sum_early();
    }
  }

  /// Writes a quad. Returns whether it is split.
  template <bool kRepeat = false>
  HWY_INLINE bool write(D d, const Level<D>& plain, const FixedLevel<D>& level, shd_wrap wrap_u, hn::Vec<D> u,
                        hn::Vec<D> v, int32_t* HWY_RESTRICT quad) const {
    const hn::RebindToSigned<D> di;
    if (HWY_UNLIKELY(!kRepeat && sampler_.rounded_weights)) return write_rounded(d, plain, u, v, quad);
    const auto x = level.across.place(d, wrap_u, u);
    const auto y = level.down.place(d, kRepeat ? SHD_WRAP_REPEAT : sampler_.wrap_v, v);
    const auto i = level.across.first_tap(x), j = level.down.first_tap(y);
    const auto upper = j * level.across.size + (level.offset + i);
    const auto lower = upper + hn::IfThenElse(hn::Eq(j, level.down.last), level.last_down, level.across.size);
    hn::Store(upper, di, quad + kUpper * kLanes);
    hn::Store(lower, di, quad + kLower * kLanes);
    prefetch(quad[kUpper * kLanes]);
    prefetch(quad[kLower * kLanes]);
    WriteWeights(d, x & hn::Set(di, kWeightOne - 1), y & hn::Set(di, 2 * kWeightOne - 1), quad);
    const auto at_end = hn::Eq(i, level.across.last);
    if (HWY_LIKELY(hn::AllFalse(di, at_end) || wrap_u != SHD_WRAP_REPEAT)) return false;
    const auto right = hn::IfThenElse(at_end, hn::Neg(i), hn::Set(di, 1));
    hn::Store(upper + right, di, quad + kUpperRight * kLanes);
    hn::Store(lower + right, di, quad + kLowerRight * kLanes);
    return true;
  }

  /// Prefetches the lines of the outputs that are stored soon: 1.1 of the speed of trilinear on AVX-512.
  HWY_INLINE void prefetch_outputs() const {
    constexpr size_t kAhead = 128;
    for (float* channel : out_.channel) {
      if (channel) __builtin_prefetch(channel + next_ + kAhead, 1);
    }
  }

  /// Prefetches a texel, which is read when the buffer is full. The first texel of a vector is enough: those of all
  /// lanes are not faster.
  HWY_INLINE void prefetch(int32_t index) const {
    __builtin_prefetch(source_.origin + size_t{static_cast<uint32_t>(index)} * source_.texel_size);
  }

  HWY_NOINLINE bool write_rounded(D d, const Level<D>& level, hn::Vec<D> u, hn::Vec<D> v, int32_t* quad) const {
    const hn::RebindToSigned<D> di;
    const auto x = RoundedTaps<kWeightBits>(d, sampler_.wrap_u, u, level.across);
    const auto y = RoundedTaps<kWeightBits + 1>(d, sampler_.wrap_v, v, level.down);
    const auto upper = RowIndex(d, level, y.i0), lower = RowIndex(d, level, y.i1);
    hn::Store(upper + x.i0, di, quad + kUpper * kLanes);
    hn::Store(lower + x.i0, di, quad + kLower * kLanes);
    WriteWeights(d, x.s, y.s, quad);
    hn::Store(upper + x.i1, di, quad + kUpperRight * kLanes);
    hn::Store(lower + x.i1, di, quad + kLowerRight * kLanes);
    return true;
  }

  /// Writes the number of rows of each lookup in the buffer.
  HWY_INLINE void set_count() {
    const D d;
    const hn::RebindToSigned<D> di;
    const auto left = ToInt(hn::Load(d, current_->probes)) - hn::Set(di, static_cast<int32_t>(summed_));
    const auto rows = hn::Set(di, static_cast<int32_t>(current_->rows));
    hn::Store(hn::Min(hn::Max(left, hn::Zero(di)), rows), di, current_->count);
  }

  /// Makes room for further quads of the current vector: sums those of all vectors.
  HWY_NOINLINE void sum_early() {
    set_count();
    const auto whole = static_cast<size_t>(current_ - vectors_);
    kernels_.sum(source_, vectors_, whole + 1);
    kernels_.store(vectors_, whole, end_, out_);
    if (whole > 0) vectors_[0] = *current_;
    current_ = vectors_;
    summed_ += current_->rows;
    current_->quads = free_ = pool_;
    current_->first = false;
  }

  const int32_t* pool_end() const { return pool_ + 2 * kRows * kQuad; }

  const Sampler& sampler_;
  const bool repeats_;  // both wraps are SHD_WRAP_REPEAT, and weights are not rounded
  const TexelSource source_;
  const FixedKernels kernels_;
  const Texels out_;
  const size_t end_;
  size_t next_ = 0;    // first lookup of the current vector
  size_t summed_ = 0;  // rows of the current vector that are in the sums
  FixedVector vectors_[kVectors];
  FixedVector* current_ = vectors_;
  alignas(64) int32_t pool_[2 * kRows * kQuad];  // quads of the vectors, in pairs
  int32_t* free_ = pool_;
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_FIXED_SINK_INL_H_
