// SPDX-License-Identifier: MIT
// Loads of 32-bit words at an index per lane. A gather costs by the element, so neighbours are loaded together where
// the target has the instructions: a whole vector of points along two rows by loads and permutations, the two texels
// of a row by one element of 8 bytes. Loads alone differ, so the bits are those of plain gathers.
//
// RGBA8 trilinear, perspective floor along the rows of a 2048 x 2048 texture, one thread of a Zen 5, in millions of
// lookups a second: plain gathers 112 (AVX-512) and 75 (AVX2), pairs 115 and 80, rows 158 and 86; rows by byte
// shuffles were slower than scalar loads on SSE4. With textures that stay in cache pairs give 189 and 113.

#if defined(SHD_TEXTURE_GATHER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_GATHER_INL_H_
#undef SHD_TEXTURE_GATHER_INL_H_
#else
#define SHD_TEXTURE_GATHER_INL_H_
#endif

#include <cstring>

#include <hwy/highway.h>

#include "texture/storage.h"
#include "texture/wrap-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class D>
HWY_INLINE Ints<D> GatherWords(D d, const uint8_t* texels, Ints<D> index) {
  const hn::RebindToSigned<D> di;
  (void)d;
  return hn::GatherIndex(di, reinterpret_cast<const int32_t*>(texels), index);
}

/// Words at byte offsets of any alignment; up to 3 bytes behind the texel are read.
template <class D>
HWY_INLINE Ints<D> GatherBytes(D d, const uint8_t* texels, Ints<D> offset) {
  const hn::RebindToSigned<D> di;
  (void)d;
  return hn::GatherOffset(di, reinterpret_cast<const int32_t*>(texels), offset);
}

/// What the texels at indices are indexed from: all in one block, or null where some are borrowed and some are not.
template <class D>
HWY_INLINE const uint8_t* TexelsOf(D, const Texture& texture, Ints<D> index) {
  if (HWY_LIKELY(!texture.borrowed)) return texture.origin;
  const hn::RebindToSigned<D> di;
  const auto borrowed = hn::Lt(index, hn::Set(di, static_cast<int32_t>(texture.borrowed_texels)));
  if (hn::AllTrue(di, borrowed)) return texture.borrowed;
  return hn::AllFalse(di, borrowed) ? texture.origin : nullptr;
}

/// Words `byte` bytes into texels that are not all in one block. Few vectors have lanes on level 0 and on others.
template <class D>
HWY_NOINLINE Ints<D> GatherApart(D, const Texture& texture, Ints<D> index, size_t byte) {
  const hn::RebindToSigned<D> di;
  alignas(64) int32_t word[hn::MaxLanes(di)];
  hn::Store(index, di, word);
  for (size_t k = 0; k < hn::Lanes(di); ++k) {
    const uint8_t* texel = texel_at(texture, static_cast<uint32_t>(word[k])) + byte;
    std::memcpy(&word[k], texel, sizeof word[k]);
  }
  return hn::Load(di, word);
}

#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
constexpr bool kGathersNeighbours = true;

/// Words at index and index + 1.
template <class D>
HWY_INLINE void GatherWordPairs(D d, const uint8_t* texels, Ints<D> index, Ints<D>* left, Ints<D>* right) {
  const hn::RebindToSigned<D> di;
  const hn::Half<decltype(di)> half;
  const hn::Repartition<int64_t, decltype(di)> wide;
  const auto offset = hn::ShiftLeft<2>(index);
  const auto* base = reinterpret_cast<const int64_t*>(texels);
  const auto low = hn::GatherOffset(wide, base, hn::PromoteTo(wide, hn::LowerHalf(half, offset)));
  const auto high = hn::GatherOffset(wide, base, hn::PromoteTo(wide, hn::UpperHalf(half, offset)));
  *left = hn::ConcatEven(di, hn::BitCast(di, high), hn::BitCast(di, low));
  *right = hn::ConcatOdd(di, hn::BitCast(di, high), hn::BitCast(di, low));
  (void)d;
}

/// Words at first + index, index in 0..2 * lanes - 1, where `first` is one row's.
template <class D>
HWY_INLINE Ints<D> LookUpRow(D, Ints<D> low, Ints<D> high, Ints<D> index) {
  const hn::RebindToSigned<D> di;
  const auto lanes = hn::Set(di, static_cast<int32_t>(hn::Lanes(di)));
  const auto in_low = hn::Lt(index, lanes);
  const auto indices = hn::IndicesFromVec(di, hn::IfThenElse(in_low, index, hn::Sub(index, lanes)));
  return hn::IfThenElse(in_low, hn::TableLookupLanes(low, indices), hn::TableLookupLanes(high, indices));
}

/// The words of both taps in two rows, if all lanes lie near each other in the same two rows.
template <class D>
HWY_INLINE bool FetchRows(D d, const uint8_t* texels, Ints<D> top, Ints<D> bottom, Ints<D> left, Ints<D>* t00,
                          Ints<D>* t10, Ints<D>* t01, Ints<D>* t11) {
  const hn::RebindToSigned<D> di;
  const size_t lanes = hn::Lanes(di);
  const int32_t row = hn::GetLane(top), next_row = hn::GetLane(bottom);
  const int32_t begin = hn::GetLane(left), end = hn::ExtractLane(left, lanes - 1);
  const int32_t first = begin < end ? begin : end;
  const auto index = hn::Sub(left, hn::Set(di, first));
  const auto limit = hn::Set(di, static_cast<int32_t>(2 * lanes - 1));
  const auto near = hn::And(hn::Gt(index, hn::Set(di, -1)), hn::Lt(index, limit));
  const auto same = hn::And(hn::Eq(top, hn::Set(di, row)), hn::Eq(bottom, hn::Set(di, next_row)));
  if (!hn::AllTrue(di, hn::And(near, same))) return false;
  const auto* words = reinterpret_cast<const int32_t*>(texels);
  const int32_t* above = words + row + first;
  const int32_t* below = words + next_row + first;
  const auto right = hn::Add(index, hn::Set(di, 1));
  const auto above_low = hn::LoadU(di, above), above_high = hn::LoadU(di, above + lanes);
  const auto below_low = hn::LoadU(di, below), below_high = hn::LoadU(di, below + lanes);
  *t00 = LookUpRow(d, above_low, above_high, index);
  *t10 = LookUpRow(d, above_low, above_high, right);
  *t01 = LookUpRow(d, below_low, below_high, index);
  *t11 = LookUpRow(d, below_low, below_high, right);
  return true;
}

/// The words at `left` and `left` + 1 of two rows, whose first words are at `top` and `bottom`.
template <class D>
HWY_INLINE void GatherNeighbours(D d, const uint8_t* texels, Ints<D> top, Ints<D> bottom, Ints<D> left, Ints<D>* t00,
                                 Ints<D>* t10, Ints<D>* t01, Ints<D>* t11) {
  if (FetchRows(d, texels, top, bottom, left, t00, t10, t01, t11)) return;
  GatherWordPairs(d, texels, hn::Add(top, left), t00, t10);
  GatherWordPairs(d, texels, hn::Add(bottom, left), t01, t11);
}
#else
constexpr bool kGathersNeighbours = false;
#endif

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_GATHER_INL_H_
