// SPDX-License-Identifier: MIT
// Sums of quads in fixed point, one lookup at a time, for 8-bit formats.
#include "texture/format/fixed.h"

#include <cstring>

#include "image/format.h"
#include "image/srgb.h"
#include "texture/stream.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/format/fixed.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/footprint/shapes-inl.h"
#include "texture/format/formats-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

/// The texels of a quad's rows, where all texels are in one block and each right one is next to its left one, or has
/// weight 0. Reads up to 7 bytes after a texel.
template <size_t kSize>
struct NextTexels {
  static constexpr size_t kTexelSize = kSize;
  const uint8_t* origin;

  /// Returns two texels, the left one in the low bytes.
  HWY_INLINE uint64_t row(const int32_t* left, const int32_t*, bool) const {
    uint64_t texels;
    std::memcpy(&texels, origin + size_t{static_cast<uint32_t>(*left)} * kSize, sizeof texels);
    return texels;
  }
};

/// The texels of a quad's rows, wherever they are.
template <size_t kSize>
struct AnyTexels {
  static constexpr size_t kTexelSize = kSize;
  const TexelSource& source;

  HWY_INLINE uint64_t row(const int32_t* left, const int32_t* right, bool split) const {
    uint64_t texels;
    std::memcpy(&texels, source.texel(static_cast<uint32_t>(*left)), sizeof texels);
    if (HWY_LIKELY(!split)) return texels;
    uint64_t second = 0;
    std::memcpy(&second, source.texel(static_cast<uint32_t>(*right)), kSize);
    constexpr uint64_t kLow = (uint64_t{1} << (8 * kSize)) - 1;
    return (texels & kLow) | second << (8 * kSize);
  }
};

#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
/// Sums of four channels of one lookup.
struct ChannelSums {
  __m128i sum;

  static HWY_INLINE ChannelSums zero() { return {_mm_setzero_si128()}; }
  static HWY_INLINE ChannelSums load(const int32_t* from) {
    return {_mm_load_si128(reinterpret_cast<const __m128i*>(from))};
  }
  HWY_INLINE void store(int32_t* to) const { _mm_store_si128(reinterpret_cast<__m128i*>(to), sum); }

  HWY_INLINE void add(const ChannelSums& other) { sum = _mm_add_epi32(sum, other.sum); }
  /// Divides by 2^kBits and rounds.
  template <int kBits>
  HWY_INLINE ChannelSums shifted() const {
    return {_mm_srai_epi32(_mm_add_epi32(sum, _mm_set1_epi32(1 << (kBits - 1))), kBits)};
  }

  /// Adds 15-bit values of four channels of two texels by the weights of the texels, left | right << 16.
  HWY_INLINE void add(const uint16_t (&left)[4], const uint16_t (&right)[4], int32_t weights) {
    const auto channels = [&](size_t c) SHD_INLINE_LAMBDA {
      return static_cast<int64_t>(uint64_t{left[c]} | uint64_t{right[c]} << 16 | uint64_t{left[c + 1]} << 32 |
                                  uint64_t{right[c + 1]} << 48);
    };
    const __m128i words = _mm_set_epi64x(channels(2), channels(0));
    sum = _mm_add_epi32(sum, _mm_madd_epi16(words, _mm_set1_epi32(weights)));
  }

  /// Adds two texels of kSize bytes by their weights, left | right << 16. The bytes of both are interleaved and widened;
  /// then one instruction multiplies and adds the two of each channel.
  template <size_t kSize>
  HWY_INLINE void add(uint64_t texels, int32_t weights) {
    const __m128i pair = _mm_set_epi64x(0, static_cast<int64_t>(texels));
    const __m128i bytes = _mm_unpacklo_epi8(pair, _mm_srli_epi64(pair, 8 * kSize));
    const __m128i words = _mm_unpacklo_epi8(bytes, _mm_setzero_si128());
    sum = _mm_add_epi32(sum, _mm_madd_epi16(words, _mm_set1_epi32(weights)));
  }
};
#else
/// Sums of four channels of one lookup.
struct ChannelSums {
  int32_t sum[4];

  static HWY_INLINE ChannelSums zero() { return {}; }
  static HWY_INLINE ChannelSums load(const int32_t* from) { return {{from[0], from[1], from[2], from[3]}}; }
  HWY_INLINE void store(int32_t* to) const { std::memcpy(to, sum, sizeof sum); }

  HWY_INLINE void add(const ChannelSums& other) {
    for (size_t c = 0; c < 4; ++c) sum[c] += other.sum[c];
  }
  /// Divides by 2^kBits and rounds.
  template <int kBits>
  HWY_INLINE ChannelSums shifted() const {
    ChannelSums result;
    for (size_t c = 0; c < 4; ++c) result.sum[c] = (sum[c] + (1 << (kBits - 1))) >> kBits;
    return result;
  }

  /// Adds 15-bit values of four channels of two texels by the weights of the texels, left | right << 16.
  HWY_INLINE void add(const uint16_t (&left)[4], const uint16_t (&right)[4], int32_t weights) {
    for (size_t c = 0; c < 4; ++c) sum[c] += (weights & 0xffff) * left[c] + (weights >> 16) * right[c];
  }

  /// Adds two texels of kSize bytes by their weights, left | right << 16.
  template <size_t kSize>
  HWY_INLINE void add(uint64_t texels, int32_t weights) {
    const int32_t left = weights & 0xffff, right = weights >> 16;
    for (size_t c = 0; c < kSize; ++c) {
      const auto first = static_cast<int32_t>(texels >> (8 * c) & 255);
      const auto second = static_cast<int32_t>(texels >> (8 * (kSize + c)) & 255);
      sum[c] += left * first + right * second;
    }
  }
};
#endif

/// Adds a quad of one lookup.
template <class Rows>
HWY_INLINE void AddQuad(const Rows& rows, const FixedQuad& quad, size_t lane, bool split, ChannelSums* sums) {
  const uint64_t upper = rows.row(quad.upper + lane, quad.upper_right + lane, split);
  const uint64_t lower = rows.row(quad.lower + lane, quad.lower_right + lane, split);
  sums->add<Rows::kTexelSize>(upper, quad.upper_weights[lane]);
  sums->add<Rows::kTexelSize>(lower, quad.lower_weights[lane]);
}

template <class Rows, bool kTwoSums>
HWY_INLINE void SumLanes(const Rows& rows, const FixedQuads& quads, size_t lanes, bool first, FixedSums* sums) {
  for (size_t lane = 0; lane < lanes; ++lane) {
    ChannelSums sum0 = first ? ChannelSums::zero() : ChannelSums::load(sums->sum[0][lane]);
    ChannelSums sum1 = first || !kTwoSums ? ChannelSums::zero() : ChannelSums::load(sums->sum[1][lane]);
    const auto end = static_cast<size_t>(quads.count[lane]);
    const FixedQuad* quad = quads.quad;
    for (size_t row = 0; row < end; ++row, quad += 2) {
      const uint32_t split = quads.split >> (2 * row);
      AddQuad(rows, quad[0], lane, split & 1, &sum0);
      if (kTwoSums) AddQuad(rows, quad[1], lane, split & 2, &sum1);
    }
    sum0.store(sums->sum[0][lane]);
    if (kTwoSums) sum1.store(sums->sum[1][lane]);
  }
}

/// A SumFixed for unorm texels of kSize bytes.
template <size_t kSize>
void SumUnorm(const TexelSource& source, const FixedQuads& quads, size_t lanes, bool first, FixedSums* sums) {
  if (HWY_UNLIKELY(quads.split != 0 || source.borrowed)) {
    const AnyTexels<kSize> rows = {source};
    return quads.two_sums ? SumLanes<AnyTexels<kSize>, true>(rows, quads, lanes, first, sums)
                          : SumLanes<AnyTexels<kSize>, false>(rows, quads, lanes, first, sums);
  }
  const NextTexels<kSize> rows = {source.origin};
  return quads.two_sums ? SumLanes<NextTexels<kSize>, true>(rows, quads, lanes, first, sums)
                        : SumLanes<NextTexels<kSize>, false>(rows, quads, lanes, first, sums);
}

void SumUnorms(const TexelSource& source, const FixedQuads& quads, size_t lanes, bool first, FixedSums* sums) {
  switch (source.channels) {
    case 1: return SumUnorm<1>(source, quads, lanes, first, sums);
    case 2: return SumUnorm<2>(source, quads, lanes, first, sums);
    default: return SumUnorm<4>(source, quads, lanes, first, sums);
  }
}

/// Bits that sums of 15-bit values drop for each quad, so that the sum of 64 quads fits into 32 bits.
constexpr int kDroppedBits = 6;

/// 15-bit values of codes: 1 is 32767 for sRGB, 255 * 128 for alpha.
constexpr float kLinearOne = 32767.0f * (kWeightOne >> kDroppedBits);
constexpr float kAlphaOne = 255.0f * 128.0f * (kWeightOne >> kDroppedBits);

template <size_t kSize>
HWY_INLINE void DecodeSrgb(uint32_t texel, uint16_t (&value)[4]) {
  for (size_t c = 0; c < 4; ++c) value[c] = 0;
  for (size_t c = 0; c < kSize && c < 3; ++c) value[c] = image::kSrgb8ToLinear15[texel >> (8 * c) & 255];
  if (kSize == 4) value[3] = static_cast<uint16_t>((texel >> 24) << 7);
}

/// Sum of the sRGB quads of one lookup, and whether its texels are equal.
struct SrgbSums {
  ChannelSums sum;
  uint32_t first, differing;

  template <class Rows>
  HWY_INLINE void add(const Rows& rows, const FixedQuad& quad, size_t lane, bool split, bool is_first) {
    ChannelSums blend = ChannelSums::zero();
    const int32_t weights[2] = {quad.upper_weights[lane], quad.lower_weights[lane]};
    const uint64_t texels[2] = {rows.row(quad.upper + lane, quad.upper_right + lane, split),
                                rows.row(quad.lower + lane, quad.lower_right + lane, split)};
    const bool has_right = (weights[0] | weights[1]) >> 16 != 0;
    constexpr size_t kSize = Rows::kTexelSize;
    constexpr uint64_t kMask = (uint64_t{1} << (8 * kSize)) - 1;
    for (size_t k = 0; k < 2; ++k) {
      const auto left = static_cast<uint32_t>(texels[k] & kMask);
      const auto right = static_cast<uint32_t>(texels[k] >> (8 * kSize) & kMask);
      if (is_first && k == 0) first = left;
      differing |= (left ^ first) | (has_right ? right ^ first : 0);
      uint16_t linear[2][4];
      DecodeSrgb<kSize>(left, linear[0]);
      DecodeSrgb<kSize>(right, linear[1]);
      blend.add(linear[0], linear[1], weights[k]);
    }
    sum.add(blend.shifted<kDroppedBits>());
  }
};

template <size_t kSize>
void SumSrgb(const TexelSource& source, const FixedQuads& quads, size_t lanes, bool first, FixedSums* sums) {
  const AnyTexels<kSize> rows = {source};
  const size_t step = quads.two_sums ? 1 : 2, averages = quads.two_sums ? 2 : 1;
  for (size_t lane = 0; lane < lanes; ++lane) {
    SrgbSums of[2];
    for (size_t a = 0; a < averages; ++a) {
      of[a] = first ? SrgbSums{ChannelSums::zero(), 0, 0}
                    : SrgbSums{ChannelSums::load(sums->sum[a][lane]), sums->first[a][lane], sums->differing[a][lane]};
    }
    const size_t end = 2 * static_cast<size_t>(quads.count[lane]);
    for (size_t at = 0; at < end; at += step) {
      of[at % 2].add(rows, quads.quad[at], lane, quads.split >> at & 1, first && at < 2);
    }
    for (size_t a = 0; a < averages; ++a) {
      of[a].sum.store(sums->sum[a][lane]);
      sums->first[a][lane] = of[a].first;
      sums->differing[a][lane] = of[a].differing;
    }
  }
}

void SumSrgbs(const TexelSource& source, const FixedQuads& quads, size_t lanes, bool first, FixedSums* sums) {
  switch (source.channels) {
    case 1: return SumSrgb<1>(source, quads, lanes, first, sums);
    case 2: return SumSrgb<2>(source, quads, lanes, first, sums);
    default: return SumSrgb<4>(source, quads, lanes, first, sums);
  }
}

/// 1 / (probes one) as the sum of two factors. The product of a sum of equal codes and `high` is exact, so that equal
/// codes give the correctly rounded quotient (test_fixed.cpp tries them all).
template <class D>
struct Quotient {
  hn::Vec<D> high, low;

  HWY_INLINE Quotient(D d, hn::Vec<D> probes, float one) {
    const hn::RebindToSigned<D> di;
    const auto divisor = probes * hn::Set(d, one);
    const auto reciprocal = hn::Set(d, 1.0f) / divisor;
    high = hn::BitCast(d, hn::BitCast(di, reciprocal) & hn::Set(di, -(1 << 14)));  // 10 bits
    low = (hn::Set(d, 1.0f) - high * divisor) * reciprocal;
  }
  HWY_INLINE hn::Vec<D> of(hn::Vec<D> sum) const { return sum * high + sum * low; }
};

/// Blends the sums of four channels of a vector of lookups.
template <class D>
HWY_INLINE void BlendSums(D d, const FixedSums& sums, const FixedAverage& average, hn::Vec<D> (&value)[4]) {
  const hn::RebindToSigned<D> di;
  Ints<D> sum[4];
  hn::LoadInterleaved4(di, &sums.sum[0][0][0], sum[0], sum[1], sum[2], sum[3]);
  for (size_t c = 0; c < 4; ++c) value[c] = hn::ConvertTo(d, sum[c]);
  if (!average.two_sums) return;
  const auto fraction = hn::Load(d, average.fraction);
  hn::LoadInterleaved4(di, &sums.sum[1][0][0], sum[0], sum[1], sum[2], sum[3]);
  for (size_t c = 0; c < 4; ++c) value[c] = value[c] + fraction * (hn::ConvertTo(d, sum[c]) - value[c]);
}

/// Writes up to `count` lanes.
template <class D>
HWY_INLINE void StoreLanes(D d, hn::Vec<D> value, size_t count, float* to) {
  if (HWY_LIKELY(count >= hn::Lanes(d))) return hn::StoreU(value, d, to);
  alignas(64) float lanes[hn::MaxLanes(D())];
  hn::Store(value, d, lanes);
  std::memcpy(to, lanes, count * sizeof(float));
}

void StoreUnorms(const FixedSums& sums, const FixedAverage& average, size_t count, const Texels& out) {
  const BatchTag d;
  hn::Vec<BatchTag> value[4];
  BlendSums(d, sums, average, value);
  const Quotient<BatchTag> quotient(d, hn::Load(d, average.probes), 255.0f * kWeightOne);
  for (size_t c = 0; c < 4; ++c) {
    if (out.channel[c]) StoreLanes(d, quotient.of(value[c]), count, out.channel[c]);
  }
}

/// Returns the bits of texels that differ within each lookup. A second sum with the share 0 does not count.
template <class D>
HWY_INLINE Ints<D> DifferingBits(D d, const FixedSums& sums, const FixedAverage& average) {
  const hn::RebindToSigned<D> di;
  const hn::RebindToUnsigned<D> du;
  const auto load = [&](const uint32_t* from) SHD_INLINE_LAMBDA { return hn::BitCast(di, hn::Load(du, from)); };
  const auto differing = load(sums.differing[0]);
  if (!average.two_sums) return differing;
  const auto second = load(sums.differing[1]) | (load(sums.first[0]) ^ load(sums.first[1]));
  const auto unused = hn::Eq(hn::Load(d, average.fraction), hn::Zero(d));
  return differing | hn::IfThenZeroElse(hn::RebindMask(di, unused), second);
}

void StoreSrgbs(const FixedSums& sums, const FixedAverage& average, size_t count, const Texels& out) {
  const BatchTag d;
  const hn::RebindToSigned<BatchTag> di;
  hn::Vec<BatchTag> value[4];
  BlendSums(d, sums, average, value);
  const auto probes = hn::Load(d, average.probes), one = hn::Set(d, 1.0f);
  const auto scale = one / (probes * hn::Set(d, kLinearOne));
  const auto differing = DifferingBits(d, sums, average);
  const auto texel = hn::BitCast(di, hn::Load(hn::RebindToUnsigned<BatchTag>(), sums.first[0]));
  const auto store = [&](size_t c, auto codes, auto differing_codes) SHD_INLINE_LAMBDA {
    if (!out.channel[c]) return;
    const auto byte = hn::Set(di, 255);
    const auto equal = hn::Eq(differing_codes & byte, hn::Zero(di));
    auto result = value[c] * scale;
    if (HWY_UNLIKELY(!hn::AllFalse(di, equal))) {
      const auto exact = hn::GatherIndex(d, image::kSrgb8ToLinear, codes & byte);
      result = hn::IfThenElse(hn::RebindMask(d, equal), exact, result);
    }
    StoreLanes(d, result, count, out.channel[c]);
  };
  store(0, texel, differing);
  store(1, hn::ShiftRight<8>(texel), hn::ShiftRight<8>(differing));
  store(2, hn::ShiftRight<16>(texel), hn::ShiftRight<16>(differing));
  if (out.channel[3]) StoreLanes(d, Quotient<BatchTag>(d, probes, kAlphaOne).of(value[3]), count, out.channel[3]);
}

}  // namespace

FixedKernels FixedOf(image::Component component) {
  switch (component) {
    case image::Component::kUnorm8: return {SumUnorms, StoreUnorms};
    case image::Component::kSrgb8: return {SumSrgbs, StoreSrgbs};
    default: return {nullptr, nullptr};
  }
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
