// SPDX-License-Identifier: MIT
// The consumer of a stream: it fetches the texels of each element, blends them, and adds them to the running averages.
//
// A Format fetches and decodes texels. It has these members:
//
//   Texel<D>                  raw bits of one texel per lane
//   fetch(d, source, index)   texels at an aligned array of indices; bits beyond the channels of the texture are not
//                             defined
//   fetch_quad(...)           texels at indices and at the next indices, in an upper and a lower row of one level
//   fetch_rows(...)           fetch_quad() where the lower row lies at one distance from the upper one
//   fetch_row(...)            four consecutive texels from each index
//   decode<C>(d, texel)       channel C as a float in the format's lerp domain; unorm channels stay codes
//   finish<C>(d, value)       result of a value in the lerp domain
//   kFloat                    texels may be infinite or NaN, and their blends may overflow
//   kCodes8                   blends are codes of 8 bits before rounding, for formats with rows
//
// The source is the TexelSource of the stream, or that of unpacked texels (unpacked-inl.h).
//
// A Blend computes with the texels of a format. Every filter is a tree of blends, so equal texels give exactly their
// value. It has these members:
//
//   Value<D>         one channel of one vector of lookups
//   tap<C>           value of a texel, or of the border colour in lanes outside `in`
//   blend            a + s (b - a), where s does not depend on the point
//   blend_s, blend_t blend with ds/du = rate, and blend with dt/dv = rate
//   blend_by         blend with the rates of s in u and v, or in w
//   kRates           flag of elements whose share has these rates: kRated or kDeep
//   replace          b in some lanes, a in the others
//   finish<C>        result of a value: number k of kResults, written to the output column kFirstColumn + 4 k + C
//   wanted           whether a channel is written

#if defined(SHD_TEXTURE_CONSUME_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_CONSUME_INL_H_
#undef SHD_TEXTURE_CONSUME_INL_H_
#else
#define SHD_TEXTURE_CONSUME_INL_H_
#endif

#include <limits>
#include <type_traits>

#include <hwy/highway.h>

#include "simd/kernel_part.h"
#include "simd/tail-inl.h"
#include "texture/lanes-inl.h"
#include "texture/stream.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::StoreFirst;

/// Returns a + s (b - a) for values whose difference cannot overflow. The result is exactly a if a == b or s == 0.
template <class D, class V>
HWY_INLINE V Lerp(D, V a, V b, V s) {
  return a + s * (b - a);
}

/// Returns a mask of the lanes that are neither infinite nor NaN.
template <class D, class V>
HWY_INLINE MaskOf<D> IsFinite(D d, V value) {
  return hn::Eq(value - value, hn::Zero(d));
}

/// Returns `value`, except that infinities become the largest float of their sign in the lanes `clamped`. The value is
/// not NaN there.
template <class D, class V>
HWY_INLINE V ClampWhere(D d, MaskOf<D> clamped, V value) {
  const V largest = hn::Set(d, 0x1.fffffep127f);
  return hn::IfThenElse(clamped, hn::Min(hn::Max(value, hn::Neg(largest)), largest), value);
}

/// Returns (1 - s) a + s b in the lanes whose a + s (b - a), which is `mixed`, is not finite. Where finite values
/// overflow again, which takes an s outside [0, 1], the result is the largest float of its sign.
template <class D, class V>
HWY_NOINLINE V MixOverflowed(D d, V a, V b, V s, V mixed) {
  const V weighted = (hn::Set(d, 1.0f) - s) * a + s * b;
  const auto clamped = hn::And(IsFinite(d, a), IsFinite(d, b));
  return hn::IfThenElse(IsFinite(d, mixed), mixed, ClampWhere(d, clamped, weighted));
}

/// Returns a + s (b - a) for any floats. If s == 0 the result is a, even if b is infinite or NaN; with other weights
/// infinities and NaN propagate. Finite values give finite results, see MixOverflowed().
template <class D, class V>
HWY_INLINE V Mix(D d, V a, V b, V s) {
  V mixed = a + s * (b - a);
  if (HWY_UNLIKELY(!hn::AllTrue(d, IsFinite(d, mixed)))) mixed = MixOverflowed(d, a, b, s, mixed);
  return hn::IfThenElse(hn::Eq(s, hn::Zero(d)), a, mixed);
}

/// A Blend for values of format F. With a border, texels leave the lerp domain of the format before they are blended,
/// because the border colour may be any finite float.
template <class F, bool kBorder>
struct Blend {
  template <class D>
  using Value = hn::Vec<D>;

  const Sampler& sampler;

  explicit Blend(const Consumption& consumption) : sampler(consumption.sampler) {}

  template <size_t C, class D>
  HWY_INLINE Value<D> tap(D d, const typename F::template Texel<D>& texel, MaskOf<D> in) const {
    const hn::Vec<D> value = F::template decode<C>(d, texel);
    if constexpr (!kBorder) return value;
    return hn::IfThenElse(in, F::template finish<C>(d, value), hn::Set(d, sampler.border[C]));
  }

  /// s is in [0, 1], except in the lobes of cubic kernels.
  template <class D>
  HWY_INLINE Value<D> blend(D d, Value<D> a, Value<D> b, hn::Vec<D> s) const {
    if constexpr (kBorder || F::kFloat) return Mix(d, a, b, s);
    return Lerp(d, a, b, s);
  }
  template <class D>
  HWY_INLINE Value<D> blend_s(D d, Value<D> a, Value<D> b, hn::Vec<D> s, const float*) const {
    return blend(d, a, b, s);
  }
  template <class D>
  HWY_INLINE Value<D> blend_t(D d, Value<D> a, Value<D> b, hn::Vec<D> t, const float*) const {
    return blend(d, a, b, t);
  }
  template <class D>
  HWY_INLINE Value<D> blend_by(D d, Value<D> a, Value<D> b, hn::Vec<D> s, const float*, const float*) const {
    return blend(d, a, b, s);
  }
  template <class D>
  HWY_INLINE Value<D> replace(D, MaskOf<D> lanes, Value<D> a, Value<D> b) const {
    return hn::IfThenElse(lanes, b, a);
  }

  static constexpr uint32_t kRates = kRated;
  static constexpr size_t kResults = 1, kFirstColumn = 0;

  /// Returns the result. All NaN become the same NaN, because the NaN of an operation depends on the target.
  template <size_t C, class D>
  static HWY_INLINE hn::Vec<D> finish(D d, Value<D> value, size_t = 0) {
    if constexpr (F::kFloat)
      return hn::IfThenElse(hn::Eq(value, value), value, hn::Set(d, std::numeric_limits<float>::quiet_NaN()));
    if constexpr (kBorder) return value;
    return F::template finish<C>(d, value);
  }
  static HWY_INLINE bool wanted(const Texels& out, size_t channel) { return out.channel[channel] != nullptr; }
};

/// The channels that a consumer writes.
struct WantedChannels {
  bool channel[4];

  /// Calls body(std::integral_constant<size_t, C>()) for every wanted channel C.
  template <class Body>
  HWY_INLINE void for_each(const Body& body) const {
    if (channel[0]) body(std::integral_constant<size_t, 0>());
    if (channel[1]) body(std::integral_constant<size_t, 1>());
    if (channel[2]) body(std::integral_constant<size_t, 2>());
    if (channel[3]) body(std::integral_constant<size_t, 3>());
  }
};

/// Returns the channels that the Blend B writes.
template <class B>
HWY_INLINE WantedChannels WantedBy(const Texels& out) {
  return {{B::wanted(out, 0), B::wanted(out, 1), B::wanted(out, 2), B::wanted(out, 3)}};
}

/// One texel per lane, and the mask of lanes whose texel lies in the image; the others read the border colour.
template <class F, class D>
struct Tap {
  typename F::template Texel<D> texel;
  MaskOf<D> in;
};

template <class F, bool kBorder, class D, class Source>
HWY_INLINE Tap<F, D> FetchTap(D d, const Source& source, const int32_t* index) {
  if constexpr (!kBorder) return {F::fetch(d, source, index), hn::Eq(hn::Zero(d), hn::Zero(d))};
  const hn::RebindToSigned<D> di;
  const auto given = hn::Load(di, index), sign = hn::BroadcastSignBit(given);
  alignas(64) int32_t clamped[hn::MaxLanes(D())];
  hn::Store(given ^ sign, di, clamped);
  return {F::fetch(d, source, clamped), hn::RebindMask(d, hn::Eq(sign, hn::Zero(di)))};
}

/// The four texels of a quad or a row, in the order of the stream.
template <class F, class D>
struct FourTaps {
  Tap<F, D> tap[4];
};

template <class F, bool kBorder, class D, class Source, class Elements>
SHD_KERNEL_PART FourTaps<F, D> FetchFour(D d, const Source& source, const Elements& stream, uint32_t op, size_t at) {
  FourTaps<F, D> four;
  if (HWY_LIKELY(op & kNeighbours)) {
    Tap<F, D>* tap = four.tap;
    if (HWY_LIKELY(op & kQuad)) {
      typename F::template Texel<D> quad[4];
      F::fetch_quad(d, source, stream.index[0] + at, stream.index[2] + at, quad);
      for (size_t k = 0; k < 4; ++k) tap[k].texel = quad[k];
    } else {
      typename F::template Texel<D> row[4];
      F::fetch_row(d, source, stream.index[2] + at, row);
      tap[0].texel = row[1];
      tap[1].texel = row[2];
      tap[2].texel = row[0];
      tap[3].texel = row[3];
    }
    tap[0].in = tap[1].in = tap[2].in = tap[3].in = hn::Eq(hn::Zero(d), hn::Zero(d));
    return four;
  }
  for (size_t k = 0; k < 4; ++k) four.tap[k] = FetchTap<F, kBorder>(d, source, stream.index[k] + at);
  return four;
}

/// Returns the bilinear value of channel C.
template <size_t C, class B, class F, class D, class Elements>
HWY_INLINE auto BlendQuad(D d, const B& b, const FourTaps<F, D>& four, const Elements& stream, size_t at) {
  const auto s = hn::Load(d, stream.s + at), t = hn::Load(d, stream.t + at);
  const auto t00 = b.template tap<C>(d, four.tap[0].texel, four.tap[0].in);
  const auto t10 = b.template tap<C>(d, four.tap[1].texel, four.tap[1].in);
  const auto top = b.blend_s(d, t00, t10, s, stream.rate_s + at);
  const auto t01 = b.template tap<C>(d, four.tap[2].texel, four.tap[2].in);
  const auto t11 = b.template tap<C>(d, four.tap[3].texel, four.tap[3].in);
  const auto bottom = b.blend_s(d, t01, t11, s, stream.rate_s + at);
  return b.blend_t(d, top, bottom, t, stream.rate_t + at);
}

/// Returns the running average of channel C over the texels of a row.
template <size_t C, class B, class F, class D, class Elements>
HWY_INLINE auto BlendRow(D d, const B& b, const FourTaps<F, D>& four, const Elements& stream, size_t at) {
  const auto tap = [&](size_t k) SHD_INLINE_LAMBDA { return b.template tap<C>(d, four.tap[k].texel, four.tap[k].in); };
  auto value = b.blend_s(d, tap(0), tap(1), hn::Load(d, stream.s + at), stream.rate_s + at);
  value = b.blend_s(d, value, tap(2), hn::Load(d, stream.t + at), stream.rate_t + at);
  return b.blend_s(d, value, tap(3), hn::Load(d, stream.r + at), stream.rate_r + at);
}

/// Blends one more value into a running average.
template <class B, class D, class Value, class Elements>
HWY_INLINE Value Averaged(D d, const B& b, const Value& average, const Value& value, const Elements& stream,
                          uint32_t op, size_t at) {
  const auto share = hn::Load(d, stream.share + at);
  const Value blended = HWY_UNLIKELY(op & B::kRates)
                            ? b.blend_by(d, average, value, share, stream.share_rate_u + at, stream.share_rate_v + at)
                            : b.blend(d, average, value, share);
  if ((op & kHow) != kReplace) return blended;
  return b.replace(d, hn::Eq(share, hn::Set(d, kWhole)), blended, value);
}

/// The first and the second running average of one vector of lookups, in the wanted channels.
template <class B, class D>
struct Averages {
  typename B::template Value<D> value[2][4];  // not set before an element starts them
};

/// Constants of a consumer over all elements, copied out of Consumption so that stores of vectors cannot alias them.
template <class B, class Source = TexelSource>
struct Consumer {
  B blend;
  Source source;
  WantedChannels wanted;

  explicit Consumer(const Consumption& c) : Consumer(c, c.texels) {}
  Consumer(const Consumption& c, const Source& texels) : blend(c), source(texels), wanted(WantedBy<B>(c.out)) {}
};

/// Blends the element at `at` into the averages. For the last element of a vector of lookups it writes the result
/// instead.
template <class B, class F, bool kBorder, class D, class Source, class Elements>
HWY_INLINE void ConsumeElement(D d, const Consumer<B, Source>& consumer, const Elements& stream, uint32_t op, size_t at,
                               Averages<B, D>* averages, Consumption* to) {
  using Value = typename B::template Value<D>;
  const B& b = consumer.blend;
  const WantedChannels wanted = consumer.wanted;
  Value* into = averages->value[op & kSecond ? 1 : 0];
  Value value[4] = {};
  if (op & (kQuad | kRow)) {
    const FourTaps<F, D> four = FetchFour<F, kBorder>(d, consumer.source, stream, op, at);
    if (HWY_LIKELY(op & kQuad)) {
      wanted.for_each([&](auto c) SHD_INLINE_LAMBDA { value[c] = BlendQuad<c>(d, b, four, stream, at); });
    } else {
      wanted.for_each([&](auto c) SHD_INLINE_LAMBDA { value[c] = BlendRow<c>(d, b, four, stream, at); });
    }
  } else if (op & kMerge) {
    wanted.for_each([&](auto c) SHD_INLINE_LAMBDA { value[c] = averages->value[1][c]; });
  } else {
    const Tap<F, D> tap = FetchTap<F, kBorder>(d, consumer.source, stream.index[0] + at);
    wanted.for_each([&](auto c) SHD_INLINE_LAMBDA { value[c] = b.template tap<c>(d, tap.texel, tap.in); });
  }
  if (op & (kHow | kMerge)) {
    wanted.for_each([&](auto c) SHD_INLINE_LAMBDA { value[c] = Averaged(d, b, into[c], value[c], stream, op, at); });
  }
  if (op & kLast) {
    wanted.for_each([&](auto c) SHD_INLINE_LAMBDA {
      for (size_t k = 0; k < B::kResults; ++k) {
        float* const column = to->out.column(B::kFirstColumn + 4 * k + c);
        if (column) StoreFirst(d, b.template finish<c>(d, value[c], k), to->count - to->done, column + to->done);
      }
    });
    to->done += hn::Lanes(d);
  } else {
    wanted.for_each([&](auto c) SHD_INLINE_LAMBDA { into[c] = value[c]; });
  }
}

/// Consumes elements with the Blend B and the Format F, which fetches from `source`.
template <class B, class F, bool kBorder, class Source>
HWY_INLINE void ConsumeFrom(const Source& source, const Stream& stream, size_t end, Consumption* consumption) {
  using D = BatchTag;
  const D d;
  const Consumer<B, Source> consumer(*consumption, source);
  Averages<B, D> averages;
  static_assert(sizeof averages <= sizeof consumption->state);
  if (consumption->open) std::memcpy(&averages, consumption->state, sizeof averages);
  for (size_t e = 0; e < end; ++e) {
    ConsumeElement<B, F, kBorder>(d, consumer, stream, stream.op[e], e * hn::Lanes(d), &averages, consumption);
  }
  consumption->open = !(stream.op[end - 1] & kLast);
  if (consumption->open) std::memcpy(consumption->state, &averages, sizeof averages);
}

/// Consumes elements with the Blend B and the Format F; a Consume.
template <class B, class F, bool kBorder>
void ConsumeStream(const Stream& stream, size_t end, Consumption* consumption) {
  ConsumeFrom<B, F, kBorder>(consumption->texels, stream, end, consumption);
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_CONSUME_INL_H_
