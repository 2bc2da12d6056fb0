// SPDX-License-Identifier: MIT
// Blends of 8-bit texels in 16 bits, for SHD_PRECISION_FAST. The halves of a word hold two channels of a lookup in
// units of 1/128 of a code, 0..32640. Fractions have 15 bits. A blend is a + ((b - a) s + 2^14 >> 15). Its error is
// half a unit for the product, half a unit for a fraction that is rounded, and one unit for a fraction that would round
// to 1. A quad has an error of at most 3 units, and a blend of two quads one of 4.5 units, which is 1.4e-4 of the
// range. Integers have the same values on every target.

#if defined(SHD_TEXTURE_FIXED_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_FIXED_INL_H_
#undef SHD_TEXTURE_FIXED_INL_H_
#else
#define SHD_TEXTURE_FIXED_INL_H_
#endif

#include <hwy/highway.h>

#include "simd/integer-inl.h"
#include "simd/kernel_part.h"
#include "texture/format/codec.h"
#include "texture/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::MixHalves;
using simd::HWY_NAMESPACE::TwiceLow;

/// Number of units of a code.
constexpr float kFixedUnits = 128.0f;

/// Channels 0 and 2, and channels 1 and 3, of a vector of lookups, each in the low and the high halves of words.
template <class D>
struct ChannelPairs {
  Ints<D> even, odd;
};

/// Returns fractions in [0, 1] in units of 2^-15, at most 1 - 2^-15, in both halves of each word.
template <class D>
HWY_INLINE Ints<D> FixedFraction(D d, hn::Vec<D> s) {
  const hn::RebindToSigned<D> di;
  const auto sum = hn::Min(s, hn::Set(d, 0x1.fffcp-1f)) + hn::Set(d, 256.0f);  // has the unit 2^-15
  return TwiceLow(hn::BitCast(di, sum));
}

/// Returns the first or the second pair of channels of texels.
template <class VI>
HWY_INLINE VI EvenCodes(VI texels) {
  const hn::DFromV<VI> di;
  return hn::ShiftLeft<7>(texels & hn::Set(di, 0x00ff00ff));
}
template <class VI>
HWY_INLINE VI OddCodes(VI texels) {
  const hn::DFromV<VI> di;
  const hn::RebindToUnsigned<decltype(di)> du;
  return hn::BitCast(di, hn::ShiftRight<1>(hn::And(hn::BitCast(du, texels), hn::Set(du, 0xff00ff00u))));
}

/// Returns the bilinear blend of four texels. kOdd: channels 1 and 3 are wanted, and zero otherwise.
template <bool kOdd, class D>
HWY_INLINE ChannelPairs<D> BlendQuad(D, const Ints<D> (&texel)[4], Ints<D> s, Ints<D> t) {
  const hn::RebindToSigned<D> di;
  const auto blend = [&](auto codes) SHD_INLINE_LAMBDA {
    const auto top = MixHalves(codes(texel[0]), codes(texel[1]), s);
    return MixHalves(top, MixHalves(codes(texel[2]), codes(texel[3]), s), t);
  };
  const auto even = [](Ints<D> x) SHD_INLINE_LAMBDA { return EvenCodes(x); };
  const auto odd = [](Ints<D> x) SHD_INLINE_LAMBDA { return OddCodes(x); };
  return {blend(even), kOdd ? blend(odd) : hn::Zero(di)};
}

/// Returns channel C of each lookup.
template <size_t C, class D>
HWY_INLINE Ints<D> HalfOf(D, const ChannelPairs<D>& pairs) {
  const hn::RebindToSigned<D> di;
  const hn::RebindToUnsigned<D> du;
  const auto pair = C % 2 == 0 ? pairs.even : pairs.odd;
  if constexpr (C < 2) return pair & hn::Set(di, 0xffff);
  return hn::BitCast(di, hn::ShiftRight<16>(hn::BitCast(du, pair)));
}

/// Moves values of at least half a code above a whole one to odd units, so that none lies between two codes: pixels and
/// floats then round to the same codes.
template <class VI>
HWY_INLINE VI WithoutTies(VI units) {
  const hn::DFromV<VI> di;
  return units | (hn::ShiftRight<6>(units) & hn::Set(di, 0x00010001));
}

/// Returns channel C as a value in 0..1. Whole codes have the bits of SHD_PRECISION_FULL.
template <size_t C, class D>
HWY_INLINE hn::Vec<D> UnitOf(D d, const ChannelPairs<D>& pairs) {
  const auto units = hn::ConvertTo(d, HalfOf<C>(d, pairs));
  return units * hn::Set(d, kScale8.high / kFixedUnits) + units * hn::Set(d, kScale8.low / kFixedUnits);
}

/// Returns opaque pixels of channels 0..2.
template <class D>
HWY_INLINE hn::Vec<hn::RebindToUnsigned<D>> PixelsOf(D, const ChannelPairs<D>& pairs) {
  const hn::RebindToUnsigned<D> du;
  const auto half = hn::Set(du, 0x00400040u);
  const auto even = hn::ShiftRight<7>(hn::BitCast(du, pairs.even) + half);
  const auto odd = hn::ShiftLeft<1>(hn::BitCast(du, pairs.odd) + half);
  const auto codes = hn::Or(hn::And(even, hn::Set(du, 0x00ff00ffu)), hn::And(odd, hn::Set(du, 0x0000ff00u)));
  return hn::Or(codes, hn::Set(du, 0xff000000u));
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_FIXED_INL_H_
