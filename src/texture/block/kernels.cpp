// SPDX-License-Identifier: MIT
// Decoders of BC1 and BC7 whose 16 texels are the lanes of vectors of bytes. They have the bits of the scalar decoders.
#include <cstring>

#include "texture/block/bc7.h"
#include "texture/block/decode.h"
#include "texture/block/kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/block/kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/block/kernels-inl.h"
#include "texture/kernel_part.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET == HWY_SCALAR
DecodeBlock KernelOf(DecodeBlock decode) {
  return decode;
}
#else
namespace {

using Bytes = hn::Full128<uint8_t>;
using Words = hn::Full128<uint16_t>;
using ByteVec = hn::Vec<Bytes>;

/// Spreads eight codes of kBits bits to the bytes of a word.
template <uint32_t kBits>
HWY_INLINE uint64_t Spread(uint64_t x) {
  constexpr uint64_t kFour = (uint64_t{1} << 4 * kBits) - 1, kTwo = (1u << 2 * kBits) - 1, kOne = (1u << kBits) - 1;
  x = (x | x << (32 - 4 * kBits)) & kFour * 0x0000000100000001;
  x = (x | x << (16 - 2 * kBits)) & kTwo * 0x0001000100010001;
  return (x | x << (8 - kBits)) & kOne * 0x0101010101010101;
}

/// Returns a vector of two words, made in registers: a load of 16 bytes would wait for two stores of 8.
HWY_INLINE ByteVec BytesOf(uint64_t low, uint64_t high) {
  const hn::Full128<uint64_t> d;
  const hn::Half<decltype(d)> half;
  return hn::BitCast(Bytes(), hn::Combine(d, hn::Set(half, high), hn::Set(half, low)));
}

/// Spreads 16 codes to bytes.
template <uint32_t kBits>
HWY_INLINE ByteVec SpreadAll(uint64_t codes) {
  return BytesOf(Spread<kBits>(codes & ((uint64_t{1} << 8 * kBits) - 1)), Spread<kBits>(codes >> 8 * kBits));
}

/// Writes colours of a palette of four. `index`: byte i is four times the index of texel i.
HWY_INLINE void WritePalette(ByteVec palette, ByteVec index, uint8_t* texels, size_t pitch) {
  const Bytes d;
  alignas(16) static constexpr uint8_t kRepeat[16] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};
  alignas(16) static constexpr uint8_t kChannel[16] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
  const auto repeat = hn::Load(d, kRepeat), channel = hn::Load(d, kChannel);
  for (uint32_t y = 0; y < 4; ++y) {
    const auto from = hn::TableLookupBytes(index, repeat + hn::Set(d, static_cast<uint8_t>(4 * y))) + channel;
    hn::StoreU(hn::TableLookupBytes(palette, from), d, texels + y * pitch);
  }
}

template <bool kOpaque>
void DecodeBc1(const uint8_t* block, uint8_t* texels, size_t pitch) {
  const Palette palette = bc1_palette(block, kOpaque);
  const ByteVec index = SpreadAll<2>(bits_at<4>(block + 4));
  const auto twice = index + index;
  WritePalette(BytesOf(palette.low, palette.high), twice + twice, texels, pitch);
}

/// The endpoints of up to three subsets as RGBA, and the subset of every texel times 4.
struct Ends {
  ByteVec first, second, subset;
};

/// Returns channel c of all texels: (64 - w) a + w b, rounded to codes.
HWY_INLINE ByteVec MixChannel(const Ends& ends, uint32_t c, ByteVec weight) {
  const Bytes d;
  const Words dw;
  const auto at = ends.subset + hn::Set(d, static_cast<uint8_t>(c));
  const auto a = hn::TableLookupBytes(ends.first, at), b = hn::TableLookupBytes(ends.second, at);
  const auto zero = hn::Zero(d);
  const auto mix = [&](auto a8, auto b8, auto w8) SHD_INLINE_LAMBDA {
    const auto a16 = hn::BitCast(dw, a8), b16 = hn::BitCast(dw, b8), w16 = hn::BitCast(dw, w8);
    // Differences wrap around, and the sum wraps back.
    return hn::ShiftRight<6>(hn::ShiftLeft<6>(a16) + (b16 - a16) * w16 + hn::Set(dw, 32));
  };
  const auto low =
      mix(hn::InterleaveLower(d, a, zero), hn::InterleaveLower(d, b, zero), hn::InterleaveLower(d, weight, zero));
  const auto high =
      mix(hn::InterleaveUpper(d, a, zero), hn::InterleaveUpper(d, b, zero), hn::InterleaveUpper(d, weight, zero));
  const hn::RebindToSigned<Words> di;
  const hn::Half<Bytes> half;
  return hn::Combine(d, hn::DemoteTo(half, hn::BitCast(di, high)), hn::DemoteTo(half, hn::BitCast(di, low)));
}

/// Interleaves four channels.
HWY_INLINE void WriteChannels(const ByteVec (&channel)[4], uint8_t* texels, size_t pitch) {
  const Bytes d;
  const Words dw;
  const auto rg_low = hn::BitCast(dw, hn::InterleaveLower(d, channel[0], channel[1]));
  const auto rg_high = hn::BitCast(dw, hn::InterleaveUpper(d, channel[0], channel[1]));
  const auto ba_low = hn::BitCast(dw, hn::InterleaveLower(d, channel[2], channel[3]));
  const auto ba_high = hn::BitCast(dw, hn::InterleaveUpper(d, channel[2], channel[3]));
  hn::StoreU(hn::BitCast(d, hn::InterleaveLower(dw, rg_low, ba_low)), d, texels);
  hn::StoreU(hn::BitCast(d, hn::InterleaveUpper(dw, rg_low, ba_low)), d, texels + pitch);
  hn::StoreU(hn::BitCast(d, hn::InterleaveLower(dw, rg_high, ba_high)), d, texels + 2 * pitch);
  hn::StoreU(hn::BitCast(d, hn::InterleaveUpper(dw, rg_high, ba_high)), d, texels + 3 * pitch);
}

/// Returns the weights of 16 indices of kBits bits.
template <uint32_t kBits>
HWY_INLINE ByteVec WeightsOf(uint64_t indices) {
  alignas(16) static constexpr uint8_t kTable[3][16] = {
      {0, 21, 43, 64}, {0, 9, 18, 27, 37, 46, 55, 64}, {0, 4, 9, 13, 17, 21, 26, 30, 34, 38, 43, 47, 51, 55, 60, 64}};
  return hn::TableLookupBytes(hn::Load(Bytes(), kTable[kBits - 2]), SpreadAll<kBits>(indices));
}

template <uint32_t kMode>
HWY_INLINE Ends EndsOf(const uint64_t (&endpoint)[6], uint32_t partition) {
  constexpr uint32_t kSubsets = bc7::kModes[kMode].subsets;
  uint64_t first[2] = {}, second[2] = {};
  for (uint32_t s = 0; s < kSubsets; ++s) {
    first[s / 2] |= uint64_t{bc7::packed(endpoint[2 * s])} << (s % 2 * 32);
    second[s / 2] |= uint64_t{bc7::packed(endpoint[2 * s + 1])} << (s % 2 * 32);
  }
  const Bytes d;
  auto subset = hn::Zero(d);
  if constexpr (kSubsets > 1) {
    subset = SpreadAll<2>(kSubsets == 2 ? kTwoSubsets[partition] : kThreeSubsets[partition]);
    subset = subset + subset;
    subset = subset + subset;
  }
  return {BytesOf(first[0], first[1]), BytesOf(second[0], second[1]), subset};
}

template <uint32_t kMode>
HWY_INLINE void DecodeMode(const bc7::Block& block, uint8_t* texels, size_t pitch) {
  constexpr bc7::Mode m = bc7::kModes[kMode];
  const auto partition = static_cast<uint32_t>(block.field(kMode + 1, m.partition));
  uint64_t endpoint[6];
  const uint32_t position = bc7::read_endpoints<kMode>(block, kMode + 1 + m.partition, endpoint);
  const ByteVec weight =
      WeightsOf<m.index>(whole_indices<m.index, m.subsets>(block.field(position, 16 * m.index - m.subsets), partition));
  const Ends ends = EndsOf<kMode>(endpoint, partition);
  ByteVec channel[4];
  for (uint32_t c = 0; c < 3; ++c) channel[c] = MixChannel(ends, c, weight);
  channel[3] = m.alpha > 0 ? MixChannel(ends, 3, weight) : hn::Set(Bytes(), 255);
  WriteChannels(channel, texels, pitch);
}

/// Modes 4 and 5: color and alpha have indices of their own.
template <uint32_t kMode>
HWY_INLINE void DecodeSeparate(const bc7::Block& block, uint8_t* texels, size_t pitch) {
  constexpr bc7::Mode m = bc7::kModes[kMode];
  const auto rotation = static_cast<uint32_t>(block.field(kMode + 1, m.rotation));
  const bool swapped = m.selection && block.field(kMode + 1 + m.rotation, m.selection);
  uint64_t endpoint[6];
  const uint32_t position = bc7::read_endpoints<kMode>(block, kMode + 1 + m.rotation + m.selection, endpoint);
  const ByteVec first = WeightsOf<m.index>(whole_indices<m.index, 1>(block.field(position, 16 * m.index - 1), 0));
  const ByteVec second = WeightsOf<m.second_index>(
      whole_indices<m.second_index, 1>(block.field(position + 16 * m.index - 1, 16 * m.second_index - 1), 0));
  const ByteVec color = swapped ? second : first, alpha = swapped ? first : second;
  const Ends ends = EndsOf<kMode>(endpoint, 0);
  ByteVec channel[4];
  for (uint32_t c = 0; c < 4; ++c) channel[c] = MixChannel(ends, c, c < 3 ? color : alpha);
  if (rotation > 0) {
    const ByteVec turned = channel[3];
    channel[3] = channel[rotation - 1];
    channel[rotation - 1] = turned;
  }
  WriteChannels(channel, texels, pitch);
}

void DecodeBc7(const uint8_t* bytes, uint8_t* texels, size_t pitch) {
  const bc7::Block block = {bits_at<8>(bytes), bits_at<8>(bytes + 8)};
  if (bytes[0] == 0) return decode_bc7(bytes, texels, pitch);  // reserved
  switch (__builtin_ctz(bytes[0])) {
    case 0: return DecodeMode<0>(block, texels, pitch);
    case 1: return DecodeMode<1>(block, texels, pitch);
    case 2: return DecodeMode<2>(block, texels, pitch);
    case 3: return DecodeMode<3>(block, texels, pitch);
    case 4: return DecodeSeparate<4>(block, texels, pitch);
    case 5: return DecodeSeparate<5>(block, texels, pitch);
    case 6: return DecodeMode<6>(block, texels, pitch);
    default: return DecodeMode<7>(block, texels, pitch);
  }
}

}  // namespace

DecodeBlock KernelOf(DecodeBlock decode) {
  if (decode == decode_bc1_rgb) return DecodeBc1<true>;
  if (decode == decode_bc1_rgba) return DecodeBc1<false>;
  if (decode == decode_bc7) return DecodeBc7;
  return decode;
}
#endif

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::texture {
namespace {
HWY_EXPORT(KernelOf);
}  // namespace

DecodeBlock kernel_of(DecodeBlock decode, const core::SimdTarget& simd) {
  return HWY_DISPATCH_TABLE(KernelOf)[simd.index](decode);
}
}  // namespace shd::texture
#endif
