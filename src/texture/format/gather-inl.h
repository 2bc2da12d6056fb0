// SPDX-License-Identifier: MIT
// Loads of texels at an index per lane. A gather costs by the element, so neighbours are loaded together where the
// target has the instructions: a whole vector of points along a row by loads and permutations, the two texels of a row
// by one element of 8 bytes. Loads alone differ, so the bits are those of plain gathers.

#if defined(SHD_TEXTURE_GATHER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_GATHER_INL_H_
#undef SHD_TEXTURE_GATHER_INL_H_
#else
#define SHD_TEXTURE_GATHER_INL_H_
#endif

#include <cstring>

#include <hwy/highway.h>

#include "texture/store/storage.h"
#include "texture/store/wrap-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class D>
HWY_INLINE Ints<D> GatherWords(D, const uint8_t* texels, Ints<D> index) {
  const hn::RebindToSigned<D> di;
  return hn::GatherIndex(di, reinterpret_cast<const int32_t*>(texels), index);
}

/// Words at byte offsets of any alignment; up to 3 bytes behind the texel are read.
template <class D>
HWY_INLINE Ints<D> GatherBytes(D, const uint8_t* texels, Ints<D> offset) {
  const hn::RebindToSigned<D> di;
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

#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3
/// Words at index and index + 1.
template <class D>
HWY_INLINE void GatherWordPairs(D, const uint8_t* texels, Ints<D> index, Ints<D>* left, Ints<D>* right) {
  const hn::RebindToSigned<D> di;
  const hn::Half<decltype(di)> half;
  const hn::Repartition<int64_t, decltype(di)> wide;
  const auto offset = hn::ShiftLeft<2>(index);
  const auto* base = reinterpret_cast<const int64_t*>(texels);
  const auto low = hn::GatherOffset(wide, base, hn::PromoteTo(wide, hn::LowerHalf(half, offset)));
  const auto high = hn::GatherOffset(wide, base, hn::PromoteTo(wide, hn::UpperHalf(half, offset)));
  *left = hn::ConcatEven(di, hn::BitCast(di, high), hn::BitCast(di, low));
  *right = hn::ConcatOdd(di, hn::BitCast(di, high), hn::BitCast(di, low));
}

/// Words at first + index, index in 0..2 * lanes - 1, where `low` and `high` are the words from first on.
template <class D>
HWY_INLINE Ints<D> LookUpRow(D, Ints<D> low, Ints<D> high, Ints<D> index) {
  const hn::RebindToSigned<D> di;
  const auto lanes = hn::Set(di, static_cast<int32_t>(hn::Lanes(di)));
  const auto in_low = hn::Lt(index, lanes);
  const auto indices = hn::IndicesFromVec(di, hn::IfThenElse(in_low, index, index - lanes));
  return hn::IfThenElse(in_low, hn::TableLookupLanes(low, indices), hn::TableLookupLanes(high, indices));
}

/// Words at index and index + 1, if all lanes lie near each other.
template <class D>
HWY_INLINE bool LoadRow(D d, const uint8_t* texels, const int32_t* index, Ints<D>* left, Ints<D>* right) {
  const hn::RebindToSigned<D> di;
  const size_t lanes = hn::Lanes(di);
  const int32_t first = index[0] < index[lanes - 1] ? index[0] : index[lanes - 1];
  const auto from_first = hn::Load(di, index) - hn::Set(di, first), next = from_first + hn::Set(di, 1);
  const auto outside = hn::AndNot(hn::Set(di, static_cast<int32_t>(2 * lanes - 1)), from_first | next);
  if (!hn::AllTrue(di, hn::Eq(outside, hn::Zero(di)))) return false;
  const int32_t* words = reinterpret_cast<const int32_t*>(texels) + first;
  const auto low = hn::LoadU(di, words), high = hn::LoadU(di, words + lanes);
  *left = LookUpRow(d, low, high, from_first);
  *right = LookUpRow(d, low, high, next);
  return true;
}

/// Words at index and index + 1; the indices are aligned.
template <class D>
HWY_INLINE void LoadWordPairs(D d, const uint8_t* texels, const int32_t* index, Ints<D>* left, Ints<D>* right) {
  if (LoadRow(d, texels, index, left, right)) return;
  GatherWordPairs(d, texels, hn::Load(hn::RebindToSigned<D>(), index), left, right);
}
#else
/// Words at index and index + 1, by one load of 8 bytes a lane; the indices are aligned.
template <class D>
HWY_INLINE void LoadWordPairs(D, const uint8_t* texels, const int32_t* index, Ints<D>* left, Ints<D>* right) {
  const hn::RebindToSigned<D> di;
  constexpr size_t kLanes = hn::MaxLanes(hn::RebindToSigned<D>());
  alignas(64) int32_t pair[2 * kLanes];
  for (size_t k = 0; k < kLanes; ++k) {
    std::memcpy(pair + 2 * k, texels + size_t{4} * static_cast<uint32_t>(index[k]), 8);
  }
  hn::LoadInterleaved2(di, pair, *left, *right);
}
#endif

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_GATHER_INL_H_
