// SPDX-License-Identifier: MIT
#include "film/pixels.h"

#include <cstdint>
#include <cstring>

#include "core/failure.h"
#include "core/status.h"
#include "image/half.h"
#include "image/srgb.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "film/pixels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "simd/integer-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::film::HWY_NAMESPACE {
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

/// image::linear_to_srgb8() of each lane.
HWY_INLINE VU SrgbCode(VF value) {
  const DF d;
  const DU du;
  const VF least = hn::Set(d, 0x1p-13f);
  const VF v = hn::Min(hn::IfThenElse(hn::Ge(value, least), value, least), hn::Set(d, 0x1.fffffep-1f));
  const VU bits = hn::BitCast(du, v);
  const VU index = hn::ShiftRight<16>(bits) - hn::Set(du, image::kSrgb8FirstStep);
  const VU step = hn::GatherIndex(du, image::kLinearToSrgb8Steps.step, hn::BitCast(DI(), index));
  const VU low = hn::And(bits, hn::Set(du, 0xffffu)), threshold = hn::And(step, hn::Set(du, 0x1ffffu));
  const auto reached = hn::Not(hn::Lt(hn::BitCast(DI(), low), hn::BitCast(DI(), threshold)));
  return hn::ShiftRight<17>(step) + hn::IfThenElseZero(hn::RebindMask(du, reached), hn::Set(du, 1u));
}

/// image::float_to_half() of each lane.
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

/// Stores the only word of each pixel.
HWY_INLINE void StorePixels(VU word, unsigned char* out) {
#if HWY_TARGET == HWY_SCALAR  // has no vector of bytes
  const uint32_t lane = hn::GetLane(word);
  std::memcpy(out, &lane, sizeof lane);
#else
  const hn::Repartition<uint8_t, DF> bytes;
  hn::StoreU(hn::BitCast(bytes, word), bytes, out);
#endif
}

/// Stores pixels that `interleave(words)` writes as words.
template <size_t kWords, class Interleave>
HWY_INLINE void StorePixels(const Interleave& interleave, unsigned char* out) {
  uint32_t words[kWords * HWY_MAX_BYTES / sizeof(uint32_t)];
  interleave(words);
  std::memcpy(out, words, kWords * hn::Lanes(DU()) * sizeof(uint32_t));
}

/// The formats: pixels of kWords words of 32 bits, written one vector of pixels after the other.
struct Unorm8 {
  static constexpr size_t kWords = 1;
  static HWY_INLINE void Encode(const VF (&p)[4], unsigned char* out) { StorePixels(Unorm8Codes<4>(p), out); }
};
struct Srgb8 {
  static constexpr size_t kWords = 1;
  static HWY_INLINE void Encode(const VF (&p)[4], unsigned char* out) {
    const VU rgb[3] = {SrgbCode(p[0]), SrgbCode(p[1]), SrgbCode(p[2])};
    StorePixels(hn::Or(PackCodes(rgb), hn::ShiftLeft<24>(Unorm8Codes<1>(p + 3))), out);
  }
};
struct Unorm16 {
  static constexpr size_t kWords = 2;
  static HWY_INLINE void Encode(const VF (&p)[4], unsigned char* out) {
    const VU low = hn::Or(UnormCode<16>(p[0]), hn::ShiftLeft<16>(UnormCode<16>(p[1])));
    const VU high = hn::Or(UnormCode<16>(p[2]), hn::ShiftLeft<16>(UnormCode<16>(p[3])));
    StorePixels<kWords>([&](uint32_t* words) { hn::StoreInterleaved2(low, high, DU(), words); }, out);
  }
};
struct Half {
  static constexpr size_t kWords = 2;
  static HWY_INLINE void Encode(const VF (&p)[4], unsigned char* out) {
    const VU low = hn::Or(HalfBits(p[0]), hn::ShiftLeft<16>(HalfBits(p[1])));
    const VU high = hn::Or(HalfBits(p[2]), hn::ShiftLeft<16>(HalfBits(p[3])));
    StorePixels<kWords>([&](uint32_t* words) { hn::StoreInterleaved2(low, high, DU(), words); }, out);
  }
};
struct Float {
  static constexpr size_t kWords = 4;
  static HWY_INLINE void Encode(const VF (&p)[4], unsigned char* out) {
    const DU du;
    const VU r = hn::BitCast(du, p[0]), g = hn::BitCast(du, p[1]), b = hn::BitCast(du, p[2]), a = hn::BitCast(du, p[3]);
    StorePixels<kWords>([&](uint32_t* words) { hn::StoreInterleaved4(r, g, b, a, du, words); }, out);
  }
};

template <class Pixel>
void EncodeRow(const float* const plane[4], size_t count, unsigned char* out) {
  const DF d;
  const size_t lanes = hn::Lanes(d);
  constexpr size_t kBytes = Pixel::kWords * sizeof(uint32_t);
  size_t i = 0;
  for (; i + lanes <= count; i += lanes) {
    const VF p[4] = {hn::LoadU(d, plane[0] + i), hn::LoadU(d, plane[1] + i), hn::LoadU(d, plane[2] + i),
                     hn::LoadU(d, plane[3] + i)};
    Pixel::Encode(p, out + i * kBytes);
  }
  if (i == count) return;
  float rest[4][HWY_MAX_BYTES / sizeof(float)] = {};
  for (size_t c = 0; c < 4; ++c) std::memcpy(rest[c], plane[c] + i, (count - i) * sizeof(float));
  const VF p[4] = {hn::LoadU(d, rest[0]), hn::LoadU(d, rest[1]), hn::LoadU(d, rest[2]), hn::LoadU(d, rest[3])};
  unsigned char pixels[Pixel::kWords * HWY_MAX_BYTES];
  Pixel::Encode(p, pixels);
  std::memcpy(out + i * kBytes, pixels, (count - i) * kBytes);
}

void Encode(shd_format format, const float* const plane[4], size_t count, void* out) {
  auto* bytes = static_cast<unsigned char*>(out);
  switch (format) {
    case SHD_FORMAT_RGBA8: return EncodeRow<Unorm8>(plane, count, bytes);
    case SHD_FORMAT_RGBA8_SRGB: return EncodeRow<Srgb8>(plane, count, bytes);
    case SHD_FORMAT_RGBA16: return EncodeRow<Unorm16>(plane, count, bytes);
    case SHD_FORMAT_RGBA16F: return EncodeRow<Half>(plane, count, bytes);
    default: return EncodeRow<Float>(plane, count, bytes);
  }
}

}  // namespace shd::film::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::film {
namespace {
HWY_EXPORT(Encode);

template <class T, class Value>
void decode(const void* in, size_t count, float* const plane[4], const Value& value) {
  const auto* bytes = static_cast<const unsigned char*>(in);
  for (size_t i = 0; i < count; ++i, bytes += 4 * sizeof(T)) {
    T channel[4];
    std::memcpy(channel, bytes, sizeof channel);
    for (size_t c = 0; c < 4; ++c) plane[c][i] = value(channel[c], c);
  }
}

}  // namespace

bool can_encode(shd_format format) {
  switch (format) {
    case SHD_FORMAT_RGBA8:
    case SHD_FORMAT_RGBA8_SRGB:
    case SHD_FORMAT_RGBA16:
    case SHD_FORMAT_RGBA16F:
    case SHD_FORMAT_RGBA32F: return true;
    default: return false;
  }
}

bool can_draw(shd_format format) {
  return can_encode(format) && format != SHD_FORMAT_RGBA16;
}

void encode_pixels(const core::SimdTarget& simd, shd_format format, const float* const plane[4], size_t count,
                   void* out) {
  SHD_DISPATCH(Encode, simd)(format, plane, count, out);
}

void decode_pixels(shd_format format, const void* in, size_t count, float* const plane[4]) {
  const auto unorm = [](uint8_t code) { return static_cast<float>(code) / 255.0f; };
  switch (format) {
    case SHD_FORMAT_RGBA8: return decode<uint8_t>(in, count, plane, [&](uint8_t code, size_t) { return unorm(code); });
    case SHD_FORMAT_RGBA8_SRGB:
      return decode<uint8_t>(in, count, plane, [&](uint8_t code, size_t c) {
        return c == 3 ? unorm(code) : image::srgb8_to_linear(code);
      });
    case SHD_FORMAT_RGBA16F:
      return decode<uint16_t>(in, count, plane, [](uint16_t half, size_t) { return image::half_to_float(half); });
    default: SHD_ASSERT(false);
  }
}

}  // namespace shd::film
#endif
