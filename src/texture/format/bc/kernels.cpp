// SPDX-License-Identifier: MIT
// Decoders of BC1 and BC7 whose rows of texels are the bytes of vectors. They have the bits of the scalar decoders.
#include <cstring>

#include "texture/format/bc/bc7_tables.h"
#include "texture/format/bc/decode.h"
#include "texture/format/bc/kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/format/bc/kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "simd/kernel_part.h"
#include "texture/format/bc/kernels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET == HWY_SCALAR
DecodeBc KernelOf(DecodeBc decode) {
  return decode;
}
#else
namespace {

using Bytes = hn::Full128<uint8_t>;
using ByteVec = hn::Vec<Bytes>;
using Wide = hn::CappedTag<uint8_t, 64>;  // one, two or four rows of a block of RGBA
using WideWords = hn::Repartition<uint16_t, Wide>;
using WideVec = hn::Vec<Wide>;
constexpr size_t kRowBytes = 16;

/// Repeats 16 bytes. The recursion ends by size, because versions of Highway differ in the type of the last half.
template <class D>
HWY_INLINE hn::Vec<D> Repeated(D d, ByteVec v) {
  if constexpr (hn::MaxLanes(D()) == kRowBytes) {
    return v;
  } else {
    const auto half = Repeated(hn::Half<D>(), v);
    return hn::Combine(d, half, half);
  }
}

/// Writes rows of texels.
template <class D>
HWY_INLINE void WriteRows(D d, hn::Vec<D> rows, uint8_t* texels, size_t pitch) {
  if constexpr (hn::MaxLanes(D()) == kRowBytes) {
    hn::StoreU(rows, d, texels);
  } else {
    const hn::Half<D> half;
    WriteRows(half, hn::LowerHalf(half, rows), texels, pitch);
    WriteRows(half, hn::UpperHalf(half, rows), texels + hn::Lanes(half) / kRowBytes * pitch, pitch);
  }
}

/// Bytes 0 to 63: for each byte of four rows, its texel, its channel, and the texel of each word.
struct Layout {
  alignas(64) uint8_t texel[64], channel[64], word[64], green[64], alpha[64];
};
constexpr Layout MakeLayout() {
  Layout out = {};
  for (size_t i = 0; i < 64; ++i) {
    out.texel[i] = static_cast<uint8_t>(i / 4);
    out.channel[i] = static_cast<uint8_t>(i % 4);
    out.word[i] = static_cast<uint8_t>(i % 2 == 0 ? i / 4 : 0x80);
    out.green[i] = static_cast<uint8_t>(i % 4 == 0 ? i / 4 : 0x80);
    out.alpha[i] = static_cast<uint8_t>(i % 4 == 2 ? i / 4 : 0x80);
  }
  return out;
}
constexpr Layout kLayout = MakeLayout();

/// Returns for each byte of rows, beginning at byte `first` of the block, the byte of its channel in a table of
/// colours. `color`: four times the colour of each texel.
HWY_INLINE WideVec ColorsAt(size_t first, WideVec color) {
  const Wide d;
  return hn::TableLookupBytes(color, hn::Load(d, kLayout.texel + first)) + hn::Load(d, kLayout.channel + first);
}

/// Returns four times the index of each texel of a BC1 block.
HWY_INLINE ByteVec Bc1Indices(const uint8_t* bytes) {
  const Bytes d;
  const hn::Full128<uint32_t> du;
  alignas(16) static constexpr uint8_t kMask[16] = {3, 12, 3, 12, 3, 12, 3, 12, 3, 12, 3, 12, 3, 12, 3, 12};
  alignas(16) static constexpr uint8_t kIndex[16] = {0, 4, 8, 12, 4, 4, 4, 4, 8, 8, 8, 8, 12, 12, 12, 12};
  const auto bits = hn::BitCast(d, hn::Set(du, static_cast<uint32_t>(bits_at<4>(bytes))));
  const auto low = hn::And(bits, hn::Set(d, 15));
  const auto high = hn::And(hn::BitCast(d, hn::ShiftRight<4>(hn::BitCast(du, bits))), hn::Set(d, 15));
  const auto halves = hn::InterleaveLower(d, low, high);
  return hn::TableLookupBytes(hn::Load(d, kIndex), hn::And(hn::InterleaveLower(d, halves, halves), hn::Load(d, kMask)));
}

/// Returns the four colours of a BC1 block.
template <bool kOpaque>
HWY_INLINE ByteVec Bc1Palette(const uint8_t* bytes) {
  const hn::Full128<uint16_t> d;
  const hn::RebindToSigned<decltype(d)> di;
  const hn::Half<Bytes> half;
  // Lanes are the channels of the first colour, then of the second one. A field is moved to the top of its lane.
  alignas(16) static constexpr uint8_t kSpread[16] = {0, 1, 0, 1, 0, 1, 0, 1, 2, 3, 2, 3, 2, 3, 2, 3};
  alignas(16) static constexpr uint16_t kFactor[8] = {1, 32, 2048, 0, 1, 32, 2048, 0};
  alignas(16) static constexpr uint16_t kKeep[8] = {0xf800, 0xfc00, 0xf800, 0, 0xf800, 0xfc00, 0xf800, 0};
  alignas(16) static constexpr uint16_t kRepeat[8] = {2048, 1024, 2048, 0, 2048, 1024, 2048, 0};
  alignas(16) static constexpr uint16_t kAlpha[8] = {0, 0, 0, 255, 0, 0, 0, 255};
  alignas(16) static constexpr uint16_t kFourth[8] = {0xffff, 0xffff, 0xffff, 0xffff, 0, 0, 0, kOpaque ? 0xffff : 0};
  const auto ends = static_cast<uint32_t>(bits_at<4>(bytes));
  const auto words = hn::BitCast(Bytes(), hn::Set(hn::Full128<uint32_t>(), ends));
  const auto spread = hn::BitCast(d, hn::TableLookupBytes(words, hn::Load(Bytes(), kSpread)));
  const auto field = hn::And(spread * hn::Load(d, kFactor), hn::Load(d, kKeep));
  const auto colors = hn::ShiftRight<8>(hn::Or(field, hn::MulHigh(field, hn::Load(d, kRepeat)))) + hn::Load(d, kAlpha);
  const auto swapped = hn::BitCast(d, hn::Shuffle01(hn::BitCast(hn::Full128<uint64_t>(), colors)));
  const auto sum = colors + swapped + hn::Set(d, 1);
  // For n = 2 a + b + 1 <= 766, 683 n / 2^11 exceeds n / 3 by less than 1/8.
  const auto thirds = hn::MulHigh(sum + colors, hn::Set(d, 683 << 5));
  const auto middle = hn::And(hn::ShiftRight<1>(sum), hn::Load(d, kFourth));
  // Without a branch, because the order of endpoints has no pattern.
  const auto four = hn::Set(d, static_cast<uint16_t>(-static_cast<int32_t>((ends & 0xffff) > ends >> 16)));
  const auto others = hn::Or(hn::And(four, thirds), hn::AndNot(four, middle));
  return hn::Combine(Bytes(), hn::DemoteTo(half, hn::BitCast(di, others)), hn::DemoteTo(half, hn::BitCast(di, colors)));
}

template <bool kOpaque>
void DecodeBc1(const uint8_t* block, uint8_t* texels, size_t pitch) {
  const Wide d;
  const auto palette = Repeated(d, Bc1Palette<kOpaque>(block)), index = Repeated(d, Bc1Indices(block + 4));
  for (size_t i = 0; i < 64; i += hn::Lanes(d), texels += hn::Lanes(d) / kRowBytes * pitch) {
    WriteRows(d, hn::TableLookupBytes(palette, ColorsAt(i, index)), texels, pitch);
  }
}

/// The endpoints of up to three subsets as RGBA, and four times the subset of every texel.
struct Ends {
  WideVec first, second, subset;
};

/// Returns the endpoints of lanes `first` to `first` + Lanes - 1 of a block.
HWY_INLINE hn::Vec<WideWords> ReadEndpoints(const bc7::ModeTable& mode, WideVec bytes, size_t first) {
  const Wide d;
  const WideWords dw;
  const auto at = [&](const uint8_t* window, const uint16_t* factor) SHD_INLINE_LAMBDA {
    const auto words = hn::TableLookupBytes(bytes, hn::Load(d, window + 2 * first));
    return hn::BitCast(dw, words) * hn::Load(dw, factor + first);
  };
  const auto field = hn::And(at(mode.window, mode.factor), hn::LoadDup128(dw, mode.keep));
  const auto lowest = hn::And(at(mode.p_window, mode.p_factor), hn::LoadDup128(dw, mode.p_keep));
  const auto top = hn::Or(field, lowest);
  const auto code = hn::ShiftRight<8>(hn::Or(top, hn::MulHigh(top, hn::LoadDup128(dw, mode.repeat))));
  return hn::Or(code, hn::LoadDup128(dw, mode.fill));
}

template <class D, class V>
HWY_INLINE hn::Vec<hn::Half<D> > Narrowed(D, V words) {
  return hn::DemoteTo(hn::Half<D>(), hn::BitCast(hn::RebindToSigned<hn::Repartition<uint16_t, D> >(), words));
}

template <class D>
HWY_INLINE Ends EndsOf(D d, const bc7::ModeTable& mode, uint32_t partition, ByteVec bytes) {
  constexpr size_t kLanes = hn::MaxLanes(hn::Repartition<uint16_t, D>());
  const auto block = Repeated(d, bytes);
  const auto subset = hn::LoadDup128(d, bc7::kSubsets.row[mode.subsets + partition].texel);
  const auto codes = [&](size_t first) SHD_INLINE_LAMBDA { return Narrowed(d, ReadEndpoints(mode, block, first)); };
  if constexpr (kLanes == 32) {
    const auto both = codes(0);
    const hn::Half<D> half;
    return {Repeated(d, hn::LowerHalf(Bytes(), both)), Repeated(d, hn::UpperHalf(hn::Half<decltype(half)>(), both)),
            subset};
  } else if constexpr (kLanes == 16) {
    return {Repeated(d, codes(0)), Repeated(d, codes(kLanes)), subset};
  } else {
    return {hn::Combine(d, codes(kLanes), codes(0)), hn::Combine(d, codes(3 * kLanes), codes(2 * kLanes)), subset};
  }
}

/// Returns the weights of 16 indices.
HWY_INLINE ByteVec WeightsOf(const bc7::IndexTable& table, uint64_t indices) {
  const Bytes d;
  const hn::CappedTag<uint16_t, 16> dw;
  const hn::Repartition<uint8_t, decltype(dw)> db;
  const auto bits = hn::BitCast(db, hn::Set(hn::Repartition<uint64_t, decltype(dw)>(), indices));
  const auto top = [&](size_t first) SHD_INLINE_LAMBDA {
    const auto words = hn::BitCast(dw, hn::TableLookupBytes(bits, hn::Load(db, table.window + 2 * first)));
    const auto four = hn::ShiftRight<12>(words * hn::Load(dw, table.factor + first));
    return hn::DemoteTo(hn::Half<decltype(db)>(), hn::BitCast(hn::RebindToSigned<decltype(dw)>(), four));
  };
  const auto weights = hn::Load(d, table.weight);
#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
  return hn::TableLookupBytes(weights, top(0));
#else
  return hn::TableLookupBytes(weights, hn::Combine(d, top(8), top(0)));
#endif
}

/// Writes (64 - w) a + w b, rounded to codes, of all texels. Words have the weights of their channel of lower and of
/// higher significance. turn(rows) returns the rows that are written.
template <class Weights, class Turn>
HWY_INLINE void Mix(const Ends& ends, const Weights& weights, const Turn& turn, uint8_t* texels, size_t pitch) {
  const Wide d;
  const WideWords dw;
  const auto low_byte = hn::Set(dw, 255), half = hn::Set(dw, 32);
  for (size_t i = 0; i < 64; i += hn::Lanes(d), texels += hn::Lanes(d) / kRowBytes * pitch) {
    const auto at = ColorsAt(i, ends.subset);
    const auto a = hn::BitCast(dw, hn::TableLookupBytes(ends.first, at));
    const auto b = hn::BitCast(dw, hn::TableLookupBytes(ends.second, at));
    // Differences wrap around, and the sum wraps back.
    const auto mix = [&](auto a16, auto b16, auto w)
                         SHD_INLINE_LAMBDA { return hn::ShiftLeft<6>(a16) + (b16 - a16) * hn::BitCast(dw, w) + half; };
    const auto low = hn::ShiftRight<6>(mix(hn::And(a, low_byte), hn::And(b, low_byte), weights.low(i)));
    const auto high = mix(hn::ShiftRight<8>(a), hn::ShiftRight<8>(b), weights.high(i));
    const auto both = hn::Or(low, hn::AndNot(low_byte, hn::ShiftLeft<2>(high)));
    WriteRows(d, turn(hn::BitCast(d, both)), texels, pitch);
  }
}

/// One weight for all channels of a texel.
struct SameWeights {
  WideVec weight;
  HWY_INLINE WideVec low(size_t i) const { return hn::TableLookupBytesOr0(weight, hn::Load(Wide(), kLayout.word + i)); }
  HWY_INLINE WideVec high(size_t i) const { return low(i); }
};

/// Alpha has a weight of its own.
struct SeparateWeights {
  WideVec color, alpha;
  HWY_INLINE WideVec low(size_t i) const { return hn::TableLookupBytesOr0(color, hn::Load(Wide(), kLayout.word + i)); }
  HWY_INLINE WideVec high(size_t i) const {
    return hn::Or(hn::TableLookupBytesOr0(color, hn::Load(Wide(), kLayout.green + i)),
                  hn::TableLookupBytesOr0(alpha, hn::Load(Wide(), kLayout.alpha + i)));
  }
};

/// Modes 4 and 5: color and alpha have indices of their own, and alpha is swapped with a channel.
HWY_NOINLINE void DecodeSeparate(uint32_t number, const bc7::Block& block, ByteVec bytes, uint8_t* texels,
                                 size_t pitch) {
  const Wide d;
  const bc7::ModeTable& table = bc7::kModeTables.mode[number];
  const bc7::Mode& mode = bc7::kModes[number];
  const auto rotation = static_cast<uint32_t>(block.field(number + 1, mode.rotation));
  const bool swapped = block.field(number + 1 + mode.rotation, mode.selection) != 0;
  const auto weights = [&](uint32_t bits, uint32_t position) SHD_INLINE_LAMBDA {
    const uint64_t indices = insert_zero(block.field(position, 16 * bits - 1), bits - 1);
    return Repeated(d, WeightsOf(bc7::kIndexTables.of_bits[bits - 2], indices));
  };
  const auto first = weights(mode.index, table.index_shift);
  const auto second = weights(mode.second_index, table.index_shift + 16 * mode.index - 1);
  alignas(16) static constexpr uint8_t kTurn[4][16] = {{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15},
                                                       {3, 1, 2, 0, 7, 5, 6, 4, 11, 9, 10, 8, 15, 13, 14, 12},
                                                       {0, 3, 2, 1, 4, 7, 6, 5, 8, 11, 10, 9, 12, 15, 14, 13},
                                                       {0, 1, 3, 2, 4, 5, 7, 6, 8, 9, 11, 10, 12, 13, 15, 14}};
  const auto order = hn::LoadDup128(d, kTurn[rotation]);
  const SeparateWeights both = {swapped ? second : first, swapped ? first : second};
  const auto turn = [&](WideVec rows) SHD_INLINE_LAMBDA { return hn::TableLookupBytes(rows, order); };
  Mix(EndsOf(d, table, 0, bytes), both, turn, texels, pitch);
}

void DecodeBc7(const uint8_t* bytes, uint8_t* texels, size_t pitch) {
  const Wide d;
  const bc7::Block block = {bits_at<8>(bytes), bits_at<8>(bytes + 8)};
  const auto number = static_cast<uint32_t>(__builtin_ctz(bytes[0] | 256u));
  const bc7::ModeTable& mode = bc7::kModeTables.mode[number];
  const auto raw = hn::LoadU(Bytes(), bytes);
  if (HWY_UNLIKELY(mode.separate)) return DecodeSeparate(number, block, raw, texels, pitch);
  const uint32_t partition = static_cast<uint32_t>(block.low >> mode.partition_shift) & mode.partition_mask;
  const bc7::AnchorRow anchors = bc7::kAnchors.row[mode.anchors + partition];
  uint64_t indices = block.high >> mode.index_shift;
  // The bits from a position on are doubled, so that a zero is inserted there.
  for (const uint32_t position : {uint32_t{anchors.last}, uint32_t{anchors.second}, mode.bits - 1}) {
    indices += indices & ~uint64_t{0} << position;
  }
  const SameWeights weights = {Repeated(d, WeightsOf(bc7::kIndexTables.of_bits[mode.bits - 2], indices))};
  Mix(
      EndsOf(d, mode, partition, raw), weights, [](WideVec rows) SHD_INLINE_LAMBDA { return rows; }, texels, pitch);
}

}  // namespace

DecodeBc KernelOf(DecodeBc decode) {
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

DecodeBc kernel_of(DecodeBc decode, const core::SimdTarget& simd) {
  return HWY_DISPATCH_TABLE(KernelOf)[simd.index](decode);
}
}  // namespace shd::texture
#endif
