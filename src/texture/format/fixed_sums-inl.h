// SPDX-License-Identifier: MIT
// Sums of quads of 8-bit texels in fixed point. Lookups are summed one by one, by loads of two neighbouring texels, or
// together, if the quads of their vector lie in short pieces of rows. Both ways give the same sums.
//
// The sums of a vector of L lookups are stored as four vectors: channel c of lookup l lies at (l % 4) L + (l / 4) 4 +
// c. One transposition of blocks of 4 x 4 makes one vector of each channel of them.

#if defined(SHD_TEXTURE_FIXED_SUMS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_FIXED_SUMS_INL_H_
#undef SHD_TEXTURE_FIXED_SUMS_INL_H_
#else
#define SHD_TEXTURE_FIXED_SUMS_INL_H_
#endif

#include <cstring>

#include <hwy/highway.h>

#include "simd/integer-inl.h"
#include "simd/kernel_part.h"
#include "texture/format/fixed.h"
#include "texture/format/gather-inl.h"
#include "texture/lanes-inl.h"
#include "texture/stream.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::PairDot;

/// Returns the place of the first channel of a lookup in the sums of a vector.
HWY_INLINE size_t SumPlace(size_t lookup) {
  const size_t lanes = hn::Lanes(BatchTag());
  return lanes < 4 ? 4 * lookup : lookup % 4 * lanes + lookup / 4 * 4;
}

/// Loads sums as one vector of each channel.
template <class D>
HWY_INLINE void LoadSums(D, const int32_t* sums, Ints<D> (&channel)[4]) {
  const hn::RebindToSigned<D> di;
#if HWY_TARGET == HWY_SCALAR
  for (size_t c = 0; c < 4; ++c) channel[c] = hn::LoadU(di, sums + c);
#else
  const size_t lanes = hn::Lanes(di);
  const Ints<D> row[4] = {hn::Load(di, sums), hn::Load(di, sums + lanes), hn::Load(di, sums + 2 * lanes),
                          hn::Load(di, sums + 3 * lanes)};
  TransposeBlocks(row, channel);
#endif
}

/// The texels of a quad's rows, where all texels are in one block and each right one is next to its left one, or has
/// weight 0. Reads up to 15 bytes after a texel.
template <size_t kSize>
struct NextTexels {
  static constexpr size_t kTexelSize = kSize;
  const uint8_t* origin;

  HWY_INLINE const uint8_t* texel(const int32_t* index) const {
    return origin + size_t{static_cast<uint32_t>(*index)} * kSize;
  }
  /// Returns two texels, the left one in the low bytes.
  HWY_INLINE uint64_t row(const int32_t* left, const int32_t*, bool) const {
    uint64_t texels;
    std::memcpy(&texels, texel(left), sizeof texels);
    return texels;
  }
};

/// The texels of a quad's rows, where all texels are in one block.
template <size_t kSize>
struct BlockTexels {
  static constexpr size_t kTexelSize = kSize;
  const uint8_t* origin;

  HWY_INLINE uint64_t row(const int32_t* left, const int32_t* right, bool split) const {
    uint64_t texels, second = 0;
    std::memcpy(&texels, origin + size_t{static_cast<uint32_t>(*left)} * kSize, sizeof texels);
    if (HWY_LIKELY(!split)) return texels;
    std::memcpy(&second, origin + size_t{static_cast<uint32_t>(*right)} * kSize, kSize);
    return (texels & ((uint64_t{1} << (8 * kSize)) - 1)) | second << (8 * kSize);
  }
};

/// The texels of a quad's rows, wherever they are.
template <size_t kSize>
struct AnyTexels {
  static constexpr size_t kTexelSize = kSize;
  const TexelSource& source;

  HWY_INLINE uint64_t row(const int32_t* left, const int32_t* right, bool split) const {
    uint64_t first = 0, second = 0;
    const uint8_t* const texel = source.texel(static_cast<uint32_t>(*left));
    std::memcpy(&first, texel, kSize);
    std::memcpy(&second, split ? source.texel(static_cast<uint32_t>(*right)) : texel + kSize, kSize);
    return first | second << (8 * kSize);
  }
};

#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
/// Returns two texels of kSize bytes as 16-bit pairs of each channel, left and right, from a row in the low 8 bytes.
template <size_t kSize>
HWY_INLINE __m128i PairChannels(__m128i row) {
#if defined(HWY_SSE2) && HWY_TARGET == HWY_SSE2
  return _mm_unpacklo_epi8(_mm_unpacklo_epi8(row, _mm_srli_epi64(row, 8 * kSize)), _mm_setzero_si128());
#else
  constexpr char k = kSize;
  return _mm_shuffle_epi8(row, _mm_setr_epi8(0, -1, k, -1, 1, -1, k + 1, -1, 2, -1, k + 2, -1, 3, -1, k + 3, -1));
#endif
}

/// Sums of four channels of one lookup.
struct ChannelSums {
  __m128i sum;

  static HWY_INLINE ChannelSums zero() { return {_mm_setzero_si128()}; }
  static HWY_INLINE ChannelSums load(const int32_t* from) {
    return {_mm_load_si128(reinterpret_cast<const __m128i*>(from))};
  }
  HWY_INLINE void store(int32_t* to) const { _mm_store_si128(reinterpret_cast<__m128i*>(to), sum); }

  /// Adds two texels of kSize bytes by their weights, left | right << 16.
  template <size_t kSize>
  HWY_INLINE void add(uint64_t texels, int32_t weights) {
    const __m128i words = PairChannels<kSize>(_mm_set_epi64x(0, static_cast<int64_t>(texels)));
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

/// One lookup's elements of the columns of a quad.
struct LaneQuad {
  const int32_t* element;

  HWY_INLINE const int32_t* at(FixedColumn column) const { return element + column * hn::MaxLanes(BatchTag()); }
};

/// Adds quads of one lookup.
template <class Rows>
struct QuadSum {
  ChannelSums sum;

  static HWY_INLINE QuadSum begin(bool first, const int32_t* sums) {
    return {first ? ChannelSums::zero() : ChannelSums::load(sums)};
  }
  HWY_INLINE void add(const Rows& rows, const LaneQuad& quad, bool split) {
    const uint64_t upper = rows.row(quad.at(kUpper), quad.at(kUpperRight), split);
    const uint64_t lower = rows.row(quad.at(kLower), quad.at(kLowerRight), split);
    sum.template add<Rows::kTexelSize>(upper, *quad.at(kUpperWeights));
    sum.template add<Rows::kTexelSize>(lower, *quad.at(kLowerWeights));
  }
  HWY_INLINE void store(int32_t* sums) const { sum.store(sums); }
};

#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3
/// Both rows of a quad at once, one in each half of a vector.
template <size_t kSize>
struct QuadSum<NextTexels<kSize>> {
  __m256i sum;

  static HWY_INLINE QuadSum begin(bool first, const int32_t* sums) {
    return {first ? _mm256_setzero_si256() : _mm256_zextsi128_si256(ChannelSums::load(sums).sum)};
  }
  HWY_INLINE void add(const NextTexels<kSize>& rows, const LaneQuad& quad, bool) {
    const auto load = [](const uint8_t* from)
                          SHD_INLINE_LAMBDA { return _mm_loadu_si128(reinterpret_cast<const __m128i*>(from)); };
    const __m256i both = _mm256_inserti128_si256(_mm256_castsi128_si256(load(rows.texel(quad.at(kUpper)))),
                                                 load(rows.texel(quad.at(kLower))), 1);
    constexpr char k = kSize;
    const __m256i pairs =
        _mm256_broadcastsi128_si256(_mm_setr_epi8(0, -1, k, -1, 1, -1, k + 1, -1, 2, -1, k + 2, -1, 3, -1, k + 3, -1));
    const __m256i weights = _mm256_blend_epi32(_mm256_set1_epi32(*quad.at(kUpperWeights)),
                                               _mm256_set1_epi32(*quad.at(kLowerWeights)), 0xf0);
    sum = _mm256_add_epi32(sum, _mm256_madd_epi16(_mm256_shuffle_epi8(both, pairs), weights));
  }
  HWY_INLINE void store(int32_t* sums) const {
    ChannelSums{_mm_add_epi32(_mm256_castsi256_si128(sum), _mm256_extracti128_si256(sum, 1))}.store(sums);
  }
};
#endif

/// Elements of two quads, one of each sum.
constexpr size_t kRowStep = 2 * kFixedColumns * hn::MaxLanes(BatchTag());

/// Adds the quads of a vector of lookups, lookup by lookup.
template <class Rows, bool kTwoSums>
HWY_INLINE void SumLookups(const Rows& rows, FixedVector* vector) {
  for (size_t lane = 0; lane < hn::Lanes(BatchTag()); ++lane) {
    int32_t* const sum0 = vector->sum[0] + SumPlace(lane);
    int32_t* const sum1 = vector->sum[1] + SumPlace(lane);
    auto of0 = QuadSum<Rows>::begin(vector->first, sum0);
    auto of1 = QuadSum<Rows>::begin(vector->first || !kTwoSums, sum1);
    const int32_t* quad = vector->quads + lane;
    const int32_t* const end = quad + static_cast<size_t>(vector->count[lane]) * kRowStep;
    for (uint64_t split = vector->split; quad != end; quad += kRowStep, split >>= 2) {
      of0.add(rows, LaneQuad{quad}, split & 1);
      if (kTwoSums) of1.add(rows, LaneQuad{quad + kRowStep / 2}, split & 2);
    }
    of0.store(sum0);
    if (kTwoSums) of1.store(sum1);
  }
}

#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3
/// Sums of a vector of lookups as they are stored.
template <class D>
struct VectorSums {
  using V = Ints<D>;
  V row[4];

  HWY_INLINE VectorSums(D, bool first, const int32_t* sums) {
    const hn::RebindToSigned<D> di;
    for (size_t k = 0; k < 4; ++k) row[k] = first ? hn::Zero(di) : hn::Load(di, sums + k * hn::Lanes(di));
  }
  HWY_INLINE void store(D, int32_t* sums) const {
    const hn::RebindToSigned<D> di;
    for (size_t k = 0; k < 4; ++k) hn::Store(row[k], di, sums + k * hn::Lanes(di));
  }

  /// Adds a left and a right texel of each lookup by their weights.
  HWY_INLINE void add(D, V left, V right, V weights) {
    const hn::RebindToSigned<D> di;
    const hn::Repartition<uint8_t, D> bytes;
    const auto zero = hn::Zero(bytes), a = hn::BitCast(bytes, left), b = hn::BitCast(bytes, right);
    const auto low = hn::InterleaveLower(bytes, a, b), high = hn::InterleaveUpper(bytes, a, b);
    const auto words = [&](auto interleaved) SHD_INLINE_LAMBDA { return hn::BitCast(di, interleaved); };
    row[0] = row[0] + PairDot(words(hn::InterleaveLower(bytes, low, zero)), hn::Broadcast<0>(weights));
    row[1] = row[1] + PairDot(words(hn::InterleaveUpper(bytes, low, zero)), hn::Broadcast<1>(weights));
    row[2] = row[2] + PairDot(words(hn::InterleaveLower(bytes, high, zero)), hn::Broadcast<2>(weights));
    row[3] = row[3] + PairDot(words(hn::InterleaveUpper(bytes, high, zero)), hn::Broadcast<3>(weights));
  }
};

/// Adds a quad of each active lookup of a vector, texels of four bytes. Returns false, with nothing added, if the
/// texels do not lie in one short piece of an upper row and one of a lower row.
template <class D, class Mask>
HWY_INLINE bool AddWindow(D d, const uint8_t* texels, const int32_t* quad, Mask active, VectorSums<D>* sums) {
  const hn::RebindToSigned<D> di;
  const size_t lanes = hn::Lanes(d);
  const int32_t *const upper = quad + kUpper * lanes, *const lower = quad + kLower * lanes;
  const RowWindow<D> window = WindowOf<true>(d, upper);
  const int32_t down = lower[0] - upper[0];
  const auto apart = hn::Load(di, lower) - hn::Load(di, upper);
  if (HWY_UNLIKELY(!window.fits || !hn::AllTrue(di, hn::Eq(apart, hn::Set(di, down))))) return false;
  Ints<D> left, right;
  LoadWindow<true>(d, texels, window, window.first, &left, &right);
  sums->add(d, left, right, hn::IfThenElseZero(active, hn::Load(di, quad + kUpperWeights * lanes)));
  LoadWindow<true>(d, texels, window, window.first + down, &left, &right);
  sums->add(d, left, right, hn::IfThenElseZero(active, hn::Load(di, quad + kLowerWeights * lanes)));
  return true;
}

/// Adds the quads of texels of four bytes of a vector of lookups. Returns false, with nothing added, if some quad does
/// not fit.
template <bool kTwoSums>
HWY_INLINE bool SumWindows(const NextTexels<4>& rows, FixedVector* vector) {
  const BatchTag d;
  const hn::RebindToSigned<BatchTag> di;
  VectorSums<BatchTag> sum0(d, vector->first, vector->sum[0]), sum1(d, vector->first || !kTwoSums, vector->sum[1]);
  const auto count = hn::Load(di, vector->count);
  const int32_t* quad = vector->quads;
  for (size_t row = 0; row < vector->rows; ++row, quad += kRowStep) {
    const auto active = hn::Gt(count, hn::Set(di, static_cast<int32_t>(row)));
    if (!AddWindow(d, rows.origin, quad, active, &sum0)) return false;
    if (kTwoSums && !AddWindow(d, rows.origin, quad + kRowStep / 2, active, &sum1)) return false;
  }
  sum0.store(d, vector->sum[0]);
  if (kTwoSums) sum1.store(d, vector->sum[1]);
  return true;
}
#else
template <bool kTwoSums>
HWY_INLINE bool SumWindows(const NextTexels<4>&, FixedVector*) {
  return false;
}
#endif

/// Adds the quads of a vector of lookups.
template <size_t kSize, bool kTwoSums>
HWY_INLINE void SumQuads(const TexelSource& source, FixedVector* vector) {
  if (HWY_UNLIKELY(source.borrowed)) return SumLookups<AnyTexels<kSize>, kTwoSums>({source}, vector);
  if (HWY_UNLIKELY(vector->split != 0)) return SumLookups<BlockTexels<kSize>, kTwoSums>({source.origin}, vector);
  const NextTexels<kSize> rows = {source.origin};
  if constexpr (kSize == 4) {
    if (SumWindows<kTwoSums>(rows, vector)) return;
  }
  SumLookups<NextTexels<kSize>, kTwoSums>(rows, vector);
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_FIXED_SUMS_INL_H_
