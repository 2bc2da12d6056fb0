// SPDX-License-Identifier: MIT
// Anisotropic lookups with SHD_PRECISION_FAST: the filter and 16-bit blends (format/fixed-inl.h), compiled together.
// The quads of a vector of lookups are summed by lanes as the filter finds them, in units of 1/16 of a code. The sums
// of 16 probes fit in 16 bits.
// A probe has an error of at most 3 + 4 units of a quad. Its place has a rounded beginning and k rounded steps, k < 16:
// at most 0.5 + 3.75 units of 2^-15 texels on each axis, in the mean. This is 4.8e-4 of the range in all.
#include "texture/stream.h"

#define SHD_FORMAT_KERNELS
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/lookup/fixed_lines.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "simd/round-inl.h"
#include "texture/filter/anisotropic-inl.h"
#include "texture/filter/runner-inl.h"
#include "texture/format/consume_rows-inl.h"
#include "texture/format/fixed-inl.h"
#include "texture/format/unorm8-inl.h"
#include "texture/lookup/fixed_lines-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::RoundedProducts;
using simd::HWY_NAMESPACE::RoundNearest;
using simd::HWY_NAMESPACE::ToNearestInt;
namespace {

constexpr int32_t kPart = 16;  // probes whose sums fit in 16 bits

/// The steps of lines of probes on axes that repeat, and their first probes, in the period.
template <class D>
struct RepeatedLine {
  hn::Vec<D> u, v;            // [0, 1]
  hn::Vec<D> step_u, step_v;  // [-1/2, 1/2]

  /// `first`: number of the first probe.
  HWY_INLINE RepeatedLine(D d, const ProbeLine<D>& line, int32_t first) {
    const auto position = hn::Set(d, static_cast<float>(2 * first + 1)) - line.probes;
    const auto in_period = [](hn::Vec<D> x) SHD_INLINE_LAMBDA { return x - RoundDown(x); };
    const auto short_step = [](hn::Vec<D> half) SHD_INLINE_LAMBDA {
      const auto step = half + half;
      return step - RoundNearest(step);
    };
    u = in_period(line.u + position * line.step_u);
    v = in_period(line.v + position * line.step_v);
    step_u = short_step(line.step_u);
    step_v = short_step(line.step_v);
  }
};

/// Places of probes on an axis that repeats: integers in units of 2^-15 texels from the centre of texel 0. They are
/// unsigned, because a period of 65536 texels has 2^31 units.
template <class D>
struct RepeatedAxis {
  Ints<D> place, step;   // place: 0..period - 1
  Ints<D> period, last;  // last texel
  hn::Mask<D> inside;    // no place is beyond the first or the last texel

  /// `steps`: those that follow.
  HWY_INLINE RepeatedAxis(D d, const AxisSize<D>& size, hn::Vec<D> begin, hn::Vec<D> of_step, int32_t steps)
      : period(hn::ShiftLeft<15>(size.whole)), last(size.whole - hn::Set(hn::RebindToSigned<D>(), 1)) {
    const auto extent = size.real * hn::Set(d, 0x1p15f), texel = hn::Set(d, 0x1p15f);
    const auto from = begin * extent - hn::Set(d, 0x1p14f), by = of_step * extent;
    place = in_period(ToNearestInt(from));
    step = ToNearestInt(by);
    const auto to = from + by * hn::Set(d, static_cast<float>(steps));  // a texel is more than all errors of this
    inside = hn::And(hn::Ge(hn::Min(from, to), texel), hn::Le(hn::Max(from, to), extent - (texel + texel)));
  }
  /// kInside: all lanes are inside.
  template <bool kInside>
  HWY_INLINE void advance() {
    const hn::RebindToUnsigned<D> du;
    const hn::RebindToSigned<D> di;
    const auto next = place + (kInside ? step : in_period(step));  // below 2^32
    if constexpr (kInside) {
      place = next;
      return;
    }
    place = hn::BitCast(di, hn::Min(hn::BitCast(du, next), hn::BitCast(du, next - period)));
  }
  HWY_INLINE Ints<D> texel() const {
    const hn::RebindToUnsigned<D> du;
    return hn::BitCast(hn::RebindToSigned<D>(), hn::ShiftRight<15>(hn::BitCast(du, place)));
  }
  HWY_INLINE Ints<D> fraction() const { return TwiceLow(place & hn::Set(hn::RebindToSigned<D>(), 0x7fff)); }

 private:
  HWY_INLINE Ints<D> in_period(Ints<D> x) const { return x + (period & hn::BroadcastSignBit(x)); }
};

/// Sums of the probes of one level in units of 1/16 of a code.
template <class D>
struct LineSums {
  Ints<D> channel[4];

  /// Adds the halves of sums of kPart probes. `first`: the sums are not set before.
  HWY_INLINE void add(D d, bool first, const ChannelPairs<D>& sums) {
    const auto zero = hn::Zero(hn::RebindToSigned<D>());
    channel[0] = (first ? zero : channel[0]) + HalfOf<0>(d, sums);
    channel[1] = (first ? zero : channel[1]) + HalfOf<1>(d, sums);
    channel[2] = (first ? zero : channel[2]) + HalfOf<2>(d, sums);
    channel[3] = (first ? zero : channel[3]) + HalfOf<3>(d, sums);
  }
};

/// Adds a quad to sums in the active lanes.
template <class D>
HWY_INLINE void AddQuad(D d, const Ints<D> (&texel)[4], Ints<D> s, Ints<D> t, Ints<D> active, ChannelPairs<D>* sums) {
  const auto eighth = hn::Set(hn::RebindToSigned<D>(), 0x10001000) & active;  // in units of 2^-15
  const ChannelPairs<D> quad = BlendQuad<true>(d, texel, s, t);
  sums->even = sums->even + RoundedProducts(quad.even, eighth);
  sums->odd = sums->odd + RoundedProducts(quad.odd, eighth);
}

/// 1 / (probes one) as the sum of two factors. The product of a sum of equal codes and `high` is exact, so that equal
/// codes give the correctly rounded quotient (test_fixed.cpp tries them all).
template <class D>
struct Quotient {
  hn::Vec<D> high, low;

  HWY_INLINE Quotient(D d, hn::Vec<D> probes) {
    const hn::RebindToSigned<D> di;
    const auto divisor = probes * hn::Set(d, 16.0f * 255.0f);
    const auto reciprocal = hn::Set(d, 1.0f) / divisor;
    high = hn::BitCast(d, hn::BitCast(di, reciprocal) & hn::Set(di, -(1 << 14)));  // 10 bits
    low = (hn::Set(d, 1.0f) - high * divisor) * reciprocal;
  }
  HWY_INLINE hn::Vec<D> of(hn::Vec<D> sum) const { return sum * high + sum * low; }
};

/// Sums the lines of probes of each vector of lookups; a sink of Run().
class LineSink {
 public:
  static constexpr bool kBuffered = false, kTakesLines = true;
  using D = BatchTag;
  using V = hn::Vec<D>;
  static constexpr size_t kLanes = hn::MaxLanes(D());

  explicit LineSink(const FilterCall& call)
      : sampler_(call.sampler),
        repeats_(sampler_.wrap_u == SHD_WRAP_REPEAT && sampler_.wrap_v == SHD_WRAP_REPEAT &&
                 sampler_.weights == Weights::kLinear),
        source_(call.texture),
        words_(source_.channels == 4 && !source_.borrowed ? source_.origin : nullptr),
        out_(call.out),
        end_(call.in.count) {}

  /// Begins the block of lookups whose first one is `first`.
  void begin(size_t first, bool) { next_ = first; }
  void flush() {}

  HWY_INLINE void line(D d, const ProbeLine<D>& line, const LevelPair<D>& levels) {
    const auto most = static_cast<int32_t>(hn::GetLane(hn::MaxOfLanes(d, line.probes)));
    LineSums<D> sums[2];
    if (HWY_LIKELY(repeats_)) {
      sum_repeated(line, levels, most, sums);
    } else {
      sum_wrapped(line, levels, most, sums);
    }
    const Quotient<D> quotient(d, line.probes);
    V value[4];
    for (size_t c = 0; c < 4; ++c) {
      auto number = hn::ConvertTo(d, sums[0].channel[c]);
      if (levels.blended) number = number + levels.fraction * (hn::ConvertTo(d, sums[1].channel[c]) - number);
      value[c] = quotient.of(number);
    }
    write(d, value);
  }

  void finish() { next_ += kLanes; }

 private:
  HWY_INLINE void write(D d, const V (&value)[4]) const {
    const size_t at = next_, left = end_ - at;
    if (out_.rgba8) {
      const V color[3] = {value[0], value[1], value[2]};
      return StorePixels(color, out_.rgba8 + at);
    }
    for (size_t c = 0; c < 4; ++c) {
      if (out_.channel[c]) simd::HWY_NAMESPACE::StoreFirst(d, value[c], left, out_.channel[c] + at);
    }
  }

  /// Sums lines of at most `most` probes, whose places advance as integers.
  HWY_INLINE void sum_repeated(const ProbeLine<D>& line, const LevelPair<D>& levels, int32_t most,
                               LineSums<D>* sums) const {
    const D d;
    const auto count = ToInt(line.probes);
    for (int32_t first = 0; first < most; first += kPart) {
      const RepeatedLine<D> part(d, line, first);
      const int32_t end = most - first < kPart ? most : first + kPart;
      for (size_t l = 0; l < (levels.blended ? 2 : 1); ++l) {
        sums[l].add(d, first == 0, sum_part(part, l == 0 ? levels.high : levels.low, count, first, end));
      }
    }
  }

  /// Returns the sums of the probes first..end - 1 on a level.
  HWY_INLINE ChannelPairs<D> sum_part(const RepeatedLine<D>& line, const Level<D>& level, Ints<D> count, int32_t first,
                                      int32_t end) const {
    const D d;
    const hn::RebindToSigned<D> di;
    const int32_t steps = end - first - 1;
    const RepeatedAxis<D> x(d, level.across, line.u, line.step_u, steps), y(d, level.down, line.v, line.step_v, steps);
    const auto width = level.across.whole;
    const bool in_rows = words_ && hn::AllTrue(di, hn::Eq(width, hn::Set(di, hn::GetLane(width))));
    if (HWY_LIKELY(in_rows && hn::AllTrue(d, hn::And(x.inside, y.inside)))) {
      return sum_quads<true>(x, y, level, count, first, end);
    }
    return sum_quads<false>(x, y, level, count, first, end, in_rows);
  }

  /// kInside: no lookup has a quad at an edge. `in_rows`: all lookups have the same level, whose texels are words.
  template <bool kInside>
  HWY_INLINE ChannelPairs<D> sum_quads(RepeatedAxis<D> x, RepeatedAxis<D> y, const Level<D>& level, Ints<D> count,
                                       int32_t first, int32_t end, bool in_rows = true) const {
    const D d;
    const hn::RebindToSigned<D> di;
    const auto width = level.across.whole;
    ChannelPairs<D> sums = {hn::Zero(di), hn::Zero(di)};
    for (int32_t probe = first; probe < end; ++probe) {
      const auto i = x.texel(), j = y.texel(), upper = j * width + (level.offset + i);
      const auto last_i = hn::Eq(i, x.last), last_j = hn::Eq(j, y.last);
      Ints<D> texel[4];
      if (kInside || HWY_LIKELY(in_rows && hn::AllFalse(di, hn::Or(last_i, last_j)))) {
        alignas(64) int32_t index[kLanes];
        hn::Store(upper, di, index);
        LoadRowQuads(d, words_, index, hn::GetLane(width), texel);
      } else {
        const auto right = hn::IfThenElse(last_i, hn::Neg(i), hn::Set(di, 1));
        Ints<D> apart[4];  // a copy, so that the usual quads stay in registers
        fetch(upper, right, hn::IfThenElse(last_j, upper - j * width, upper + width), apart);
        for (size_t c = 0; c < 4; ++c) texel[c] = apart[c];
      }
      AddQuad(d, texel, x.fraction(), y.fraction(), hn::VecFromMask(di, hn::Gt(count, hn::Set(di, probe))), &sums);
      x.template advance<kInside>();
      y.template advance<kInside>();
    }
    return sums;
  }

  /// Sums lines whose places are floats, and wrap as those of bilinear lookups do.
  HWY_NOINLINE void sum_wrapped(const ProbeLine<D>& line, const LevelPair<D>& levels, int32_t most,
                                LineSums<D>* sums) const {
    for (size_t l = 0; l < (levels.blended ? 2 : 1); ++l) {
      for (int32_t first = 0; first < most; first += kPart) {
        const int32_t end = most - first < kPart ? most : first + kPart;
        sums[l].add(D(), first == 0, sum_wrapped_part(line, l == 0 ? levels.high : levels.low, first, end));
      }
    }
  }

  HWY_INLINE ChannelPairs<D> sum_wrapped_part(const ProbeLine<D>& line, const Level<D>& level, int32_t first,
                                              int32_t end) const {
    const D d;
    const hn::RebindToSigned<D> di;
    ChannelPairs<D> sums = {hn::Zero(di), hn::Zero(di)};
    for (int32_t k = first; k < end; ++k) {
      const V number = hn::Set(d, static_cast<float>(k)), position = line.position(d, number);
      LinearTaps<D> x = WrapLinear(d, line.wrap_u, line.u_at(position), level.across);
      LinearTaps<D> y = WrapLinear(d, line.wrap_v, line.v_at(position), level.down);
      if (HWY_UNLIKELY(sampler_.weights != Weights::kLinear)) ChangeWeights(d, sampler_.weights, &x, &y);
      const auto upper = RowIndex(d, level, y.i0) + x.i0, lower = RowIndex(d, level, y.i1) + x.i0;
      Ints<D> texel[4];
      fetch(upper, x.i1 - x.i0, lower, texel);
      const auto active = hn::VecFromMask(di, hn::RebindMask(di, hn::Lt(number, line.probes)));
      AddQuad(d, texel, FixedFraction(d, x.s), FixedFraction(d, y.s), active, &sums);
    }
    return sums;
  }

  /// Fetches quads. `right`: distance of the right texels from the left ones.
  HWY_NOINLINE void fetch(Ints<D> upper, Ints<D> right, Ints<D> lower, Ints<D> (&texel)[4]) const {
    const D d;
    const hn::RebindToSigned<D> di;
    alignas(64) int32_t index[4][kLanes];
    hn::Store(upper, di, index[0]);
    hn::Store(upper + right, di, index[1]);
    hn::Store(lower, di, index[2]);
    hn::Store(lower + right, di, index[3]);
    const bool next = hn::AllTrue(di, hn::Eq(right, hn::Set(di, 1)));
    if (next) return Unorm8::fetch_quad(d, source_, index[0], index[2], texel);
    for (size_t k = 0; k < 4; ++k) texel[k] = Unorm8::fetch(d, source_, index[k]);
  }

  const Sampler& sampler_;
  const bool repeats_;  // places are those of RepeatedAxis
  const TexelSource source_;
  const uint8_t* const words_;  // texels of four channels that are all in one block; else null
  const Texels out_;
  const size_t end_;
  size_t next_ = 0;  // first lookup of the current vector
};

}  // namespace

size_t RunFixedLines(const FilterCall& call) {
  const Sampler sampler = fast_lines(call.sampler);
  return Run<Anisotropic, LineSink>(
      {call.texture, sampler, call.in, call.out, call.format, call.record, call.recording, call.placement});
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
