// SPDX-License-Identifier: MIT
/// @file
/// Vectors of values to codes of each component type, with the bits of channel.h. Integer types clamp to 0..1.
#if defined(SHD_IMAGE_ENCODE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_IMAGE_ENCODE_INL_H_
#undef SHD_IMAGE_ENCODE_INL_H_
#else
#define SHD_IMAGE_ENCODE_INL_H_
#endif

#include <hwy/highway.h>

#include "image/srgb.h"
#include "simd/integer-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::image::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using simd::HWY_NAMESPACE::ToInt;

using DF = hn::ScalableTag<float>;
using DU = hn::RebindToUnsigned<DF>;
using DI = hn::RebindToSigned<DF>;
using VF = hn::Vec<DF>;
using VU = hn::Vec<DU>;

/// The code whose estimate k may be one off near a tie. There v 2^kBits - (k -+ 1/2) is exact, so its comparison with v
/// is that of v (2^kBits - 1) with k -+ 1/2.
template <int kBits>
HWY_INLINE VU CorrectCode(VF v, VU estimate) {
  const DF d;
  const DU du;
  const VF half = hn::Set(d, 0.5f);
  const VF k = hn::ConvertTo(d, hn::BitCast(DI(), estimate));
  const VF scaled = v * hn::Set(d, static_cast<float>(1 << kBits));
  const VU one = hn::Set(du, 1u);
  const VU above = hn::IfThenElseZero(hn::RebindMask(du, hn::Ge(scaled - (k + half), v)), one);
  const VU below = hn::IfThenElseZero(hn::RebindMask(du, hn::Lt(scaled - (k - half), v)), one);
  return estimate + above - below;
}

/// Clamps to 0..1; NaN gives 0.
HWY_INLINE VF Clamped(VF value) {
  const DF d;
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_SSSE3
  const VF positive = hn::Max(value, hn::Zero(d));  // the second one if the first is NaN
#else
  const VF positive = hn::IfThenElseZero(hn::Gt(value, hn::Zero(d)), value);
#endif
  return hn::Min(positive, hn::Set(d, 1.0f));
}

/// Clamps and rounds to the nearest of 2^kBits codes.
template <int kBits>
HWY_INLINE VU UnormCode(VF value) {
  const DF d;
  const VF v = Clamped(value);
  const VF sum = v * hn::Set(d, static_cast<float>((1 << kBits) - 1)) + hn::Set(d, 0.5f);
  return CorrectCode<kBits>(v, hn::BitCast(DU(), ToInt(sum)));
}

/// Packs codes of 8 bits of consecutive channels, the first lowest.
template <size_t kChannels>
HWY_INLINE VU PackCodes(const VU (&code)[kChannels]) {
  VU packed = code[0];
  if (kChannels > 1) packed = hn::Or(packed, hn::ShiftLeft<8>(code[1 % kChannels]));
  if (kChannels > 2) packed = hn::Or(packed, hn::ShiftLeft<16>(code[2 % kChannels]));
  if (kChannels > 3) packed = hn::Or(packed, hn::ShiftLeft<24>(code[3 % kChannels]));
  return packed;
}

/// Moves the bits 15..22 of each word, a code of Unorm8Codes(), to byte C and clears the others.
template <size_t C>
HWY_INLINE VU CodeAtByte(VU bits) {
  constexpr int kBy = 15 - 8 * static_cast<int>(C);
  const VU moved = kBy > 0 ? hn::ShiftRight<(kBy > 0 ? kBy : 0)>(bits) : hn::ShiftLeft<(kBy < 0 ? -kBy : 0)>(bits);
  return hn::And(moved, hn::Set(DU(), 255u << (8 * C)));
}

/// Rounds channels to codes of 8 bits and packs them. The sum of 256.5 + 2^-15 and the scaled value is a multiple of
/// 2^-15 whose error is below 2^-15. Its code, in the bits 15..22, is right unless the 15 bits below are 0 or 1.
template <size_t kChannels>
HWY_INLINE VU Unorm8Codes(const VF* channel) {
  const DF d;
  const DU du;
  const VU below = hn::Set(du, 0x7ffeu);
  VU bits[4], least = below;
  for (size_t c = 0; c < kChannels; ++c) {
    const VF scaled = Clamped(channel[c]) * hn::Set(d, 255.0f);
    bits[c] = hn::BitCast(du, scaled + hn::Set(d, 256.5f + 0x1p-15f));
    least = hn::Min(least, hn::And(bits[c], below));
  }
  if (HWY_LIKELY(hn::AllFalse(du, hn::Eq(least, hn::Zero(du))))) {
    VU packed = CodeAtByte<0>(bits[0]);
    if constexpr (kChannels > 1) packed = hn::Or(packed, CodeAtByte<1>(bits[1]));
    if constexpr (kChannels > 2) packed = hn::Or(packed, CodeAtByte<2>(bits[2]));
    if constexpr (kChannels > 3) packed = hn::Or(packed, CodeAtByte<3>(bits[3]));
    return packed;
  }
  VU code[kChannels];
  for (size_t c = 0; c < kChannels; ++c) code[c] = UnormCode<8>(channel[c]);
  return PackCodes(code);
}

/// linear_to_srgb8() of each lane.
HWY_INLINE VU SrgbCode(VF value) {
  const DF d;
  const DU du;
  const VF least = hn::Set(d, 0x1p-13f);
  const VF v = hn::Min(hn::IfThenElse(hn::Ge(value, least), value, least), hn::Set(d, 0x1.fffffep-1f));
  const VU bits = hn::BitCast(du, v);
  const VU index = hn::ShiftRight<16>(bits) - hn::Set(du, kSrgb8FirstStep);
  const VU step = hn::GatherIndex(du, kLinearToSrgb8Steps.step, hn::BitCast(DI(), index));
  const VU low = hn::And(bits, hn::Set(du, 0xffffu)), threshold = hn::And(step, hn::Set(du, 0x1ffffu));
  const auto reached = hn::Not(hn::Lt(hn::BitCast(DI(), low), hn::BitCast(DI(), threshold)));
  return hn::ShiftRight<17>(step) + hn::IfThenElseZero(hn::RebindMask(du, reached), hn::Set(du, 1u));
}

/// float_to_half() of each lane.
HWY_INLINE VU HalfBits(VF value) {
  const DF d;
  const DU du;
  const DI di;
  const auto set = [&](uint32_t bits) { return hn::Set(du, bits); };
  const auto is_below = [&](VU a, uint32_t b) {
    return hn::RebindMask(du, hn::Lt(hn::BitCast(di, a), hn::Set(di, static_cast<int32_t>(b))));
  };
  const VU bits = hn::BitCast(du, value);
  const VU sign = hn::And(hn::ShiftRight<16>(bits), set(0x8000u));
  const VU magnitude = hn::And(bits, set(0x7fffffffu));
  const VU odd = hn::And(hn::ShiftRight<13>(magnitude), set(1u));
  const VU normal = hn::ShiftRight<13>(magnitude - set((112u << 23) - 0xfffu) + odd);
  const VU subnormal = hn::BitCast(du, hn::BitCast(d, magnitude) + hn::Set(d, 0.5f)) - set(0x3f000000u);
  VU half = hn::IfThenElse(is_below(magnitude, 0x38800000u), subnormal, normal);
  half = hn::IfThenElse(is_below(magnitude, 0x477ff000u), half, set(0x7c00u));
  const VU nan = hn::Or(set(0x7e00u), hn::And(hn::ShiftRight<13>(magnitude), set(0x1ffu)));
  half = hn::IfThenElse(is_below(magnitude, 0x7f800001u), half, nan);
  return hn::Or(sign, half);
}

}  // namespace shd::image::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_IMAGE_ENCODE_INL_H_
