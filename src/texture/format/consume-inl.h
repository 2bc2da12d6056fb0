// SPDX-License-Identifier: MIT
// The consumer of a stream: fetches the texels of each element, blends them, and takes them into the running averages.
// A Format has
//
//   Texel<D>                  raw bits of one texel per lane
//   fetch(d, texture, index)  texels at indices; what lies behind the channels that the texture has is not defined
//   fetch_pair(...)           texels at indices, which lie aligned in memory, and the ones behind them
//   decode<C>(d, texel)       channel C as a float in the format's lerp domain: unorm channels stay codes
//   finish<C>(d, value)       from the lerp domain to the result
//   kFloat                    texels may be infinite, NaN or so far apart that their difference overflows

#if defined(SHD_TEXTURE_CONSUME_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_CONSUME_INL_H_
#undef SHD_TEXTURE_CONSUME_INL_H_
#else
#define SHD_TEXTURE_CONSUME_INL_H_
#endif

#include <type_traits>

#include <hwy/highway.h>

#include "texture/footprint/points-inl.h"
#include "texture/format/blend-inl.h"
#include "texture/format/gradient-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// body(std::integral_constant<size_t, C>()) for every wanted channel C.
template <class B, class Body>
HWY_INLINE void ForEachWanted(const Texels& out, const Body& body) {
  if (B::wanted(out, 0)) body(std::integral_constant<size_t, 0>());
  if (B::wanted(out, 1)) body(std::integral_constant<size_t, 1>());
  if (B::wanted(out, 2)) body(std::integral_constant<size_t, 2>());
  if (B::wanted(out, 3)) body(std::integral_constant<size_t, 3>());
}

/// One texel a lane, and whether it is one of the image.
template <class F, class D>
struct Tap {
  typename F::template Texel<D> texel;
  MaskOf<D> in;
};

template <class F, bool kBorder, class D>
HWY_INLINE Tap<F, D> FetchTap(D d, const Texture& texture, const int32_t* index) {
  const hn::RebindToSigned<D> di;
  const auto given = hn::Load(di, index);
  if constexpr (!kBorder) return {F::fetch(d, texture, given), hn::Eq(hn::Zero(d), hn::Zero(d))};
  const auto sign = hn::BroadcastSignBit(given);
  return {F::fetch(d, texture, given ^ sign), hn::RebindMask(d, hn::Eq(sign, hn::Zero(di)))};
}

/// The four texels of a quad: columns 0 and 1 of row 0, then of row 1.
template <class F, class D>
struct QuadTaps {
  Tap<F, D> tap[4];
};

template <class F, bool kBorder, class D, class Elements>
SHD_KERNEL_PART QuadTaps<F, D> FetchQuad(D d, const Texture& texture, const Elements& stream, uint32_t op, size_t at) {
  QuadTaps<F, D> quad;
  if (HWY_LIKELY(op & kNeighbours)) {
    for (size_t row = 0; row < 2; ++row) {
      Tap<F, D>*left = &quad.tap[2 * row], *right = left + 1;
      F::fetch_pair(d, texture, stream.index[2 * row] + at, &left->texel, &right->texel);
      left->in = right->in = hn::Eq(hn::Zero(d), hn::Zero(d));
    }
    return quad;
  }
  for (size_t k = 0; k < 4; ++k) quad.tap[k] = FetchTap<F, kBorder>(d, texture, stream.index[k] + at);
  return quad;
}

/// Bilinear value of channel C.
template <size_t C, class B, class F, class D, class Elements>
HWY_INLINE auto BlendQuad(D d, const B& b, const QuadTaps<F, D>& quad, const Elements& stream, size_t at) {
  const auto s = hn::Load(d, stream.s + at), t = hn::Load(d, stream.t + at);
  const auto t00 = b.template tap<C>(d, quad.tap[0].texel, quad.tap[0].in);
  const auto t10 = b.template tap<C>(d, quad.tap[1].texel, quad.tap[1].in);
  const auto top = b.blend_s(d, t00, t10, s, stream.rate_s + at);
  const auto t01 = b.template tap<C>(d, quad.tap[2].texel, quad.tap[2].in);
  const auto t11 = b.template tap<C>(d, quad.tap[3].texel, quad.tap[3].in);
  const auto bottom = b.blend_s(d, t01, t11, s, stream.rate_s + at);
  return b.blend_t(d, top, bottom, t, stream.rate_t + at);
}

/// A running average and one more value.
template <class B, class D, class Value, class Elements>
HWY_INLINE Value Averaged(D d, const B& b, const Value& average, const Value& value, const Elements& stream, uint32_t op,
                          size_t at) {
  const auto share = hn::Load(d, stream.share + at);
  const Value blended = HWY_UNLIKELY(op & kRated) ? b.blend_by(d, average, value, share, stream.share_rate_u + at,
                                                               stream.share_rate_v + at)
                                                  : b.blend(d, average, value, share);
  if ((op & kHow) != kReplace) return blended;
  return b.replace(d, hn::Eq(share, hn::Set(d, kWhole)), blended, value);
}

/// The running averages of one vector of lookups, in the wanted channels: the first one, then the second one.
template <class B, class D>
struct Averages {
  typename B::template Value<D> value[2][4] = {};
};

/// Takes the element at `at` into the averages. Of the last element of its lookups, writes the result instead.
template <class B, class F, bool kBorder, class D, class Elements>
HWY_INLINE void ConsumeElement(D d, const B& b, const Elements& stream, uint32_t op, size_t at,
                               Averages<B, D>* averages, Consumption* to) {
  using Value = typename B::template Value<D>;
  Value* into = averages->value[op & kSecond ? 1 : 0];
  Value value[4] = {};
  if (op & kMerge) {
    ForEachWanted<B>(to->out, [&](auto c) { value[c] = averages->value[1][c]; });
  } else if (op & kQuad) {
    const QuadTaps<F, D> quad = FetchQuad<F, kBorder>(d, to->texture, stream, op, at);
    ForEachWanted<B>(to->out, [&](auto c) { value[c] = BlendQuad<c>(d, b, quad, stream, at); });
  } else {
    const Tap<F, D> tap = FetchTap<F, kBorder>(d, to->texture, stream.index[0] + at);
    ForEachWanted<B>(to->out, [&](auto c) { value[c] = b.template tap<c>(d, tap.texel, tap.in); });
  }
  if (op & (kHow | kMerge)) {
    ForEachWanted<B>(to->out, [&](auto c) { value[c] = Averaged(d, b, into[c], value[c], stream, op, at); });
  }
  if (op & kLast) {
    ForEachWanted<B>(to->out, [&](auto c) { b.template store<c>(d, value[c], to->done, *to); });
    to->done += hn::Lanes(d);
  } else {
    ForEachWanted<B>(to->out, [&](auto c) { into[c] = value[c]; });
  }
}

/// A Consume: B is the Blend, F the Format.
template <class B, class F, bool kBorder>
void ConsumeStream(const Stream& stream, Consumption* consumption) {
  using D = BatchTag;
  const D d;
  const B b(*consumption);
  Averages<B, D> averages;
  static_assert(sizeof averages <= sizeof consumption->state);
  if (consumption->open) std::memcpy(&averages, consumption->state, sizeof averages);
  for (size_t e = 0; e < stream.elements; ++e) {
    ConsumeElement<B, F, kBorder>(d, b, stream, stream.op[e], e * hn::Lanes(d), &averages, consumption);
  }
  consumption->open = !(stream.op[stream.elements - 1] & kLast);
  if (consumption->open) std::memcpy(consumption->state, &averages, sizeof averages);
}

template <class F>
FormatKernels KernelsOf() {
  return {ConsumeStream<Blend<F, false>, F, false>, ConsumeStream<Blend<F, true>, F, true>,
          ConsumeStream<GradientBlend<F>, F, true>};
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_CONSUME_INL_H_
